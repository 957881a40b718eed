#include "sandbox/presets/write_scene.h"

#include <fmt/format.h>

#include "sandbox/presets/toml_text.h"

namespace plume {
namespace {

TomlValue toml(const glm::vec2& v) {
  return {std::vector<TomlValue>{{v.x}, {v.y}}};
}
TomlValue toml(const glm::vec3& v) {
  return {std::vector<TomlValue>{{v.x}, {v.y}, {v.z}}};
}
TomlValue toml(float v) {
  return {v};
}
TomlValue toml(bool v) {
  return {v};
}
TomlValue toml(uint32_t v) {
  return {int64_t(v)};
}
TomlValue toml(int v) {
  return {int64_t(v)};
}
TomlValue toml(const std::string& v) {
  return {v};
}

/// Lines `key = value`.
class Lines {
 public:
  void table(std::string_view head) { text_ += fmt::format("\n{}\n", head); }
  template <class Value>
  void key(std::string_view name, const Value& value) {
    text_ += fmt::format("{} = {}\n", name, to_toml(toml(value)));
  }
  void key(std::string_view name, std::string_view word) { key(name, std::string(word)); }
  void key(std::string_view name, std::vector<TomlValue> list) {
    text_ += fmt::format("{} = {}\n", name, to_toml({std::move(list)}));
  }
  std::string text() && { return std::move(text_); }

 private:
  std::string text_;
};

void write_camera(const CameraKey& camera, Lines& lines) {
  lines.key("position", camera.position);
  lines.key("target", camera.target);
  lines.key("vertical_fov_deg", camera.vertical_fov_deg);
}

void write_solid(const Solid& solid, Lines& lines) {
  lines.table("[[solid]]");
  lines.key("kind", kSolidNames[size_t(solid.kind)]);
  lines.key("material", kMaterialNames[size_t(solid.material)]);
  lines.key("color", solid.color);
  lines.key("position", solid.position);
  switch (solid.kind) {
    case SolidKind::kPlane:
      return lines.key("size_m", glm::vec2(solid.size_m.x, solid.size_m.z));
    case SolidKind::kBox:
      lines.key("size_m", solid.size_m);
      return lines.key("yaw_deg", solid.yaw_deg);
    case SolidKind::kCapsule:
      lines.key("end", solid.end);
      [[fallthrough]];
    case SolidKind::kSphere:
      return lines.key("radius_m", solid.radius_m);
  }
}

void write_pane(const Pane& pane, Lines& lines) {
  lines.table("[[pane]]");
  lines.key("position", pane.position);
  lines.key("yaw_deg", pane.yaw_deg);
  lines.key("pitch_deg", pane.pitch_deg);
  lines.key("size_m", pane.size_m);
  lines.key("color", pane.color);
  lines.key("coverage", pane.coverage);
  lines.key("transmission", pane.transmission);
  lines.key("diffusion_deg", pane.diffusion_deg);
  lines.key("emission", pane.emission);
  lines.key("draw_order", pane.draw_order);
}

void write_instance(const Instance& instance, Lines& lines) {
  lines.table("[[instance]]");
  lines.key("effect", instance.effect);
  lines.key("name", instance.name);
  if (instance.call_tick) lines.key("call_tick", *instance.call_tick);
  if (instance.stop_tick) lines.key("stop_tick", *instance.stop_tick);
  std::vector<TomlValue> freezes, path;
  for (const Freeze& freeze : instance.freezes)
    freezes.push_back({std::vector<TomlValue>{toml(freeze.from), toml(freeze.until)}});
  if (!freezes.empty()) lines.key("freeze", std::move(freezes));
  lines.key("position", instance.position);
  if (instance.path)
    for (const Path::Key& key : instance.path->keys())
      path.push_back({std::vector<TomlValue>{toml(key.tick), toml(key.position)}});
  if (!path.empty()) lines.key("path", std::move(path));
  lines.key("yaw_deg", instance.yaw_deg);
  lines.key("seed", instance.seed);
  lines.key("draw_order", instance.draw_order);
  if (!instance.layers.empty()) lines.table("[instance.layers]");
  for (const LayerOffset& layer : instance.layers) lines.key(quoted_text(layer.layer), layer.camera_offset_m);
}

}  // namespace

std::string scene_text(const Scene& scene) {
  Lines lines;
  lines.key("name", scene.name);
  if (!scene.description.empty()) lines.key("description", scene.description);
  lines.key("seed", scene.seed);
  lines.key("duration_ticks", scene.duration_ticks);
  lines.key("default_tick", scene.default_tick);
  lines.key("near_m", scene.near_m);
  lines.key("far_m", scene.far_m);
  lines.key("exposure", scene.exposure);
  lines.key("tonemap", kTonemapNames[size_t(scene.tonemap)]);
  lines.key("wind", scene.wind);
  lines.table("[light]");
  lines.key("sky", scene.light.sky);
  lines.key("zenith", scene.light.zenith);
  lines.key("horizon", scene.light.horizon);
  lines.key("sun_direction", scene.light.sun_direction);
  lines.key("sun_color", scene.light.sun_color);
  lines.key("self_shadow", scene.light.self_shadow);
  lines.key("shadow_cells", scene.light.shadow_cells);
  lines.key("fire_light", scene.light.fire_light);
  if (const auto& lens = scene.depth_of_field) {
    lines.table("[depth_of_field]");
    lines.key("focus_m", lens->focus_m);
    lines.key("aperture_mm", lens->aperture_mm);
  }
  for (const CameraKey& camera : scene.camera) {
    lines.table("[[camera]]");
    lines.key("tick", camera.tick);
    write_camera(camera, lines);
  }
  for (const Solid& solid : scene.solids) write_solid(solid, lines);
  for (const Pane& pane : scene.panes) write_pane(pane, lines);
  for (const Instance& instance : scene.instances) write_instance(instance, lines);
  return std::move(lines).text();
}

std::string camera_text(const CameraKey& camera) {
  Lines lines;
  write_camera(camera, lines);
  return std::move(lines).text();
}

}  // namespace plume
