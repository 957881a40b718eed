#include "tests/fuzz/preset_checks.h"

#include <algorithm>
#include <cmath>

namespace plume::fuzz {
namespace {

class NumbersOf {
 public:
  explicit NumbersOf(const Field& field) : field_(field) {}

  void operator()(float number) const { check(number, field_.limits); }
  void operator()(double number) const { check(number, field_.limits); }
  void operator()(int64_t number) const { check(static_cast<double>(number), field_.limits); }
  void operator()(const glm::vec2& v) const { check(v.x, field_.limits), check(v.y, field_.limits); }
  void operator()(const glm::vec3& v) const { check(v, field_.limits); }
  void operator()(const glm::uvec2& v) const { check(v.x, field_.limits), check(v.y, field_.limits); }
  template <class Number>
  void operator()(const Range<Number>& range) const {
    check(range.min, field_.limits), check(range.max, field_.limits);
    require(range.min <= range.max, field_.path + " is no range");
  }
  void operator()(const Curve& curve) const {
    for (const Curve::Key& key : curve.keys) check(key.at, {0, 1}), check(key.value, field_.limits);
    ascend(curve.keys, &Curve::Key::at);
  }
  void operator()(const Gradient& gradient) const {
    for (const Gradient::Key& key : gradient.keys) check(key.at, {0, 1}), check(key.value, field_.limits);
    ascend(gradient.keys, &Gradient::Key::at);
  }
  void operator()(const Wholes& list) const {
    for (const uint32_t number : list) check(number, field_.limits);
    ascend(list, std::identity());
  }
  void operator()(const Pairs& list) const {
    for (const auto& pair : list)
      for (size_t i = 0; i < 2; ++i) check(pair[i], field_.columns.at(i).limits);
    ascend(list, [](const auto& pair) { return pair[0]; });
  }
  void operator()(const Points& list) const {
    for (const auto& [at, point] : list)
      check(at, field_.columns.at(0).limits), check(point, field_.columns.at(1).limits);
    ascend(list, &Points::value_type::first);
  }
  void operator()(const std::string& text) const {
    const auto& options = field_.options;
    require(options.empty() || text.empty() || std::ranges::find(options, text) != options.end(),
            field_.path + " is none of what it can be");
  }
  template <class Other>
  void operator()(const Other&) const {}  // that has no numbers

 private:
  void check(double number, const Limits& limits) const {
    const double slack = 1e-6 * (std::abs(limits.min) + std::abs(limits.max));  // floats are rounded
    require(number >= limits.min - slack && number <= limits.max + slack,
            field_.path + " is " + std::to_string(number));
  }
  void check(const glm::vec3& v, const Limits& limits) const {
    for (int i = 0; i < 3; ++i) check(v[i], limits);
  }
  template <class List, class Projection>
  void ascend(const List& list, Projection projection) const {
    require(std::ranges::is_sorted(list, std::less_equal(), projection) || list.size() < 2,
            field_.path + " does not ascend");
  }

  const Field& field_;
};

}  // namespace

void require_clear(const std::vector<Diagnostic>& found, std::string_view text, const std::string& file) {
  require(!found.empty(), "refused without a reason");
  const auto lines = static_cast<size_t>(std::ranges::count(text, '\n')) + 1;
  for (const Diagnostic& d : found) {
    const std::string said = to_string(d);
    require(d.file == file, "of another file: " + said);
    require(d.line >= 1 && d.line <= lines && d.column >= 1, "of another place: " + said);
    const auto shows = [](char c) { return static_cast<unsigned char>(c) >= 0x20 && c != 0x7f; };
    require(std::ranges::all_of(d.message, shows), "what it says would disturb a terminal: " + said);
    const size_t right = std::min({d.message.find("expected "), d.message.find("did you mean ")});
    require(right != d.message.npos && right > 0, "does not say what would be right: " + said);
  }
}

void require_within_limits(const std::vector<Field>& fields) {
  for (const Field& field : fields) {
    require(field.state != Field::State::kWrong, field.path + " is wrong in a text that was accepted");
    if (field.state == Field::State::kRead) std::visit(NumbersOf(field), field.value);
  }
}

}  // namespace plume::fuzz
