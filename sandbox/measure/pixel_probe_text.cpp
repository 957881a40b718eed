#include "sandbox/measure/pixel_probe_text.h"

#include <fmt/format.h>

namespace plume {
namespace {

using nlohmann::json;

constexpr std::array kChannels{"r", "g", "b"};

json colour(glm::vec3 c) {
  return {c.r, c.g, c.b};
}

json colours(const std::vector<glm::vec3>& list) {
  json result = json::array();
  for (const glm::vec3& c : list) result.push_back(colour(c));
  return result;
}

json or_null(const std::optional<float>& number) {
  return number ? json(*number) : json(nullptr);
}

json to_json(const PixelFragment& f) {
  json told{{"depth_m", f.depth_m},
            {"card", f.card},
            {"light", colour(f.light)},
            {"color", colour(f.color)},
            {"alpha", f.alpha},
            {"emission", colour(f.emission)},
            {"transmittance", colour(f.transmittance)},
            {"weight", colour(f.weight)}};
  if (f.owner.pane)
    told["pane"] = *f.owner.pane;
  else
    told.update({{"effect", f.owner.effect},
                 {"instance", f.owner.instance},
                 {"emitter", f.owner.emitter},
                 {"particle", f.owner.birth},
                 {"part", f.owner.part}});
  return told;
}

json to_json(const MethodAtPixel& method, const PixelProbe& probe) {
  json told{{"method", method.id},      {"settings", method.settings}, {"status", method.status},
            {"transmittance", nullptr}, {"weights", nullptr},          {"weight_errors", nullptr},
            {"marks", nullptr}};
  if (method.status != "ok") return told;
  told["transmittance"] = colours(method.transmittance);
  told["weights"] = colours(method.weights);
  told["weight_errors"] = json::array();
  for (size_t i = 0; i < method.weights.size(); ++i)
    told["weight_errors"].push_back(colour(method.weights[i] - probe.fragments[i].weight));
  json slices = json::array();
  for (const DepthMarks::Slice& slice : method.marks.slices) slices.push_back({slice.begin, slice.end});
  told["marks"] = {{"slices_m", std::move(slices)},
                   {"zero_transmittance_m", or_null(method.marks.zero_m)},
                   {"overflow_m", or_null(method.marks.overflow_m)}};
  return told;
}

/// Names of effects and emitters may hold anything.
std::string quoted(const std::string& text) {
  std::string result = "\"";
  for (const char c : text) result += c == '"' ? "\"\"" : std::string(1, c);
  return result + "\"";
}

std::string cells(glm::vec3 c) {
  return fmt::format(",{},{},{}", c.r, c.g, c.b);
}

std::string column_names(const std::string& of) {
  std::string names;
  for (const char* channel : kChannels) names += fmt::format(",{}_{}", of, channel);
  return names;
}

}  // namespace

json to_json(const PixelProbe& probe) {
  json result{{"scene", probe.scene},
              {"tick", probe.tick},
              {"size", {probe.size.x, probe.size.y}},
              {"pixel", {probe.pixel.x, probe.pixel.y}},
              {"opaque_depth_m", or_null(probe.opaque_m)},
              {"fragments", json::array()},
              {"depths_m", probe.depths_m},
              {"exact_transmittance", json::array()},
              {"methods", json::array()}};
  for (const PixelFragment& fragment : probe.fragments) result["fragments"].push_back(to_json(fragment));
  for (const float depth : probe.depths_m)
    result["exact_transmittance"].push_back(colour(glm::vec3(probe.exact_transmittance(double(depth)))));
  for (const MethodAtPixel& method : probe.methods) result["methods"].push_back(to_json(method, probe));
  return result;
}

std::string curves_csv(const PixelProbe& probe) {
  std::string csv = "depth_m";
  for (const MethodAtPixel& method : probe.methods) csv += column_names(method.name);
  csv += "\n";
  for (size_t i = 0; i < probe.depths_m.size(); ++i) {
    csv += fmt::format("{}", probe.depths_m[i]);
    for (const MethodAtPixel& method : probe.methods)
      csv += method.transmittance.empty() ? ",,," : cells(method.transmittance[i]);
    csv += "\n";
  }
  return csv;
}

std::string fragments_csv(const PixelProbe& probe) {
  std::string csv = "depth_m,pane,effect,instance,emitter,particle" + column_names("color") + ",alpha" +
                    column_names("emission") + column_names("transmittance") + column_names("weight");
  for (const MethodAtPixel& method : probe.methods)
    csv += column_names(method.name + "_weight") + column_names(method.name + "_error");
  csv += "\n";
  for (size_t i = 0; i < probe.fragments.size(); ++i) {
    const PixelFragment& f = probe.fragments[i];
    const CardOwner& owner = f.owner;
    csv += fmt::format("{},", f.depth_m);
    csv += owner.pane ? fmt::format("{},,,,", *owner.pane)
                      : fmt::format(",{},{},{},{}", quoted(owner.effect), quoted(owner.instance),
                                    quoted(owner.emitter), owner.birth);
    csv += cells(f.color) + fmt::format(",{}", f.alpha) + cells(f.emission) + cells(f.transmittance) +
           cells(f.weight);
    for (const MethodAtPixel& method : probe.methods)
      csv +=
          method.weights.empty() ? ",,,,,," : cells(method.weights[i]) + cells(method.weights[i] - f.weight);
    csv += "\n";
  }
  return csv;
}

}  // namespace plume
