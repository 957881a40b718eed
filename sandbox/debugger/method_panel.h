// Which method draws, and its parameters.
#ifndef PLUME_DEBUGGER_METHOD_PANEL_H
#define PLUME_DEBUGGER_METHOD_PANEL_H

#include <span>

#include "renderer/frame.h"

namespace plume {

/// `current` is an index into `methods`; those the device cannot run are listed with what they need.
/// True when the picture must be drawn anew.
bool method_panel(const gpu::Device& device, std::span<const MethodInstance> methods, size_t& current);

}  // namespace plume
#endif
