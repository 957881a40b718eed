#include "sandbox/measure/shortfalls.h"

#include <fmt/format.h>

#include <cmath>

namespace plume {
namespace {

/// With a space before every three digits.
std::string grouped(uint64_t count) {
  std::string digits = std::to_string(count);
  for (size_t at = digits.size(); at > 3;) digits.insert(at -= 3, " ");
  return digits;
}

}  // namespace

std::vector<std::string> shortfall_sentences(const Method& method, const nlohmann::json& statistics) {
  std::vector<std::string> sentences;
  for (const Shortfall& shortfall : method.shortfalls()) {
    const double count = statistics.value(std::string(shortfall.statistic), 0.0);
    if (count > 0)
      sentences.push_back(fmt::format("{}: {}. {}.", shortfall.what, grouped(uint64_t(std::llround(count))),
                                      shortfall.remedy));
  }
  return sentences;
}

}  // namespace plume
