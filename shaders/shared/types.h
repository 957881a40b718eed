// Lets a struct be written once for C++ and GLSL. Both sides use scalar layout: members follow each other as
// in C.
#ifndef PLUME_SHARED_TYPES_H
#define PLUME_SHARED_TYPES_H

#ifdef __cplusplus
#include <cstdint>
#include <glm/glm.hpp>
#define PLUME_SHARED_BEGIN namespace plume::shared {
#define PLUME_SHARED_END }
namespace plume::shared {
using glm::mat4;
using glm::uvec2;
using glm::uvec3;
using glm::vec2;
using glm::vec3;
using glm::vec4;
using uint = uint32_t;
}  // namespace plume::shared
#else
#extension GL_EXT_scalar_block_layout : require
#define PLUME_SHARED_BEGIN
#define PLUME_SHARED_END
#endif

#endif
