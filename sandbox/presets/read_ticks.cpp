#include "sandbox/presets/read_ticks.h"

#include <fmt/format.h>

#include "sandbox/presets/read_scene.h"

namespace plume {

void read_ticks(TableReader& top, std::vector<uint32_t>& ticks, Need need, uint32_t at_most) {
  if (!top.is_table("ticks")) {
    top.ascending("ticks", ticks, kTick, 1);
    if (need == Need::kRequired && !top.has("ticks"))
      top.report("ticks", "missing key `ticks`, expected a list of ticks or { first, last, step }");
    return;
  }
  top.table("ticks", [&](TableReader& table) {
    uint32_t first = 0, last = 0, step = 1;
    bool read = table.integer("first", first, kTick, Need::kRequired);
    read &= table.integer("last", last, kTick, Need::kRequired);
    table.integer("step", step, {1, kTick.max, kTick.unit});
    if (read && last < first)
      table.report("last", fmt::format("`last` is {}, expected at least `first`, {}", last, first));
    else if (const uint32_t count = (last - first) / step + 1; read && count > at_most)
      table.report("last",
                   fmt::format("{} ticks are played, expected at most {}: raise `step`", count, at_most));
    else if (read)
      for (uint32_t tick = first; tick <= last; tick += step) ticks.push_back(tick);
  });
}

}  // namespace plume
