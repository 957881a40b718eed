#include "renderer/probe.h"

#include "renderer/methods/avboit/plan.h"

namespace plume::avboit {

void record_probe(const Picture& picture, const Plan& plan, const Probe& probe) {
  gpu::Bindings bindings = transmittance_bindings(picture);
  bindings.push_back({"Occupancy", &picture.resources.buffer("occupancy")});
  const Settings& s = plan.settings;
  const bool each_channel = plan.colour() == Colour::kRgb;
  probe_with(picture, probe, "methods/avboit/probe.comp",
             {uint32_t(s.sampling), s.linear_splat ? 1u : 0u, plan.rgb && each_channel ? 1u : 0u,
              s.sparse ? 1u : 0u, each_channel ? 1u : 0u, 0u, 0u, 0u, s.lane_bits()},
             std::move(bindings));
}

}  // namespace plume::avboit
