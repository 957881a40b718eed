// The driver's pipelines in the user's cache folder. Nothing depends on them but time: what cannot be read,
// is not whole or is another driver's is made again, and what cannot be written is told and done without.
#ifndef PLUME_COMMANDS_KEPT_PIPELINES_H
#define PLUME_COMMANDS_KEPT_PIPELINES_H

#include "renderer/gpu/pipelines.h"
#include "sandbox/commands/user_folders.h"

namespace plume {

class KeptPipelines {
 public:
  /// Reads what an earlier run left for this device; there is nothing to read or write without a folder.
  KeptPipelines(const gpu::Device& device, const std::optional<std::filesystem::path>& folder);

  const std::vector<uint8_t>& bytes() const { return bytes_; }
  /// Writes what there is now, if it is other than what was read. Other processes may do the same: the file
  /// is always that of one of them. Throws FileError.
  void keep(const gpu::PipelineCache& cache);
  const std::filesystem::path& file() const { return file_; }

 private:
  std::filesystem::path file_;  // "": nothing is kept
  std::vector<uint8_t> bytes_;
};

}  // namespace plume
#endif
