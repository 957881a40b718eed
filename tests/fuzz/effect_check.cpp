#include "sandbox/effects/spawn_schedule.h"
#include "sandbox/presets/read_effect.h"
#include "tests/fuzz/preset_checks.h"

namespace plume::fuzz {

std::string check_effect(Bytes bytes) {
  const std::string file = PLUME_SOURCE_PRESETS "/effects/fuzzed.toml";  // beside the vector fields
  const std::string_view text = text_of(bytes);
  const auto effect = read_or_refuse(read_effect_text, text, file);
  const std::vector<Field> fields = effect_fields(text, file);  // of a text with mistakes too
  if (!effect) return "refused";
  require_within_limits(fields);
  require(!effect->emitters.empty(), "an effect without emitters");
  for (const Emitter& emitter : effect->emitters) {
    require(
        emitter.look.opaque || emitter.look.cross_section_m2.has_value() != emitter.look.opacity.has_value(),
        "an opacity that is stated twice, or not at all");
    if (!emitter.parent)
      require(SpawnSchedule(emitter.spawn).capacity() <= kMaxAlive, "more particles than there is room for");
  }
  return "read";
}

}  // namespace plume::fuzz
