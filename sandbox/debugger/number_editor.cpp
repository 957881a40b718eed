#include "sandbox/debugger/number_editor.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "sandbox/debugger/widgets.h"

namespace plume {
namespace {

constexpr double kNarrow = 10;  ///< limits this near are the two ends of a slider
constexpr auto kClamp = ImGuiSliderFlags_AlwaysClamp;

bool is_narrow(const Limits& limits) {
  return limits.max - limits.min <= kNarrow;
}

/// A hundredth of the number for each pixel.
float pace(double value, const Limits& limits, bool whole = false) {
  const double least = whole ? 20.0 : limits.min > 0 ? limits.min : 0.2;
  return float(0.01 * std::max(std::abs(value), least));
}

/// How the number is written: with its unit where there is room.
template <class Value>
std::string fitting_format(const char* digits, std::string_view unit, Value value) {
  std::string format = number_format(digits, unit);
  std::array<char, 128> text{};
  std::snprintf(text.data(), text.size(), format.c_str(), value);
  const float room = ImGui::CalcItemWidth() - 2 * ImGui::GetStyle().FramePadding.x;
  return ImGui::CalcTextSize(text.data()).x <= room ? format : digits;
}

template <class Value>
bool edit(const char* id, Value& value, const Limits& limits, ImGuiDataType type, const char* digits) {
  const std::string format = fitting_format(digits, limits.unit, value);
  const Value min = Value(limits.min), max = Value(limits.max);
  Value wanted = value;
  const bool changed =
      is_narrow(limits)
          ? ImGui::SliderScalar(id, type, &wanted, &min, &max, format.c_str(), kClamp)
          : ImGui::DragScalar(id, type, &wanted, pace(double(value), limits, std::is_integral_v<Value>), &min,
                              &max, format.c_str(), kClamp);
  // A typed "nan" passes the clamp.
  if (!changed || !std::isfinite(double(wanted)) || wanted == value) return false;
  value = wanted;
  return true;
}

}  // namespace

bool edit_number(const char* id, float& value, const Limits& limits) {
  return edit(id, value, limits, ImGuiDataType_Float, "%.4g");
}

bool edit_number(const char* id, double& value, const Limits& limits) {
  return edit(id, value, limits, ImGuiDataType_Double, "%.4g");
}

bool edit_number(const char* id, int64_t& value, const Limits& limits) {
  return edit(id, value, limits, ImGuiDataType_S64, "%lld");
}

bool edit_numbers(const char* id, std::span<float> values, const Limits& limits) {
  const float min = float(limits.min), max = float(limits.max);
  double largest = 0;
  for (const float value : values) largest = std::max(largest, std::abs(double(value)));
  std::vector<float> wanted(values.begin(), values.end());
  const bool changed = ImGui::DragScalarN(id, ImGuiDataType_Float, wanted.data(), int(wanted.size()),
                                          pace(largest, limits), &min, &max, "%.3g", kClamp);
  const auto is_number = [](float value) { return std::isfinite(value); };
  if (!changed || !std::ranges::all_of(wanted, is_number) || std::ranges::equal(wanted, values)) return false;
  std::ranges::copy(wanted, values.begin());
  return true;
}

bool edit_range(const char* id, Range<float>& value, const Limits& limits) {
  Range<float> wanted = value;
  const double largest = std::max(std::abs(double(value.min)), std::abs(double(value.max)));
  if (!ImGui::DragFloatRange2(id, &wanted.min, &wanted.max, pace(largest, limits), float(limits.min),
                              float(limits.max), "%.4g", nullptr, kClamp) ||
      !std::isfinite(wanted.min) || !std::isfinite(wanted.max) || wanted == value)
    return false;
  value = wanted;
  return true;
}

bool edit_range(const char* id, Range<uint32_t>& value, const Limits& limits) {
  int min = int(value.min), max = int(value.max);
  if (!ImGui::DragIntRange2(id, &min, &max, pace(max, limits, true), int(limits.min), int(limits.max), "%d",
                            nullptr, kClamp))
    return false;
  const Range<uint32_t> wanted{uint32_t(min), uint32_t(max)};
  if (wanted == value) return false;
  value = wanted;
  return true;
}

}  // namespace plume
