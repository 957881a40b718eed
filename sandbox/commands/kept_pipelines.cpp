#include "sandbox/commands/kept_pipelines.h"

#include "sandbox/measure/file_bytes.h"

namespace plume {
namespace fs = std::filesystem;
namespace {

constexpr uintmax_t kMostBytes = 1u << 30;  // no driver has as much; a link to a device never ends

}  // namespace

KeptPipelines::KeptPipelines(const gpu::Device& device, const std::optional<fs::path>& folder) {
  if (!folder) return;
  file_ = *folder / gpu::PipelineCache::file_name(device);
  std::error_code absent;
  if (!fs::is_regular_file(file_, absent) || fs::file_size(file_, absent) > kMostBytes) return;
  try {
    bytes_ = read_file(file_);
  } catch (const FileError&) {  // as if it were not there
  }
}

void KeptPipelines::keep(const gpu::PipelineCache& cache) {
  if (file_.empty()) return;
  std::vector<uint8_t> now = cache.bytes();
  if (now == bytes_) return;
  make_folder(file_.parent_path());
  remove_abandoned(file_.parent_path());
  write_file(file_, now);
  bytes_ = std::move(now);
}

}  // namespace plume
