#include "sandbox/effects/dispatch_length.h"

#include <algorithm>
#include <numeric>

namespace plume {
namespace {

constexpr uint32_t kMostTurns = 65535;
constexpr uint32_t kBesides =
    200;  // of a dispatch, whatever the ticks: searches for spans, births and triangles
constexpr uint32_t kMostImpacts = 4;  // shaders/effects/collide.glsl

}  // namespace

LoopsPerTick::LoopsPerTick(const shared::EmitterData& e, uint32_t path_keys) {
  const uint32_t solids = e.box_count + e.round_count + 2;
  const uint32_t generations = std::min(e.generation, shared::kMostGenerations) + 1;
  turns_ = {(e.curl_octaves + 1) * generations, e.attractor_count + 1, e.kill_count + 1,
            (kMostImpacts + 1) * (solids + 1) + solids,  // impacts, and being pushed out at birth
            path_keys + 1,
            // Whose turn it is, once for the step and twice for each hand-over.
            generations * (1 + 2 * generations) + generations + 1};
}

LoopsPerTick& LoopsPerTick::widen(const LoopsPerTick& other) {
  for (size_t i = 0; i < turns_.size(); ++i) turns_[i] = std::max(turns_[i], other.turns_[i]);
  return *this;
}

uint32_t LoopsPerTick::ticks_per_dispatch() const {
  const uint32_t a_tick = std::accumulate(turns_.begin(), turns_.end(), 1u);
  return std::max((kMostTurns - kBesides) / a_tick, 1u);
}

}  // namespace plume
