#include "sandbox/presets/add_instance.h"

#include "sandbox/presets/toml_edit.h"

namespace plume {

PresetDocument::Outcome add_instance(PresetDocument& scene, const Instance& instance) {
  const Field* field = scene.field("instance");
  const Groups* others = field ? std::get_if<Groups>(&field->value) : nullptr;
  const Step item{"instance", others ? others->count : 0};
  return scene.change("Add " + instance.name, [&](const std::string& before) {
    std::string text = with_table(before, {item});
    const auto say = [&](const char* key, const TomlValue& value) {
      text = with_value(text, {item, {key}}, value);
    };
    say("effect", {instance.effect});
    if (instance.name != instance.effect) say("name", {instance.name});
    if (instance.call_tick) say("call_tick", {int64_t(*instance.call_tick)});
    const glm::vec3& at = instance.position;
    say("position", {std::vector<TomlValue>{{at.x}, {at.y}, {at.z}}});
    if (instance.yaw_deg != 0) say("yaw_deg", {instance.yaw_deg});
    if (instance.seed != 0) say("seed", {int64_t(instance.seed)});
    return text;
  });
}

}  // namespace plume
