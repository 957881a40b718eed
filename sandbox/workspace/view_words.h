// What a view says in words: its key, and a pixel of it.
#ifndef PLUME_WORKSPACE_VIEW_WORDS_H
#define PLUME_WORKSPACE_VIEW_WORDS_H

#include <string>

#include "sandbox/workspace/side_view.h"

namespace plume {

/// "Overdraw, fragments".
std::string view_title(const Inspection& view);
/// "slice 40 of 57: 8.1 to 8.3 m, virtual slice 140"; "" where there are none to choose.
std::string slice_words(const Inspected& seen);
/// Which numbers the colours stand for, and why these: "log, 6.85 to 12.6: what is in this picture".
std::string scale_words(const SideView& view);
/// At a place of the bar. What lies beyond its ends has their colours: ">=12.6" where there is more.
std::string bar_number(const SideView& view, float share);
/// "34 fragments", "2: RGB sources", "no overflow". Of a chart over slices, what the column is.
std::string pixel_words(const Inspected& seen, int x, int y);

}  // namespace plume
#endif
