// Small things that several panels draw.
#ifndef PLUME_DEBUGGER_WIDGETS_H
#define PLUME_DEBUGGER_WIDGETS_H

#include <string>
#include <string_view>

namespace plume {

/// Of the last widget, also when that is disabled.
void tooltip(std::string_view text);
void text(const std::string& text);
/// Wrapped, and less bright.
void note(const std::string& text);
/// The next column of a table.
void cell(const std::string& text);

}  // namespace plume
#endif
