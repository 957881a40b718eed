// Tells when a file's content is no longer what it was, by looking: a poll asks for the time of change and
// the size, and reads the file only when these are new, or so young that a second change could hide behind
// the same time stamp.
#ifndef PLUME_PRESETS_FILE_WATCH_H
#define PLUME_PRESETS_FILE_WATCH_H

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace plume {

class FileWatch {
 public:
  /// Watches for contents other than `known`, which need not be what the file has now.
  FileWatch(std::filesystem::path path, std::string_view known);

  enum class News { kNone, kChanged, kGone };
  /// Each change once; contents that came back to what was known are none. kGone also for what cannot be
  /// read.
  News poll();
  /// The contents that the last kChanged told of.
  const std::string& contents() const { return contents_; }
  /// What was written by us is no news.
  void know(std::string_view contents);

 private:
  struct Stamp {
    std::filesystem::file_time_type time;
    uintmax_t size;
    bool operator==(const Stamp&) const = default;
  };
  std::optional<Stamp> stamp() const;

  std::filesystem::path path_;
  std::optional<Stamp> seen_;  // by the last poll that read the file
  bool settled_ = false;       // the file was older than a time stamp's grain then
  bool gone_ = false;
  uint64_t known_;  // hash
  std::string contents_;
};

}  // namespace plume
#endif
