// Where panels stand before the user moves them.
#ifndef PLUME_DEBUGGER_PANEL_PLACE_H
#define PLUME_DEBUGGER_PANEL_PLACE_H

namespace plume {

/// Called inside a panel: puts it so many pixels from the left (negative: its left edge from the window's
/// right) and from the top when it is new, and again when the window's size has changed, which may have left
/// it out of reach.
void place_panel(float x, float y);

}  // namespace plume
#endif
