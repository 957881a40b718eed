// Which descriptors a SPIR-V module uses, by name: so that passes bind "cards" and not binding 3, and a
// missing one has a name.
#ifndef PLUME_GPU_REFLECTION_H
#define PLUME_GPU_REFLECTION_H

#include <span>
#include <string>
#include <vector>

#include "renderer/gpu/vulkan.h"

namespace plume::gpu {

struct ShaderBinding {
  std::string name;  ///< of the block (buffers) or of the variable (images)
  uint32_t binding;
  vk::DescriptorType type;
};

/// Descriptors of set 0, in the order of their declaration. Follows the SPIR-V specification 1.6,
/// sections 2.3 and 3. Throws ShaderError for words that are not a module.
std::vector<ShaderBinding> reflect(std::span<const uint32_t> words);

}  // namespace plume::gpu
#endif
