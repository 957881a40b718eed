#include "sandbox/workspace/view_words.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace plume {
namespace {

std::string metres(const DepthSlice& slice) {
  return fmt::format("{:.4g} to {:.4g} m", slice.near_m, slice.far_m);
}

std::string column_words(const Inspected& seen, int x) {
  const size_t used = seen.slices.size();
  if (used == 0) return "no slice is in use";
  const size_t physical = std::min(size_t(x) * used / size_t(seen.values.width), used - 1);
  const DepthSlice& slice = seen.slices[physical];
  return fmt::format("physical slice {} of {} is virtual slice {}\n{}", physical, used, slice.virtual_slice,
                     metres(slice));
}

}  // namespace

std::string view_title(const Inspection& view) {
  return view.unit.empty() ? view.title : fmt::format("{}, {}", view.title, view.unit);
}

std::string slice_words(const Inspected& seen) {
  if (seen.what.slices == 0) return "";
  if (seen.slice >= seen.slices.size())
    return fmt::format("slice {}: not in use, {} are", seen.slice, seen.slices.size());
  const DepthSlice& slice = seen.slices[seen.slice];
  return fmt::format("slice {} of {}: {}, virtual slice {}", seen.slice, seen.slices.size(), metres(slice),
                     slice.virtual_slice);
}

std::string scale_words(const SideView& view) {
  const char* const why = view.range == SideView::Range::kHeld                              ? "held"
                          : view.range == SideView::Range::kWhole && view.shown->what.range ? "all it can be"
                          : view.shares_scale ? "what is in both pictures"
                                              : "what is in this picture";
  return fmt::format("{}, {:.3g} to {:.3g}: {}", view.scale.logarithmic ? "log" : "linear", view.scale.low,
                     view.scale.high, why);
}

std::string bar_number(const SideView& view, float share) {
  const float number = view.scale.value_at(share);
  const bool less = share == 0.0f && view.found.count > 0 && view.found.least < view.scale.low;
  const bool more = share == 1.0f && view.found.count > 0 && view.found.most > view.scale.high;
  return fmt::format("{}{:.3g}", less ? "<=" : more ? ">=" : "", number);
}

std::string pixel_words(const Inspected& seen, int x, int y) {
  const Inspection& what = seen.what;
  if (what.over_slices) return column_words(seen, x);
  const float value = seen.values.at(x, y);
  if (std::isnan(value)) return what.absent;
  if (!what.classes.empty()) {
    const auto index = size_t(std::max(value, 1.0f)) - 1;
    return what.classes[std::min(index, what.classes.size() - 1)];
  }
  if (std::isinf(value)) return "infinite";
  return fmt::format("{:.4g} {}", value, what.unit);
}

}  // namespace plume
