// plume diff A B: image metrics between two files, with tolerances.
#include <fmt/format.h>

#include <cmath>

#include "sandbox/commands/command.h"
#include "sandbox/measure/error_map.h"
#include "sandbox/measure/flip.h"
#include "sandbox/measure/image_io.h"
#include "sandbox/measure/metrics.h"

namespace plume {
namespace {

struct DiffFlags {
  std::string a, b, error_map;
  std::optional<double> max_rmse, max_abs, max_flip, min_psnr, min_ssim;
};

/// Both forms of a picture: an EXR is linear and is clipped for display, a PNG is what is displayed.
struct Pair {
  Image linear;
  DisplayImage display;
};

Pair read_pair(const std::string& path) {
  if (path.ends_with(".exr")) {
    Image linear = read_exr(path);
    DisplayImage display = to_display(linear);
    return {std::move(linear), std::move(display)};
  }
  DisplayImage display = read_png(path);
  return {to_linear(display), std::move(display)};
}

int run_diff(const DiffFlags& flags) {
  const Pair a = read_pair(flags.a), b = read_pair(flags.b);
  if (a.display.width != b.display.width || a.display.height != b.display.height)
    throw UsageError(fmt::format("{} is {}x{} and {} is {}x{}: the sizes must be equal", flags.a,
                                 a.display.width, a.display.height, flags.b, b.display.width,
                                 b.display.height));
  const MaxError worst = max_abs(a.linear, b.linear);
  const FlipResult difference = flip(a.display, b.display);
  const double error = rmse(a.linear, b.linear), psnr = psnr_db(a.display, b.display),
               similarity = ssim(a.display, b.display);
  if (!flags.error_map.empty()) write_png(flags.error_map, magma_image(difference.map));

  std::vector<std::string> exceeded;
  const auto at_most = [&](const char* name, double value, std::optional<double> limit) {
    if (limit && !(value <= *limit)) exceeded.push_back(fmt::format("{} {} is over {}", name, value, *limit));
  };
  const auto at_least = [&](const char* name, double value, std::optional<double> limit) {
    if (limit && !(value >= *limit))
      exceeded.push_back(fmt::format("{} {} is under {}", name, value, *limit));
  };
  at_most("rmse", error, flags.max_rmse);
  at_most("max", worst.value, flags.max_abs);
  at_most("flip", difference.mean, flags.max_flip);
  at_least("psnr_db", psnr, flags.min_psnr);
  at_least("ssim", similarity, flags.min_ssim);

  const nlohmann::json result{
      {"rmse", error},
      {"max", worst.value},
      {"max_at", {worst.x, worst.y}},
      {"psnr_db", std::isfinite(psnr) ? nlohmann::json(psnr) : nlohmann::json(nullptr)},
      {"ssim", similarity},
      {"flip", difference.mean},
      {"exceeded", exceeded}};
  fmt::print("{}\n", result.dump(2));
  return exceeded.empty() ? kDone : kToleranceExceeded;
}

/// Not "nan", which nothing is over or under.
std::string finite(const std::string& text) {
  double value = 0;
  if (CLI::detail::lexical_cast(text, value) && std::isfinite(value)) return "";
  return fmt::format("{} is given, expected a number such as 0.01", text);
}

}  // namespace

void add_diff(CLI::App& program, Run& run) {
  auto flags = std::make_shared<DiffFlags>();
  CLI::App* command = program.add_subcommand("diff", "image metrics between two PNG or EXR files, as JSON");
  command->add_option("A", flags->a, "the reference")->required();
  command->add_option("B", flags->b, "the image to judge")->required();
  command->add_option("--max-rmse", flags->max_rmse, "exit 1 when the RMSE (linear) is over this")
      ->type_name("X")
      ->check(finite);
  command->add_option("--max-abs", flags->max_abs, "exit 1 when any channel (linear) differs by more")
      ->type_name("X")
      ->check(finite);
  command->add_option("--max-flip", flags->max_flip, "exit 1 when the mean FLIP error is over this")
      ->type_name("X")
      ->check(finite);
  command->add_option("--min-psnr", flags->min_psnr, "exit 1 when the PSNR (displayed, dB) is under this")
      ->type_name("X")
      ->check(finite);
  command->add_option("--min-ssim", flags->min_ssim, "exit 1 when the SSIM (displayed) is under this")
      ->type_name("X")
      ->check(finite);
  command->add_option("--error-map", flags->error_map, "write the FLIP map to this PNG, magma, 0 to 1")
      ->type_name("FILE");
  command->callback([flags, &run] { run = [flags] { return run_diff(*flags); }; });
}

}  // namespace plume
