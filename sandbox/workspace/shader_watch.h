// Tells when shaders on disk are no longer what they were, by looking at names, sizes and times of change.
#ifndef PLUME_WORKSPACE_SHADER_WATCH_H
#define PLUME_WORKSPACE_SHADER_WATCH_H

#include <cstdint>
#include <filesystem>

namespace plume {

class ShaderWatch {
 public:
  /// Of a folder and all below it; "": of the embedded shaders, which stay.
  explicit ShaderWatch(std::filesystem::path folder);

  /// Whether somebody has changed them since the last time, and is done with that.
  bool poll(double now_s);

 private:
  uint64_t look() const;

  std::filesystem::path folder_;
  uint64_t known_, seen_;
  double next_s_ = 0;
};

}  // namespace plume
#endif
