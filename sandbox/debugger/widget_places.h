// Where widgets stand in the window, for tests that click on them: with PLUME_WIDGET_PLACES=FILE in the
// environment, the file has a line "left top right bottom name" for each that has a name, in screen
// coordinates. Without, nothing is kept.
#ifndef PLUME_DEBUGGER_WIDGET_PLACES_H
#define PLUME_DEBUGGER_WIDGET_PLACES_H

#include <string_view>

namespace plume {

/// Names the last widget.
void name_widget(std::string_view name);
/// Once all of them are described.
void write_widget_places();

}  // namespace plume
#endif
