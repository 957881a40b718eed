#include "sandbox/stress/stress.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "renderer/methods/methods.h"
#include "sandbox/measure/picture.h"
#include "sandbox/presets/read_scene.h"
#include "sandbox/scene/stage.h"
#include "sandbox/stress/cases.h"

namespace plume {
namespace stress {

PlacedCard layer(double z, double coverage, glm::vec3 color, bool sharp) {
  return {.z = z,
          .optical_depth = optical_depth_of(coverage),
          .color = color,
          .half_size = glm::vec2(float(10 * std::max(z, 0.1))),
          .layer = sharp ? shared::kSolidLayer : shared::kSoftLayer};
}

std::vector<StressPicture> sharp_and_smooth(const std::string& name,
                                            const std::function<CardScene(bool sharp)>& scene) {
  const std::string prefix = name.empty() ? "" : name + ", ";
  return {{.name = prefix + "sharp", .cards = scene(true)},
          {.name = prefix + "smooth", .cards = scene(false)}};
}

}  // namespace stress

namespace {

float brightest(const Image& image) {
  float most = 1.0f;
  for (const glm::vec3& pixel : image.pixels) most = std::max({most, pixel.r, pixel.g, pixel.b});
  return most;
}

bool is_finite(const Image& image) {
  return std::ranges::all_of(image.pixels, [](const glm::vec3& p) {
    return std::isfinite(p.r) && std::isfinite(p.g) && std::isfinite(p.b);
  });
}

/// The mean of scale x scale pixels for one.
Image reduced(const Image& image, uint32_t scale) {
  if (scale == 1) return image;
  Image small;
  small.width = image.width / int(scale), small.height = image.height / int(scale);
  for (int y = 0; y < small.height; ++y)
    for (int x = 0; x < small.width; ++x) {
      glm::dvec3 sum(0.0);
      for (uint32_t j = 0; j < scale; ++j)
        for (uint32_t i = 0; i < scale; ++i)
          sum += glm::dvec3(image.at(x * int(scale) + int(i), y * int(scale) + int(j)));
      small.pixels.push_back(glm::vec3(sum / double(scale * scale)));
    }
  return small;
}

/// Takes a picture into the worst so far. Where `moved` lacks a pixel of `still`, there is nothing to
/// compare.
void judge(const Image& still, const Image& moved, const StressPicture& picture, StressFinding& worst) {
  worst.finite &= is_finite(moved);
  const Image seen = reduced(moved, picture.scale);
  const double unit = double(brightest(still));
  double squares = 0.0;
  size_t compared = 0;
  for (int y = 0; y < still.height; ++y)
    for (int x = 0; x < still.width; ++x) {
      const glm::ivec2 at = glm::ivec2(x, y) + picture.shift;
      if (at.x < 0 || at.y < 0 || at.x >= seen.width || at.y >= seen.height) continue;
      const glm::dvec3 apart = (glm::dvec3(seen.at(at.x, at.y)) - glm::dvec3(still.at(x, y))) / unit;
      double most = std::max({std::abs(apart.r), std::abs(apart.g), std::abs(apart.b)});
      if (!(most < std::numeric_limits<double>::infinity())) most = std::numeric_limits<double>::infinity();
      if (most > worst.max) worst.max = most, worst.picture = picture.name, worst.pixel = at;
      squares += glm::dot(apart, apart), compared += 3;
    }
  const double rmse = compared ? std::sqrt(squares / double(compared)) : 0.0;
  worst.rmse = std::isfinite(rmse) ? std::max(worst.rmse, rmse) : std::numeric_limits<double>::infinity();
}

/// What is drawn of a picture of a case, of cards or of a scene.
class Subjects {
 public:
  Subjects(gpu::Device& device, gpu::Pipelines& pipelines, const PresetLibrary& library,
           const StressPicture& picture)
      : targets(device, picture.size) {
    if (picture.scene.empty()) {
      cards_.emplace(device, pipelines, picture.cards, picture.size);
    } else {
      scene_.emplace(device, pipelines, library, library.scene(picture.scene));
      scene_->go_to(picture.tick, picture.size);
    }
  }
  Prelude prelude() const { return cards_ ? cards_->prelude() : scene_->prelude(); }
  const Transparents& transparents() const {
    return cards_ ? cards_->transparents() : scene_->transparents();
  }

  Targets targets;

 private:
  std::optional<CardStage> cards_;
  std::optional<Stage> scene_;
};

struct Contender {
  MethodInstance instance;
  std::optional<StressFinding> finding;
  std::optional<Image> first;
};

}  // namespace

std::vector<std::optional<StressFinding>> StressRun::run(const StressCase& hard_case,
                                                         const std::vector<MethodRun>& methods) {
  const auto instance_of = [](const MethodRun& run, const std::string& owner) {
    MethodInstance made{.method = make_method(run.id), .owner = owner, .resources = {}};
    for (const auto& [name, value] : run.settings) set_parameter(*made.method, name, value);
    return made;
  };
  const bool is_exact = hard_case.against == StressCase::Against::kExact;
  MethodInstance reference = instance_of({.id = "reference", .settings = {}}, "ground truth");
  std::vector<Contender> contenders;
  for (const MethodRun& run : methods) {
    Contender& c =
        contenders.emplace_back(Contender{.instance = instance_of(run, run.id), .finding = {}, .first = {}});
    if (c.instance.method->missing(device_).empty()) c.finding.emplace();
  }
  for (const StressPicture& picture : hard_case.pictures) {
    const Subjects subject(device_, pipelines_, library_, picture);
    const auto draw = [&](MethodInstance& instance) {
      render_frame(device_, pipelines_, subject.targets, subject.prelude(), subject.transparents(), instance);
      return read_picture(device_, subject.targets).linear;
    };
    std::optional<Image> exact;
    if (is_exact) exact = draw(reference);
    for (Contender& c : contenders) {
      if (!c.finding) continue;
      Image drawn = draw(c.instance);
      if (!exact && !c.first) c.first = drawn;
      judge(exact ? *exact : *c.first, drawn, picture, *c.finding);
    }
  }
  std::vector<std::optional<StressFinding>> findings;
  for (Contender& c : contenders) findings.push_back(std::move(c.finding));
  return findings;
}

std::vector<StressCase> stress_cases() {
  std::vector<StressCase> all;
  for (const auto cases : {stress::coverage_cases, stress::depth_cases, stress::light_cases,
                           stress::picture_cases, stress::invariance_cases})
    std::ranges::move(cases(), std::back_inserter(all));
  return all;
}

}  // namespace plume
