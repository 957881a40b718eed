// One self-contained HTML page about a run: what accuracy costs in time, in charts, a table and pictures.
// Opens from disk without a network; sandbox/report/page/ is what it looks like.
#ifndef PLUME_REPORT_REPORT_H
#define PLUME_REPORT_REPORT_H

#include <filesystem>

#include "sandbox/runs/results.h"

namespace plume {

/// Embeds the pictures that stand beside `path`. Where the page would be larger than `most_bytes` they are
/// halved in width and height until it is not; those that still do not fit are left out. The page says so.
/// Throws FileError when the page cannot be written or a picture cannot be read.
void write_report(const std::filesystem::path& path, const Results& results, uint64_t most_bytes = 64 << 20);

}  // namespace plume
#endif
