// Where widgets stand in the window, for tests that click on them: with PLUME_WIDGET_PLACES=FILE in the
// environment, the file has a line "left top right bottom name" for each that has a name, in screen
// coordinates. Where a state is of interest the name goes on with it: "tick = 40". The last line, "0 0 0 0
// frame = 7", counts how often the panels were described: what came before is known by then. Without, nothing
// is kept.
#ifndef PLUME_DEBUGGER_WIDGET_PLACES_H
#define PLUME_DEBUGGER_WIDGET_PLACES_H

#include <glm/glm.hpp>
#include <string_view>

namespace plume {

/// Names the last widget.
void name_widget(std::string_view name);
/// Names what is no widget, or a point that can be clicked on.
void name_place(std::string_view name, glm::vec2 corner, glm::vec2 size = {0, 0});
/// Once all of them are described.
void write_widget_places();

}  // namespace plume
#endif
