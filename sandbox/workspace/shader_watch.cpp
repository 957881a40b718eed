#include "sandbox/workspace/shader_watch.h"

#include <fmt/format.h>

#include <functional>
#include <utility>

namespace plume {
namespace fs = std::filesystem;
namespace {

constexpr double kPollSeconds = 0.25;

}  // namespace

ShaderWatch::ShaderWatch(fs::path folder) : folder_(std::move(folder)), known_(look()), seen_(known_) {}

bool ShaderWatch::poll(double now_s) {
  if (folder_.empty() || now_s < next_s_) return false;
  next_s_ = now_s + kPollSeconds;
  const uint64_t now = look();
  const bool rests = std::exchange(seen_, now) == now;
  return rests && std::exchange(known_, now) != now;
}

/// Of any order of files. What is gone while it is looked at is gone.
uint64_t ShaderWatch::look() const {
  uint64_t sum = 0;
  std::error_code gone;
  for (auto file = fs::recursive_directory_iterator(folder_, gone); file != fs::end(file);
       file.increment(gone)) {
    if (!file->is_regular_file(gone)) continue;
    const auto time = file->last_write_time(gone).time_since_epoch().count();
    sum +=
        std::hash<std::string>()(fmt::format("{} {} {}", file->path().string(), file->file_size(gone), time));
  }
  return sum;
}

}  // namespace plume
