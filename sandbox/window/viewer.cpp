#include "sandbox/window/viewer.h"

#include <algorithm>

#include "renderer/methods/methods.h"
#include "sandbox/debugger/method_panel.h"
#include "sandbox/debugger/playback_panel.h"
#include "sandbox/debugger/timings_panel.h"
#include "sandbox/measure/image_io.h"
#include "sandbox/measure/picture.h"
#include "sandbox/window/orbit.h"
#include "sandbox/window/picture_copy.h"

namespace plume {
namespace {

constexpr std::string_view kFirstMethod = "avboit";
constexpr double kIdleSeconds = 0.05;  // how long a tooltip may take to appear while nothing moves
constexpr float kDegreesPerPixel = 0.25f;

/// Half the window's size on a CPU, which would not keep up otherwise.
glm::uvec2 picture_size(const gpu::Device& device, glm::uvec2 window) {
  return device.info().is_cpu ? glm::max(window / 2u, glm::uvec2(1)) : window;
}

std::vector<MethodInstance> all_methods() {
  std::vector<MethodInstance> methods;
  for (const std::string& id : method_ids())
    methods.push_back({.method = make_method(id), .owner = id, .resources = {}});
  return methods;
}

}  // namespace

Viewer::Viewer(GlfwWindow& window, gpu::Device& device, gpu::Pipelines& pipelines,
               const PresetLibrary& library, Scene scene, const Playback& playback)
    : window_(window),
      device_(device),
      pipelines_(pipelines),
      stage_(device, pipelines, library, std::move(scene)),
      swapchain_(device, window.make_surface(device.instance())),
      overlay_(device, window, swapchain_.format()),
      methods_(all_methods()),
      playback_(playback) {
  while (current_ + 1 < methods_.size() && methods_[current_].owner != kFirstMethod) ++current_;
}

void Viewer::run(uint32_t frames) {
  for (uint32_t shown = 0; !window_.closing() && (frames == 0 || shown < frames);) {
    const WindowInput input = window_.wait(idle_s());
    overlay_.begin();
    react_to(input);
    describe_panels();
    overlay_.end();
    if (window_.closing() || window_.size() == glm::uvec2(0)) continue;  // size 0: minimised

    outdated_ |= playback_.advance(now_s());
    outdated_ |= !targets_ || targets_->size != picture_size(device_, window_.size());
    if (outdated_ || always_draw_)
      draw_scene();
    else if (!playback_.playing())
      frame_ms_ = last_drawn_s_ = 0;
    if (show()) ++shown;
  }
}

void Viewer::react_to(const WindowInput& input) {
  if (!overlay_.takes_keys())
    for (const Key key : input.keys) press(key);
  if (overlay_.takes_pointer() || (input.drag == glm::vec2(0) && input.wheel == 0)) return;
  const CameraKey from = camera_.value_or(camera_at(stage_.scene().camera, playback_.tick()));
  camera_ = zoom(orbit(from, input.drag * kDegreesPerPixel), input.wheel);
  outdated_ = true;
}

void Viewer::press(Key key) {
  const uint32_t tick = playback_.tick();
  switch (key) {
    case Key::kSpace:
      playback_.toggle();
      break;
    case Key::kLeft:
      playback_.step_back();
      break;
    case Key::kRight:
      playback_.step_forward();
      break;
    case Key::kM:
      next_method();
      break;
    case Key::kEscape:
      window_.close();
      break;
  }
  outdated_ |= playback_.tick() != tick;
}

void Viewer::next_method() {
  const size_t before = current_;
  do current_ = (current_ + 1) % methods_.size();
  while (current_ != before && !methods_[current_].method->missing(device_).empty());
  method_changed(before);
}

void Viewer::describe_panels() {
  const glm::uvec2 size = targets_ ? targets_->size : glm::uvec2(0);
  outdated_ |= playback_panel(stage_.scene(), {device_.info().name, size, frame_ms_}, playback_, camera_);
  const size_t before = current_;
  outdated_ |= method_panel(device_, methods_, current_);
  method_changed(before);
  timings_panel(timings_, device_.memory(), always_draw_);
}

void Viewer::method_changed(size_t before) {
  if (current_ == before) return;
  outdated_ = true;
  methods_[before].resources = {};
  timings_.clear();
}

void Viewer::draw_scene() {
  const glm::uvec2 size = picture_size(device_, window_.size());
  if (!targets_ || targets_->size != size) {
    targets_.emplace(device_, size, stage_.post());
    timings_.clear();
  }
  auto passes = stage_.go_to(playback_.tick(), size, camera_);
  const FrameReport report = render_frame(device_, pipelines_, *targets_, stage_.prelude(),
                                          stage_.transparents(), methods_[current_]);
  passes.insert(passes.end(), report.passes.begin(), report.passes.end());
  timings_.add(passes);
  outdated_ = false;

  const double now = now_s(), ms = (now - last_drawn_s_) * 1000;
  if (last_drawn_s_ > 0) frame_ms_ = frame_ms_ > 0 ? frame_ms_ + 0.1 * (ms - frame_ms_) : ms;
  last_drawn_s_ = now;
}

bool Viewer::show() {
  return swapchain_.show(window_.size(),
                         [this](const vk::raii::CommandBuffer& commands, const WindowImage& image) {
                           record_picture_copy(commands, targets_->display, image);
                           overlay_.record(commands, image);
                         });
}

void Viewer::save_picture(const std::filesystem::path& path) const {
  if (!targets_) throw std::runtime_error("--screenshot: the window was closed before anything was drawn");
  write_png(path, read_picture(device_, *targets_).display);
}

double Viewer::now_s() const {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
}

double Viewer::idle_s() const {
  const bool hidden = window_.size() == glm::uvec2(0);
  if (hidden || (!outdated_ && !always_draw_ && !playback_.playing())) return kIdleSeconds;
  return playback_.playing() && !outdated_ && !always_draw_ ? playback_.seconds_to_next(now_s()) : 0.0;
}

}  // namespace plume
