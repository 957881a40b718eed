#include "sandbox/effects/lighting.h"

#include <algorithm>

namespace plume {
namespace {

constexpr float kNarrowestCaster_m = 0.1f;  // radius
constexpr uint32_t kGroupSize = 64;
constexpr uint32_t kFitThreads = 1024;
constexpr glm::vec2 kCellsARadius{3.0f, 1.5f};  // the sky's light comes from all around: its shadows are soft

float greatest(const Curve& curve) {
  float most = 0.0f;
  for (const auto& key : curve.keys) most = std::max(most, key.value);
  return most;
}

/// A group a call of calls near each other: each in turn becomes the middle of a group that is farthest from
/// all middles so far (Gonzalez, "Clustering to minimize the maximum intercluster distance", 1985).
std::map<uint32_t, uint32_t> grouped(const std::map<uint32_t, glm::vec3>& places, uint32_t most) {
  struct Member {
    uint32_t call, group;
    glm::vec3 place;
    float apart;
  };
  std::vector<Member> members;
  for (const auto& [call, place] : places) members.push_back({call, 0, place, 1e30f});
  for (uint32_t group = 0; group < std::min<size_t>(most, members.size()); ++group) {
    const glm::vec3 middle = std::ranges::max_element(members, {}, &Member::apart)->place;
    for (Member& member : members)
      if (const float apart = glm::distance(member.place, middle); apart < member.apart)
        member.apart = apart, member.group = group;
  }
  std::map<uint32_t, uint32_t> result;
  for (const Member& member : members) result[member.call] = member.group;
  return result;
}

/// Written by the host.
template <class T>
void fill(gpu::Device& device, gpu::Buffer& buffer, const char* label, const std::vector<T>& data) {
  if (buffer.bytes() < data.size() * sizeof(T))
    buffer = gpu::Buffer(
        device, {.owner = "light", .label = label, .bytes = data.size() * sizeof(T), .host_visible = true});
  std::ranges::copy(data, buffer.mapped<T>().begin());
}

struct FitPush {
  uint32_t count, threads;
};
struct GridPush {
  glm::uvec2 cells;
  glm::vec2 cells_a_radius;
};
struct SplatPush {
  uint32_t count, which;
};

}  // namespace

bool casts_shadow(const Look& look) {
  return look.lit && look.meshes.empty() && !look.ribbon && look.distortion_deg == 0.0f &&
         (look.cross_section_m2 || greatest(*look.opacity) > 0.0f) &&
         greatest(look.radius_m) * look.radius_scale.max >= kNarrowestCaster_m;
}

bool glows(const Look& look) {
  return !look.opaque && std::ranges::any_of(look.emission.keys,
                                             [](const auto& key) { return key.value != glm::vec3(0.0f); });
}

Lighting::Lighting(gpu::Device& device, LightingOptions options, const std::map<uint32_t, glm::vec3>& glowing)
    : device_(device),
      options_(options),
      cells_each_way_{options.cells, std::max(options.cells / 2, shared::kLeastLightCells)},
      fire_of_call_(grouped(glowing, shared::kMostFires)) {}

void Lighting::fit(const std::vector<EmitterCards>& emitters, uint32_t cards) {
  const auto any = [&](auto asks) {
    return std::ranges::any_of(emitters, [&](const EmitterCards& e) { return asks(e.emitter->look); });
  };
  const bool casts = options_.self_shadow && any(casts_shadow);
  const bool shines = options_.fire_gain > 0.0f && any(glows);
  receives_ = any([](const Look& look) { return look.lit; });
  count_ = casts || shines ? cards : 0;
  fit_volumes(casts && count_ > 0 ? Volumes::kFull : count_ > 0 ? Volumes::kEmpty : Volumes::kNone);
  fire_count_ = 0;
  if (count_ == 0) {
    for (gpu::Buffer* buffer : {&bodies_, &grids_, &fires_, &sources_, &ranges_}) *buffer = {};
    return;
  }
  const uint64_t bytes = uint64_t(count_) * sizeof(shared::LitBody);
  if (bodies_.bytes() < bytes)
    bodies_ = gpu::Buffer(device_, {.owner = "light", .label = "bodies", .bytes = bytes + bytes / 4});
  if (!grids_)
    grids_ = gpu::Buffer(
        device_,
        {.owner = "light", .label = "grids", .bytes = shared::kLightGrids * sizeof(shared::LightGrid)});
  if (!fires_)  // one more: loops may look at the one after the last
    fires_ = gpu::Buffer(device_, {.owner = "light",
                                   .label = "fires",
                                   .bytes = 4 + (shared::kMostFires + 1) * sizeof(shared::FireLight)});
  if (shines) fit_fires(emitters);
}

void Lighting::fit_volumes(Volumes wanted) {
  if (wanted == volumes_are_) return;
  volumes_are_ = wanted;
  bounds_ = {};
  cells_ = {};
  volumes_ = {};
  if (wanted == Volumes::kNone) return;
  const bool full = wanted == Volumes::kFull;
  for (uint32_t g = 0; g < shared::kLightGrids; ++g) {
    const uint32_t n = cells_each_way_[g];
    volumes_[g] =
        gpu::Image(device_, {.owner = "light",
                             .label = g == 0 ? "sun_volume" : "sky_volume",
                             .format = vk::Format::eR16G16Sfloat,
                             .extent = full ? vk::Extent3D{n, n, n} : vk::Extent3D{1, 1, 2},
                             .usage = vk::ImageUsageFlagBits::eStorage | vk::ImageUsageFlagBits::eSampled});
    if (full)
      cells_[g] =
          gpu::Buffer(device_, {.owner = "light", .label = "cells", .bytes = uint64_t(n) * n * n * 4});
  }
  if (full)
    bounds_ = gpu::Buffer(
        device_,
        {.owner = "light", .label = "bounds", .bytes = shared::kLightGrids * shared::kLightBounds * 4});
}

void Lighting::fit_fires(const std::vector<EmitterCards>& emitters) {
  struct Fire {
    glm::vec3 origin;
    std::vector<shared::FireRange> ranges;
  };
  std::map<uint32_t, Fire> fires;
  for (const auto& emitter : emitters) {
    if (!glows(emitter.emitter->look) || emitter.count == 0) continue;
    const auto [fire, added] = fires.try_emplace(fire_of_call_.at(emitter.call));
    if (added) fire->second.origin = emitter.origin;
    fire->second.ranges.push_back({.first = emitter.first, .count = emitter.count});
  }
  std::vector<shared::FireSource> sources;
  std::vector<shared::FireRange> ranges;
  for (const auto& [group, fire] : fires) {
    sources.push_back(
        {.origin = fire.origin, .first = uint32_t(ranges.size()), .count = uint32_t(fire.ranges.size())});
    ranges.insert(ranges.end(), fire.ranges.begin(), fire.ranges.end());
  }
  fire_count_ = uint32_t(sources.size());
  fill(device_, sources_, "fire_sources", sources);
  fill(device_, ranges_, "fire_ranges", ranges);
}

void Lighting::record_volumes(gpu::Frame& frame, const gpu::Buffer& view) const {
  frame.pass("extinction", [&](gpu::Pass& pass) {
    pass.fill(bounds_, 0xFFFFFFFFu);
    for (const gpu::Buffer& cells : cells_) pass.fill(cells, 0);
    pass.barrier();
    const uint32_t threads = std::min(kFitThreads, gpu::groups(count_, kGroupSize) * kGroupSize);
    pass.dispatch(pass.pipelines().compute("effects/light_fit.comp"),
                  {{"View", &view}, {"Bodies", &bodies_}, {"Bounds", &bounds_}},
                  FitPush{.count = count_, .threads = threads}, {threads / kGroupSize, 1, 1});
    pass.barrier();
    pass.dispatch(
        pass.pipelines().compute("effects/light_grid.comp"),
        {{"View", &view}, {"Bounds", &bounds_}, {"Grids", &grids_}},
        GridPush{.cells = {cells_each_way_[0], cells_each_way_[1]}, .cells_a_radius = kCellsARadius},
        {shared::kLightGrids, 1, 1});
    pass.barrier();
    for (uint32_t g = 0; g < shared::kLightGrids; ++g)
      pass.dispatch(pass.pipelines().compute("effects/light_splat.comp"),
                    {{"Bodies", &bodies_}, {"Grids", &grids_}, {"Cells", &cells_[g]}},
                    SplatPush{.count = count_, .which = g}, {gpu::groups(count_, kGroupSize), 1, 1});
    pass.barrier();
    // The larger grid last: GPU-assisted validation (layers 1.4.309) holds both to the buffer pushed last.
    for (uint32_t g = shared::kLightGrids; g-- > 0;) {
      const uint32_t rays = gpu::groups(cells_each_way_[g], 8);
      pass.dispatch(pass.pipelines().compute("effects/light_integrate.comp"),
                    {{"Grids", &grids_}, {"Cells", &cells_[g]}, {"volume", &volumes_[g]}}, g,
                    {rays, rays, 1});
    }
  });
}

void Lighting::record(gpu::Frame& frame, const Transparents& seen, uint32_t first_card) const {
  if (count_ == 0) return;
  if (shadows()) record_volumes(frame, *seen.view);
  frame.pass("light", [&](gpu::Pass& pass) {
    if (!shadows())
      for (const gpu::Image& volume : volumes_) pass.clear(volume, {0, 0, 0, 0});
    if (fire_count_ > 0)
      pass.dispatch(pass.pipelines().compute("effects/light_fires.comp"),
                    {{"Bodies", &bodies_}, {"Sources", &sources_}, {"Ranges", &ranges_}, {"Fires", &fires_}},
                    options_.fire_gain, {fire_count_, 1, 1});
    else
      pass.fill(fires_, 0);
    pass.barrier();
    if (!receives_) return;
    gpu::Bindings bound = bindings();
    bound.push_back({"Bodies", &bodies_});
    for (const gpu::Binding& cards : seen.seen()) bound.push_back(cards);
    pass.dispatch(pass.pipelines().compute("effects/light_cards.comp", {shadows() ? 1u : 0u}), bound,
                  glm::uvec2(first_card, count_), seen.each_seen());
  });
}

gpu::Bindings Lighting::bindings() const {
  return {{"Grids", &grids_}, {"sun_volume", &volumes_[0]}, {"sky_volume", &volumes_[1]}, {"Fires", &fires_}};
}

}  // namespace plume
