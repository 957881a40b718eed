#include "renderer/glance.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "shaders/inspect/count.h"

namespace plume {
namespace {

constexpr std::string_view kOverdraw = "overdraw", kShaded = "shaded";

struct GlancePush {
  glm::uvec2 size;
  uint32_t slice;
};

std::array<uint32_t, 3> squares_of_8(glm::uvec2 size) {
  return {gpu::groups(size.x, 8), gpu::groups(size.y, 8), 1};
}

/// Pixels of the picture that a fragment of a draw stands for, each way.
uint32_t pixels_a_fragment(const Transparents::Style& style, glm::uvec2 size) {
  return uint32_t(std::lround(float(size.x) / (float(style.area.width) * style.covered.x)));
}

/// Counts what draws let through, whatever they do with it.
void count(const Picture& picture, const Glance& glance, std::vector<Transparents::Style> draws) {
  picture.frame.pass("inspect", [&](gpu::Pass& pass) {
    pass.fill(glance.values, 0);
    pass.barrier();
    for (Transparents::Style& draw : draws) {
      draw.constants.resize(shared::kCountConstant + 1, 0u);
      draw.constants[shared::kCountConstant] = pixels_a_fragment(draw, picture.size);
      draw.fragment = "inspect/count.frag";
      draw.targets = {};
      draw.bindings.push_back({"Values", &glance.values});
      draw.count_fragments = false;
      picture.transparents.draw(pass, draw);
    }
    pass.barrier();
    pass.dispatch(pass.pipelines().compute("inspect/counted.comp"), {{"Values", &glance.values}},
                  GlancePush{.size = picture.size, .slice = 0}, squares_of_8(picture.size));
  });
}

}  // namespace

Glance::Glance(gpu::Device& device, glm::uvec2 size, std::string of, uint32_t at_slice)
    : id(std::move(of)),
      slice(at_slice),
      values(device, {.owner = "inspect", .label = "values", .bytes = uint64_t(size.x) * size.y * 4}) {}

std::vector<float> Glance::read_values(gpu::Device& device) const {
  return gpu::read<float>(device, values);
}

std::vector<Inspection> inspections_of(const Method& method) {
  std::vector<Inspection> all{
      {.id = std::string(kOverdraw),
       .title = "Overdraw",
       .help =
           "Fragments of transparent cards in front of opaque things, whatever becomes of them. The empty "
           "corners of a puff are none.",
       .unit = "fragments",
       .absent = "no fragment"},
      {.id = std::string(kShaded),
       .title = "Shaded fragments",
       .help =
           "Fragments that the method's draws of colour let through: in front of opaque things, and of its "
           "culling depth where it has one. A fragment of a draw at lower resolution counts in each pixel "
           "for the share that it is. Methods that draw all cards again for every layer, or that leave "
           "off in a shader, are not followed there: each fragment counts once.",
       .unit = "fragments",
       .absent = "no fragment"}};
  std::ranges::move(method.inspections(), std::back_inserter(all));
  return all;
}

void record_glance(const Picture& picture, const Method& method, const Glance& glance) {
  const auto has = [&](const Inspection& view) { return view.id == glance.id; };
  if (glance.id == kOverdraw) return count(picture, glance, {front_of_opaque(picture)});
  if (glance.id == kShaded) return count(picture, glance, method.shading(picture));
  if (std::ranges::none_of(method.inspections(), has))
    throw std::invalid_argument(fmt::format("{} has no view {}", method.id(), glance.id));
  method.inspect(picture, glance);
}

void glance_with(const Picture& picture, const Glance& glance, const std::string& shader,
                 const gpu::Constants& constants, gpu::Bindings bindings) {
  bindings.push_back({"View", picture.transparents.view});
  bindings.push_back({"Values", &glance.values});
  picture.frame.pass("inspect", [&](gpu::Pass& pass) {
    pass.dispatch(pass.pipelines().compute(shader, constants), bindings,
                  GlancePush{.size = picture.size, .slice = glance.slice}, squares_of_8(picture.size));
  });
}

}  // namespace plume
