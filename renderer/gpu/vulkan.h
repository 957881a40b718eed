// The one place that includes Vulkan, so that every file sees it with the same switches. Heavy: precompiled
// by the build.
#ifndef PLUME_GPU_VULKAN_H
#define PLUME_GPU_VULKAN_H

#define VULKAN_HPP_NO_CONSTRUCTORS
#include <vulkan/vulkan_raii.hpp>

#endif
