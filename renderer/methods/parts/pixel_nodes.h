// A fixed number of nodes for each pixel, which fragments enter in turn: what k-buffers, multi-layer alpha
// blending and adaptive transparency keep. Shaders are in shaders/methods/parts/pixel_nodes/.
#ifndef PLUME_METHODS_PIXEL_NODES_H
#define PLUME_METHODS_PIXEL_NODES_H

#include "renderer/methods/method.h"
#include "shaders/methods/parts/pixel_nodes/pixel_nodes.h"

namespace plume::pixel_nodes {

/// What keeps fragments of one pixel apart while one is at work.
enum class Lock { kSpinlock, kInterlock };
constexpr std::string_view kLocks[] = {"spinlock", "interlock"};
/// Names of what the device lacks for it.
std::vector<std::string> missing(const gpu::Device& device, Lock lock);
/// A folder's shader of that lock: "insert_spinlock.frag", "insert_interlock.frag".
std::string insert_shader(const std::string& folder, Lock lock);

struct Kind {
  bool light = true;        ///< kept beside the transmittance
  bool empty_keys = false;  ///< keys are behind all others before the frame
};
/// Buffers `turns`, `arrays`, `keys`, `through`, `light` and `overflow`: 4 bytes a pixel and 20 a node, or 32
/// with light.
void add_needs(Needs& needs, glm::uvec2 size, uint32_t nodes, const Kind& kind);
/// Tells the shaders where the nodes are; a barrier must follow.
void reset(gpu::Pass& pass, const Resources& resources, const Kind& kind);
/// What the shader files bind.
gpu::Bindings bindings(const Resources& resources);
/// Draws all cards at the picture's resolution with `style`'s shader and targets, which may use the nodes.
void draw(gpu::Pass& pass, const Picture& picture, uint32_t nodes, Transparents::Style style);
/// What did not get a node of its own in the last frame. Waits for the device.
shared::NodeOverflow overflow(gpu::Device& device, const Resources& resources);

}  // namespace plume::pixel_nodes
#endif
