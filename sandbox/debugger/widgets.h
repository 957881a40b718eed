// Small things that several panels draw.
#ifndef PLUME_DEBUGGER_WIDGETS_H
#define PLUME_DEBUGGER_WIDGETS_H

#include <string>
#include <string_view>

namespace plume {

/// Of the last widget, also when that is disabled.
void tooltip(std::string_view text);
/// Whether it would be shown: for texts that take a while to make.
bool wants_tooltip();
void text(const std::string& text);
/// Wrapped, and less bright.
void note(const std::string& text);
/// Wrapped, with a bar at the side, so that it is told from what is said by the way.
void warning(const std::string& words, const char* name = "warning");
/// A window in the middle that has to be answered, once ImGui::OpenPopup(`title`) was called; where this is
/// true, ImGui::EndPopup() ends it.
bool begin_question(const char* title);
/// Whether a key that answers a question was pressed.
bool pressed_escape();
bool pressed_enter();
/// What ImGui's sliders are told to write: a number as `digits` says ("%.4g"), and its unit.
std::string number_format(std::string_view digits, std::string_view unit);
/// "0 .. 1", with the unit, for tooltips.
std::string limits_text(double min, double max, std::string_view unit);
/// The next column of a table.
void cell(const std::string& text);

}  // namespace plume
#endif
