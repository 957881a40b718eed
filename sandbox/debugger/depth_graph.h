// Transmittance over depth at one pixel: the exact step function, methods' curves, and what lies where. What
// differs, differs in shape or label too, not in colour alone:
//   exact          thick solid steps
//   methods        thin lines, each with a dash and a marker of its own
//   fragments      triangles on the depth axis
//   slices         boxes along the upper edge, those of the first method that has slices
//   opaque         a line with hatching behind it
//   zero, overflow labelled lines with a triangle, with a diamond
#ifndef PLUME_DEBUGGER_DEPTH_GRAPH_H
#define PLUME_DEBUGGER_DEPTH_GRAPH_H

#include "sandbox/debugger/interface.h"
#include "sandbox/measure/pixel_probe.h"

namespace plume {

/// Drawn into `area` of the present window. Where the pointer is in it, the values at that depth are shown.
void draw_depth_graph(const PixelProbe& probe, const DepthGraph& graph, Area area);

}  // namespace plume
#endif
