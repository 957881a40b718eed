// Stacks of layers through the methods that keep nodes a pixel, and what each of them makes of a stack, in
// double precision and in the published form: sorted arrays.
#ifndef PLUME_TESTS_PIXEL_NODES_TEST_H
#define PLUME_TESTS_PIXEL_NODES_TEST_H

#include <algorithm>

#include "renderer/probe.h"
#include "tests/gpu/avboit_scene.h"

namespace plume {

struct StackLayer {
  double z;
  uint32_t id;
  glm::dvec3 light, t;
  bool operator<(const StackLayer& other) const { return z < other.z || (z == other.z && id < other.id); }
};
using Stack = std::vector<StackLayer>;

/// Front to back over a background.
inline glm::dvec3 composite(const Stack& sorted, glm::dvec3 background) {
  glm::dvec3 light(0), through(1);
  for (const StackLayer& layer : sorted) {
    light += through * layer.light;
    through *= layer.t;
  }
  return light + through * background;
}

inline glm::dvec3 transmittance_of(const Stack& nodes, double z) {
  glm::dvec3 t(1);
  for (const StackLayer& node : nodes)
    if (node.z < z) t *= node.t;
  return t;
}

struct KBufferModel {
  Stack nodes;
  glm::dvec3 tail_light{0}, tail_through{1}, tail_alpha{0};

  KBufferModel(Stack layers, size_t k) {
    std::ranges::sort(layers, std::less{});
    nodes.assign(layers.begin(), layers.begin() + ptrdiff_t(std::min(k, layers.size())));
    for (size_t i = k; i < layers.size(); ++i) {
      tail_light += layers[i].light;
      tail_through *= layers[i].t;
      tail_alpha += 1.0 - layers[i].t;
    }
  }
  glm::dvec3 share() const {
    glm::dvec3 s(1);
    for (int c = 0; c < 3; ++c)
      if (tail_alpha[c] > 1e-6) s[c] = (1 - tail_through[c]) / tail_alpha[c];
    return s;
  }
  glm::dvec3 image(glm::dvec3 background) const {
    return composite(nodes, tail_light * share() + tail_through * background);
  }
};

/// Nodes after all layers came in this order.
inline Stack mlab_model(const Stack& arrivals, size_t k) {
  Stack nodes;
  for (const StackLayer& layer : arrivals) {
    nodes.insert(std::ranges::upper_bound(nodes, layer, std::less{}), layer);
    if (nodes.size() <= k) continue;
    const StackLayer behind = nodes.back();
    nodes.pop_back();
    nodes.back().light += nodes.back().t * behind.light;
    nodes.back().t *= behind.t;
  }
  return nodes;
}

/// As Intel's sample keeps it: each node holds the transmittance behind it.
struct AoitModel {
  struct Node {
    double z;
    uint32_t id;
    glm::dvec3 behind;
  };
  std::vector<Node> nodes;

  AoitModel(const Stack& arrivals, size_t k) {
    for (const StackLayer& layer : arrivals) {
      if (layer.t == glm::dvec3(1)) continue;
      size_t place = 0;
      while (place < nodes.size() && in_front(nodes[place], layer)) ++place;
      const glm::dvec3 in_front_of_it = place > 0 ? nodes[place - 1].behind : glm::dvec3(1);
      for (size_t i = place; i < nodes.size(); ++i) nodes[i].behind *= layer.t;
      nodes.insert(nodes.begin() + ptrdiff_t(place), {layer.z, layer.id, in_front_of_it * layer.t});
      if (nodes.size() <= k) continue;
      nodes[k - 1].behind = nodes[k].behind;
      nodes.pop_back();
    }
  }
  static bool in_front(const Node& node, const StackLayer& layer) {
    return node.z < layer.z || (node.z == layer.z && node.id < layer.id);
  }
  glm::dvec3 visibility(const StackLayer& layer) const {
    glm::dvec3 v(1);
    for (const Node& node : nodes)
      if (in_front(node, layer)) v = node.behind;
    return v;
  }
  glm::dvec3 image(const Stack& layers, glm::dvec3 background) const {
    glm::dvec3 light(0);
    for (const StackLayer& layer : layers) light += layer.light * visibility(layer);
    return light + background * (nodes.empty() ? glm::dvec3(1) : nodes.back().behind);
  }
};

class PixelNodesTest : public AvboitTest {
 protected:
  using Map = std::map<std::string, std::string>;
  Random random{7};

  PixelNodesTest() {
    size = {9, 5};
    scene.light.horizon = {0.25f, 0.375f, 0.5f};  // half floats hold it
  }
  glm::dvec3 background() const { return scene.light.horizon; }

  static float depth_for(float alpha) { return -std::log1p(-alpha); }

  /// Layers of all kinds that fill the picture: thin, opaque, coloured, shining without covering, of equal
  /// depth. With `thin`, light comes through them all.
  void random_stack(uint32_t count, bool thin = false) {
    clear_cards();
    for (uint32_t i = 0; i < count; ++i) {
      const uint32_t kind = random.below(6);
      PlacedCard c{.z = float(2 + random.below(40) * 0.25)};
      c.optical_depth = kind == 0 ? 0.0f : float(random.octaves(0.004, thin ? 0.3 : kind == 1 ? 40.0 : 2.0));
      c.color = {random.f(0, 1), random.f(0, 1), random.f(0, 1)};
      if (kind == 2) c.transmission = {random.f(0, 1), random.f(0, 1), random.f(0, 1)};
      if (kind == 0 || kind == 3) c.emission = {random.f(0, 1), random.f(0, 1), random.f(0, 1)};
      add(c);
    }
    order.resize(count);
    std::iota(order.begin(), order.end(), 0u);
    // Sources stand together, as those who draw them apart rely on.
    const auto rgb_begin = order.begin() + ptrdiff_t(scalar.size());
    for (auto [from, to] : {std::pair(order.begin(), rgb_begin), std::pair(rgb_begin, order.end())})
      for (; to - from > 1; --to) std::swap(to[-1], from[random.below(uint32_t(to - from))]);
  }
  Stack stack() const {
    const auto half3 = [](glm::uvec2 words) {
      const glm::vec2 xy = glm::unpackHalf2x16(words.x);
      return glm::dvec3(xy.x, xy.y, glm::unpackHalf2x16(words.y).x);
    };
    Stack layers;
    const std::vector<shared::Card> all = cards();
    for (uint32_t i = 0; i < all.size(); ++i) {
      const double alpha = 1 - std::exp(-double(all[i].optical_depth));
      layers.push_back({.z = -double(all[i].center.z),
                        .id = i,
                        .light = half3(all[i].ambient) * alpha + half3(all[i].emission),
                        .t = 1.0 - alpha * (1.0 - half3(all[i].transmission))});
    }
    return layers;
  }
  Stack sorted_stack() const {
    Stack layers = stack();
    std::ranges::sort(layers, std::less{});
    return layers;
  }
  Stack arrivals() const {
    const Stack layers = stack();
    Stack came;
    for (const uint32_t i : order) came.push_back(layers[i]);
    return came;
  }

  /// One rounding of half floats, to either side, and what 32-bit sums and exponentials leave.
  static void expect_everywhere(const DrawnPicture& picture, glm::dvec3 expected) {
    for (size_t i = 0; i < picture.linear.pixels.size(); ++i)
      for (int c = 0; c < 3; ++c)
        ASSERT_NEAR(expected[c], picture.linear.pixels[i][c], expected[c] / 1024 + 2e-5)
            << "pixel " << i << " channel " << c;
  }

  struct Told {
    std::vector<glm::vec3> transmittance;
    nlohmann::json statistics;
  };
  /// What a method says beside its picture.
  Told ask(std::string_view id, const Map& settings, const std::vector<float>& depths) {
    const std::unique_ptr<World> w = world();
    MethodInstance method = instance(id, settings);
    const Probe probe(device, {size.x / 2, size.y / 2}, depths);
    render_frame(device, pipelines, w->targets, w->prelude(), w->transparents(), method, &probe);
    return {probe.read_answer(device), method.method->statistics(device, method.resources)};
  }
};

}  // namespace plume
#endif
