// SPIR-V by name: the modules embedded at build time, or GLSL read from a folder for reloading.
#ifndef PLUME_GPU_SHADERS_H
#define PLUME_GPU_SHADERS_H

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace plume::gpu {

struct EmbeddedShader {
  const char* name;  ///< path below shaders/, such as "methods/wboit/draw.frag"
  const uint32_t* words;
  size_t count;
};

/// Written by the build from every stage file below shaders/.
std::span<const EmbeddedShader> embedded_shaders();

class Shaders {
 public:
  /// `folder` empty: the embedded modules. Otherwise GLSL is compiled from that copy of shaders/.
  explicit Shaders(std::filesystem::path folder = {}) : folder_(std::move(folder)) {}

  /// Throws ShaderError that names the shader and holds the compiler's message, or the nearest valid name.
  std::vector<uint32_t> load(std::string_view name) const;

 private:
  std::filesystem::path folder_;
};

}  // namespace plume::gpu
#endif
