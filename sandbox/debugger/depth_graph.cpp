#include "sandbox/debugger/depth_graph.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>

namespace plume {
namespace {

constexpr ImU32 kGround = IM_COL32(18, 18, 20, 255), kGrid = IM_COL32(62, 62, 68, 255),
                kInk = IM_COL32(205, 205, 210, 255), kExact = IM_COL32(255, 255, 255, 255),
                kFaint = IM_COL32(140, 140, 150, 255);
constexpr std::array kChannelInk{IM_COL32(255, 105, 95, 255), IM_COL32(105, 225, 105, 255),
                                 IM_COL32(120, 160, 255, 255)};
constexpr std::array kChannelNames{"R", "G", "B"};
constexpr float kHighest = 4;  // weights of blends without depth may exceed 1, by any factor

/// Of a method's curve: on, off, on, off, in pixels; all zero: solid.
struct Style {
  ImU32 ink;
  std::array<float, 4> dash;
  int marker_sides;  ///< of a polygon
};
constexpr std::array kStyles{Style{IM_COL32(255, 175, 60, 255), {0, 0, 0, 0}, 12},
                             Style{IM_COL32(90, 210, 255, 255), {7, 4, 7, 4}, 4},
                             Style{IM_COL32(230, 130, 255, 255), {2, 3, 2, 3}, 3},
                             Style{IM_COL32(160, 235, 120, 255), {9, 3, 2, 3}, 5},
                             Style{IM_COL32(255, 240, 120, 255), {12, 5, 3, 5}, 6}};

/// What a curve is drawn of: a channel, or the mean of all.
struct Reading {
  int channel = -1;
  float of(glm::vec3 t) const { return channel < 0 ? (t.r + t.g + t.b) / 3 : t[channel]; }
};

/// From depth and transmittance to the screen.
struct Plot {
  ImVec2 low, high;  // upper left, lower right
  double nearest, farthest;
  bool logarithmic;
  float top;

  bool holds(double depth) const { return depth >= nearest && depth <= farthest; }
  float x(double depth) const {
    const double share = logarithmic ? std::log(depth / nearest) / std::log(farthest / nearest)
                                     : (depth - nearest) / (farthest - nearest);
    return low.x + float(std::clamp(share, 0.0, 1.0)) * (high.x - low.x);
  }
  float y(float t) const { return high.y - std::clamp(t / top, 0.0f, 1.0f) * (high.y - low.y); }
  double depth_at(float at) const {
    const double share = double((at - low.x) / (high.x - low.x));
    return logarithmic ? nearest * std::pow(farthest / nearest, share)
                       : nearest + share * (farthest - nearest);
  }
};

void dashed(ImDrawList& draw, const std::vector<ImVec2>& points, const std::array<float, 4>& dash, ImU32 ink,
            float width) {
  if (dash[0] == 0) return draw.AddPolyline(points.data(), int(points.size()), ink, 0, width);
  size_t part = 0;
  float left = dash[0];
  for (size_t i = 1; i < points.size(); ++i) {
    ImVec2 from = points[i - 1];
    for (;;) {
      const ImVec2 to = points[i];
      const float length = std::hypot(to.x - from.x, to.y - from.y), step = std::min(length, left);
      if (!(length > 0)) break;  // nor of what is not a number
      const ImVec2 until{from.x + (to.x - from.x) * step / length, from.y + (to.y - from.y) * step / length};
      if (part % 2 == 0) draw.AddLine(from, until, ink, width);
      from = until;
      left -= step;
      if (left > 0) break;
      part = (part + 1) % dash.size();
      left = dash[part];
    }
  }
}

void marker(ImDrawList& draw, ImVec2 at, const Style& style, ImU32 ink) {
  draw.AddNgonFilled(at, 3.5f, kGround, style.marker_sides);
  draw.AddNgon(at, 3.5f, ink, style.marker_sides, 1.2f);
}

ImVec2 size_of(const std::string& text) {
  return ImGui::CalcTextSize(text.c_str());
}

void label(ImDrawList& draw, ImVec2 at, ImU32 ink, const std::string& text) {
  const ImVec2 size = size_of(text);
  draw.AddRectFilled({at.x - 1, at.y}, {at.x + size.x + 1, at.y + size.y}, IM_COL32(18, 18, 20, 190));
  draw.AddText(at, ink, text.c_str());
}

/// 1, 2 or 5 times a power of ten.
double nice_step(double least) {
  const double power = std::pow(10.0, std::floor(std::log10(least)));
  for (const double factor : {1.0, 2.0, 5.0})
    if (factor * power >= least) return factor * power;
  return 10 * power;
}

std::vector<double> depth_ticks(const Plot& plot) {
  std::vector<double> ticks;
  if (plot.logarithmic)
    for (double power = std::pow(10.0, std::floor(std::log10(plot.nearest))); power <= plot.farthest;
         power *= 10)
      for (const double factor : {1.0, 2.0, 5.0})
        if (plot.holds(factor * power)) ticks.push_back(factor * power);
  if (ticks.size() >= 4) return ticks;
  ticks.clear();
  const double step = nice_step((plot.farthest - plot.nearest) * 60 / double(plot.high.x - plot.low.x));
  for (double tick = std::ceil(plot.nearest / step) * step; tick <= plot.farthest; tick += step)
    ticks.push_back(tick);
  return ticks;
}

void draw_axes(ImDrawList& draw, const Plot& plot) {
  draw.AddRectFilled(plot.low, plot.high, kGround);
  const double step = nice_step(double(plot.top) / 8);
  for (double t = 0; t <= double(plot.top) * 1.001; t += step) {
    const float y = plot.y(float(t));
    draw.AddLine({plot.low.x, y}, {plot.high.x, y}, kGrid);
    const std::string number = fmt::format("{:.2g}", t);
    draw.AddText({plot.low.x - size_of(number).x - 4, y - 0.5f * ImGui::GetFontSize()}, kInk, number.c_str());
  }
  float free = plot.low.x - 20;  // right end of the last number
  for (const double depth : depth_ticks(plot)) {
    const float x = plot.x(depth);
    draw.AddLine({x, plot.low.y}, {x, plot.high.y}, kGrid);
    const std::string number = fmt::format("{:.4g}", depth);
    const float half = 0.5f * size_of(number).x;
    if (x - half < free + 6) continue;
    draw.AddText({x - half, plot.high.y + 6}, kInk, number.c_str());
    free = x + half;
  }
  draw.AddText({plot.high.x - size_of("depth, m").x, plot.high.y + 6 + ImGui::GetFontSize()}, kFaint,
               "depth, m");
  draw.AddRect(plot.low, plot.high, kFaint);
}

/// Nothing: no method has any.
const MethodAtPixel* draw_slices(ImDrawList& draw, const Plot& plot, const PixelProbe& probe) {
  const auto has_slices = [](const MethodAtPixel& m) { return !m.marks.slices.empty(); };
  const auto method = std::ranges::find_if(probe.methods, has_slices);
  if (method == probe.methods.end()) return nullptr;
  bool dark = false;
  for (const DepthMarks::Slice& slice : method->marks.slices) {
    dark = !dark;
    if (double(slice.end) < plot.nearest || double(slice.begin) > plot.farthest) continue;
    const float begin = plot.x(double(slice.begin)), end = plot.x(double(slice.end));
    draw.AddRectFilled({begin, plot.low.y - 8}, {end, plot.low.y - 1},
                       dark ? IM_COL32(70, 80, 100, 255) : IM_COL32(120, 130, 155, 255));
    draw.AddLine({begin, plot.low.y - 8}, {begin, plot.low.y + 3}, kFaint);
    draw.AddLine({end, plot.low.y - 8}, {end, plot.low.y + 3}, kFaint);
  }
  return &*method;
}

void draw_exact(ImDrawList& draw, const Plot& plot, const PixelProbe& probe, Reading reading, ImU32 ink) {
  glm::dvec3 through(1.0);
  float x = plot.low.x;
  for (const PixelFragment& f : probe.fragments) {
    const float before = plot.y(reading.of(glm::vec3(through))), here = plot.x(double(f.depth_m));
    through *= glm::dvec3(f.transmittance);
    draw.AddLine({x, before}, {here, before}, ink, 2.5f);
    draw.AddLine({here, before}, {here, plot.y(reading.of(glm::vec3(through)))}, ink, 2.5f);
    x = here;
  }
  const float last = plot.y(reading.of(glm::vec3(through)));
  draw.AddLine({x, last}, {plot.high.x, last}, ink, 2.5f);
}

/// Where the exact curves of the channels are farthest apart: there they can be named.
double depth_of_most_colour(const PixelProbe& probe) {
  double best = double(probe.depths_m.front()), widest = -1;
  for (const float depth : probe.depths_m) {
    const glm::dvec3 t = probe.exact_transmittance(double(depth));
    const double width = std::max({t.r, t.g, t.b}) - std::min({t.r, t.g, t.b});
    if (width > widest + 1e-9) widest = width, best = double(depth);
  }
  return best;
}

void draw_curve(ImDrawList& draw, const Plot& plot, const PixelProbe& probe, const MethodAtPixel& method,
                const Style& style, Reading reading, ImU32 ink) {
  std::vector<ImVec2> points;
  for (size_t i = 0; i < method.transmittance.size(); ++i)
    points.emplace_back(plot.x(double(probe.depths_m[i])), plot.y(reading.of(method.transmittance[i])));
  dashed(draw, points, style.dash, ink, 1.5f);
  float next = plot.low.x + 25;  // markers a fixed way apart, however the depths are spread
  for (const ImVec2 point : points)
    if (point.x >= next) {
      marker(draw, point, style, ink);
      next = point.x + 70;
    }
}

void draw_fragments(ImDrawList& draw, const Plot& plot, const PixelProbe& probe,
                    std::optional<size_t> pointed_out) {
  for (size_t i = 0; i < probe.fragments.size(); ++i) {
    const float x = plot.x(double(probe.fragments[i].depth_m)), y = plot.high.y;
    if (pointed_out == i) {
      draw.AddLine({x, plot.low.y}, {x, y}, IM_COL32(255, 0, 255, 255), 1.5f);
      draw.AddTriangleFilled({x, y - 9}, {x - 6, y + 4}, {x + 6, y + 4}, IM_COL32(255, 0, 255, 255));
    } else {
      draw.AddTriangleFilled({x, y - 4}, {x - 3, y + 4}, {x + 3, y + 4}, kInk);
    }
  }
}

/// Labels of upright lines, below each other where they would meet.
class MarkLabels {
 public:
  MarkLabels(ImDrawList& draw, const Plot& plot) : draw_(draw), plot_(plot) {}
  void add(float x, const std::string& text) {
    const float width = size_of(text).x, line = ImGui::GetFontSize();
    const bool to_left = x + 8 + width > plot_.high.x;
    const float y = plot_.high.y - (2.2f + float(placed_++ % 3)) * line;
    label(draw_, {to_left ? x - 8 - width : x + 8, y}, kInk, text);
  }

 private:
  ImDrawList& draw_;
  const Plot& plot_;
  int placed_ = 0;
};

void draw_opaque(ImDrawList& draw, const Plot& plot, const PixelProbe& probe, MarkLabels& labels) {
  if (!probe.opaque_m) return;
  const double depth = double(*probe.opaque_m);
  if (depth > plot.farthest) return labels.add(plot.high.x, fmt::format("opaque at {:.4g} m ->", depth));
  const float x = plot.x(depth);
  draw.AddLine({x, plot.low.y}, {x, plot.high.y}, kInk, 2);
  draw.PushClipRect({x, plot.low.y}, {std::min(x + 9, plot.high.x), plot.high.y}, true);
  for (float y = plot.low.y; y < plot.high.y + 9; y += 6) draw.AddLine({x, y}, {x + 9, y - 9}, kFaint);
  draw.PopClipRect();
  labels.add(x, fmt::format("opaque {:.4g} m", depth));
}

void draw_method_marks(ImDrawList& draw, const Plot& plot, const MethodAtPixel& method, MarkLabels& labels) {
  const auto upright = [&](double depth, const std::array<float, 4>& dash) {
    const float x = plot.x(depth);
    dashed(draw, {{x, plot.low.y}, {x, plot.high.y}}, dash, kInk, 1);
    return x;
  };
  if (const auto zero = method.marks.zero_m; zero && plot.holds(double(*zero))) {
    const float x = upright(double(*zero), {8, 4, 8, 4});
    draw.AddTriangleFilled({x - 6, plot.low.y}, {x + 6, plot.low.y}, {x, plot.low.y + 9}, kInk);
    labels.add(x, fmt::format("nothing seen behind ({})", method.name));
  }
  if (const auto overflow = method.marks.overflow_m; overflow && plot.holds(double(*overflow))) {
    const float x = upright(double(*overflow), {2, 3, 2, 3});
    draw.AddNgonFilled({x, plot.low.y + 9}, 7, kInk, 4);
    draw.AddText({x - 3, plot.low.y + 2}, kGround, "!");
    labels.add(x, fmt::format("overflow ({})", method.name));
  }
}

void draw_legend(ImDrawList& draw, const Plot& plot, const PixelProbe& probe, const MethodAtPixel* sliced,
                 bool each_channel) {
  const float line = ImGui::GetFontSize();
  float width = size_of("exact").x;
  for (const MethodAtPixel& m : probe.methods) width = std::max(width, size_of(m.name).x);
  const float left = plot.high.x - width - 52;
  float y = plot.low.y + 5;
  draw.AddRectFilled({left - 5, y - 2}, {plot.high.x - 3, y + line * float(probe.methods.size() + 1) + 3},
                     IM_COL32(18, 18, 20, 200));
  const auto entry = [&](const std::string& name, const Style* style, ImU32 ink) {
    const ImVec2 from{left, y + 0.5f * line}, to{left + 36, y + 0.5f * line};
    if (style) {
      dashed(draw, {from, to}, style->dash, ink, 1.5f);
      marker(draw, {left + 18, from.y}, *style, ink);
    } else {
      draw.AddLine(from, to, ink, 2.5f);
    }
    draw.AddText({left + 42, y}, kInk, name.c_str());
    y += line;
  };
  entry("exact", nullptr, kExact);
  for (size_t i = 0; i < probe.methods.size(); ++i) {
    const Style& style = kStyles[i % kStyles.size()];
    entry(probe.methods[i].name, &style, each_channel ? kInk : style.ink);
  }
  if (sliced)
    draw.AddText({plot.low.x, plot.low.y - 10 - line}, kFaint,
                 fmt::format("{} slices of {}", sliced->marks.slices.size(), sliced->name).c_str());
}

std::string numbers(glm::vec3 t, bool each_channel) {
  return each_channel ? fmt::format("{:.4f} {:.4f} {:.4f}", t.r, t.g, t.b)
                      : fmt::format("{:.4f}", Reading{}.of(t));
}

void describe_depth(ImDrawList& draw, const Plot& plot, const PixelProbe& probe, bool each_channel) {
  const float x = ImGui::GetMousePos().x;
  const double wanted = plot.depth_at(x);
  // Methods were asked at certain depths: what is told is of one of them, and says so.
  const auto above = std::ranges::lower_bound(probe.depths_m, float(wanted));
  size_t i = size_t(above - probe.depths_m.begin());
  if (i == probe.depths_m.size() ||
      (i > 0 && wanted - double(probe.depths_m[i - 1]) < double(*above) - wanted))
    --i;
  const double depth = double(probe.depths_m[i]);
  const float at = plot.x(depth);
  draw.AddLine({at, plot.low.y}, {at, plot.high.y}, IM_COL32(255, 255, 255, 110));
  const auto in_front = std::ranges::count_if(
      probe.fragments, [&](const PixelFragment& f) { return double(f.depth_m) < depth; });
  ImGui::BeginTooltip();
  ImGui::Text("at %.4f m, behind %d of %d fragments%s", depth, int(in_front), int(probe.fragments.size()),
              each_channel ? ": R G B" : "");
  ImGui::Text("%s  exact", numbers(glm::vec3(probe.exact_transmittance(depth)), each_channel).c_str());
  for (const MethodAtPixel& method : probe.methods)
    if (method.transmittance.empty())
      ImGui::Text("%s: %s", method.name.c_str(), method.status.c_str());
    else
      ImGui::Text("%s  %s", numbers(method.transmittance[i], each_channel).c_str(), method.name.c_str());
  ImGui::EndTooltip();
}

Plot plot_of(const PixelProbe& probe, const DepthGraph& graph, Area area) {
  float highest = 1;
  for (const MethodAtPixel& method : probe.methods)
    for (const glm::vec3& t : method.transmittance) highest = std::max({highest, t.r, t.g, t.b});
  const float line = ImGui::GetFontSize();
  const double nearest = double(probe.depths_m.front());
  return {.low = {area.corner.x + 2.6f * line, area.corner.y + line + 12},
          .high = {area.corner.x + area.size.x - 8, area.corner.y + area.size.y - 2 * line - 8},
          .nearest = nearest,
          .farthest = std::max(double(probe.depths_m.back()), nearest * 1.001),
          .logarithmic = graph.logarithmic,
          .top = 1.04f * std::min(highest, kHighest)};
}

}  // namespace

void draw_depth_graph(const PixelProbe& probe, const DepthGraph& graph, Area area) {
  if (probe.depths_m.empty()) return;
  const Plot plot = plot_of(probe, graph, area);
  if (plot.high.x - plot.low.x < 40 || plot.high.y - plot.low.y < 30) return;  // no room
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  draw_axes(draw, plot);
  const MethodAtPixel* sliced = draw_slices(draw, plot, probe);
  const auto curves = [&](Reading reading, std::optional<ImU32> ink) {
    draw_exact(draw, plot, probe, reading, ink.value_or(kExact));
    for (size_t i = 0; i < probe.methods.size(); ++i) {
      const Style& style = kStyles[i % kStyles.size()];
      draw_curve(draw, plot, probe, probe.methods[i], style, reading, ink.value_or(style.ink));
    }
  };
  if (graph.each_channel)
    for (int c = 0; c < 3; ++c) {
      curves({.channel = c}, kChannelInk[size_t(c)]);
      const double apart = depth_of_most_colour(probe);
      const float there = glm::vec3(probe.exact_transmittance(apart))[c];
      draw.AddText({plot.x(apart) + 4 + 9 * float(c), plot.y(there) - ImGui::GetFontSize()},
                   kChannelInk[size_t(c)], kChannelNames[size_t(c)]);
    }
  else
    curves({}, std::nullopt);
  draw_fragments(draw, plot, probe, graph.fragment);
  MarkLabels labels(draw, plot);
  draw_opaque(draw, plot, probe, labels);
  for (const MethodAtPixel& method : probe.methods) draw_method_marks(draw, plot, method, labels);
  draw_legend(draw, plot, probe, sliced, graph.each_channel);
  if (ImGui::IsWindowHovered() && ImGui::IsMouseHoveringRect(plot.low, plot.high))
    describe_depth(draw, plot, probe, graph.each_channel);
}

}  // namespace plume
