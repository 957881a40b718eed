#include "shaders/methods/avboit/sums.h"

#include "renderer/methods/avboit/plan.h"

namespace plume::avboit {

void add_sums_needs(Needs& needs, const Plan& plan) {
  if (plan.settings.accumulation != Accumulation::kDeterministic) return;
  const glm::uvec2 half = plan.settings.half_particles ? (plan.size + 1u) / 2u : glm::uvec2(0);
  const uint64_t pixels = uint64_t(plan.size.x) * plan.size.y + uint64_t(half.x) * half.y;
  needs.buffers.push_back({.name = "sums", .bytes = pixels * shared::kSums * 8, .clear = 0});
  needs.buffers.push_back({.name = "sums_address", .bytes = 8, .clear = {}});
}

void record_sums(const Picture& picture, const Plan& plan) {
  const gpu::Buffer& address = picture.resources.buffer("sums_address");
  const gpu::Binding sums{"SumsAddress", &address};
  picture.frame.pass("draw", [&](gpu::Pass& pass) {
    pass.update(address, picture.resources.buffer("sums").address_words());
    pass.barrier();
    for (Transparents::Style draw : shading(picture, plan)) {
      draw.fragment = "methods/avboit/accumulate_integers.frag";
      draw.targets.clear();
      draw.bindings.push_back(sums);
      picture.transparents.draw(pass, draw);
    }
  });
  picture.frame.pass("gather", [&](gpu::Pass& pass) {
    const auto gather = [&](glm::uvec2 area, uint32_t scale, const std::string& end,
                            std::initializer_list<const char*> names) {
      std::vector<gpu::Attachment> targets;
      for (const char* name : names)
        targets.push_back(
            {.image = &picture.resources.image(name + end), .blend = gpu::Blend::kReplace, .clear = {}});
      pass.draw({.vertex = "post/fullscreen.vert",
                 .fragment = "methods/avboit/gather.frag",
                 .targets = std::move(targets),
                 .area = {area.x, area.y},
                 .constants = {scale, plan.colour() == Colour::kRgb ? 1u : 0u},
                 .bindings = {sums}},
                plan.size);
    };
    gather(plan.size, 1, "", {"light", "norm", "norm_rgb", "through", "known_light", "known_norm"});
    if (plan.settings.half_particles)
      gather((plan.size + 1u) / 2u, 2, "_half",
             {"light", "norm", "norm_rgb", "through", "known_light", "known_norm"});
  });
}

}  // namespace plume::avboit
