// The pictures of a report, small enough to be part of one page.
#ifndef PLUME_REPORT_PICTURES_H
#define PLUME_REPORT_PICTURES_H

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "sandbox/runs/results.h"

namespace plume {

struct PagePicture {
  std::string file;    ///< name beside the page
  std::string base64;  ///< empty: left out
};

struct PagePictures {
  std::vector<PagePicture> all;
  int divisor = 1;         ///< of width and height; 1: the PNG files themselves, otherwise WebP
  size_t left_out = 0;     ///< for want of room
  uint64_t bytes() const;  ///< of base64
};

/// Files of a report: pictures before error maps, and the first of each moment before the second of any:
/// where room is short it is the maps that are left out, and no moment goes without.
std::vector<std::string> picture_files(const Results& results);

/// Those of `files` that are in `folder`. Halved, at least to some 160 pixels across, and compressed with
/// loss until their base64 has no more than `most_bytes`; the last ones are left out when that is not enough.
PagePictures page_pictures(const std::filesystem::path& folder, const std::vector<std::string>& files,
                           uint64_t most_bytes);

}  // namespace plume
#endif
