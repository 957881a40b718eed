#include "sandbox/window/viewer.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "renderer/gpu/errors.h"
#include "sandbox/debugger/file_questions.h"
#include "sandbox/debugger/instance_marks.h"
#include "sandbox/debugger/keys.h"
#include "sandbox/measure/file_bytes.h"
#include "sandbox/measure/image_io.h"
#include "sandbox/measure/picture.h"
#include "sandbox/measure/pixel_probe_text.h"
#include "sandbox/measure/statistics.h"
#include "sandbox/window/composition.h"
#include "sandbox/workspace/camera_moves.h"
#include "sandbox/workspace/cpu_clock.h"

namespace plume {
namespace {

constexpr double kRestSeconds = 0.4;   // without a new picture, until that is drawn at all of its resolution
constexpr double kIdleSeconds = 0.05;  // how long a tooltip may take to appear while nothing moves
constexpr float kDegreesPerPixel = 0.25f;
constexpr float kFlyMetresPerSecond = 3.0f, kFlyFast = 4.0f;
constexpr double kLongestStep = 0.1;  // s: a slow picture is no reason to fly through a wall
constexpr double kTellSeconds = 0.1;  // between two notices of what is made ready
constexpr float kDividerReach = 6;    // screen coordinates to both sides

/// The largest size of that shape in an area.
glm::uvec2 fitted(glm::uvec2 shape, glm::uvec2 area) {
  const glm::dvec2 scales = glm::dvec2(area) / glm::dvec2(shape);
  return glm::max(glm::uvec2(glm::dvec2(shape) * std::min(scales.x, scales.y)), glm::uvec2(1));
}

/// An id, or the path of a file that is not in the library.
std::string name_of(const Scene& scene, const PresetLibrary& library) try {
  return library.find(PresetKind::kScene, scene.id) == scene.file
             ? scene.id
             : std::filesystem::absolute(scene.file).string();
} catch (const PresetError&) {
  return std::filesystem::absolute(scene.file).string();
}

}  // namespace

Viewer::Viewer(GlfwWindow& window, Workspace& workspace, std::filesystem::path shaders)
    : window_(window),
      workspace_(workspace),
      interface_{workspace},
      swapchain_(workspace.device(), window.make_surface(workspace.device().instance())),
      overlay_(workspace.device(), &window, swapchain_.format()),
      shaders_(std::move(shaders)) {
  workspace_.pipelines().listen([this](const gpu::Preparing& preparing) { tell(preparing); });
}

Viewer::~Viewer() {
  workspace_.pipelines().listen({});
}

void Viewer::run(uint32_t frames, const std::function<bool()>& interrupted) {
  bool heard = false;
  std::string scene = workspace_.scene().file;
  int settling = 2;  // ImGui lays out what it has seen: what is shown first should stay where it is
  for (uint32_t shown = 0; !interface_.closing && (frames == 0 || shown < frames);) {
    window_.wait(idle_s());
    if (!heard && interrupted && interrupted()) heard = true, close_window(interface_);
    do {
      const WindowInput input = window_.next_input();
      const double before_ms = thread_cpu_ms();
      overlay_.begin(window_.content_scale() / window_.pixel_ratio() * interface_.text_scale,
                     window_.pixel_ratio(), input, interface_.gallery);
      area_ = describe_panels(interface_);
      react_to(input);
      overlay_.end();
      overlay_ms_ = thread_cpu_ms() - before_ms;
      settling = std::max(settling - 1, 0);
    } while (window_.has_input() || settling > 0);
    if (scene != workspace_.scene().file) {
      scene = workspace_.scene().file;
      visit_scene(interface_.settings, name_of(workspace_.scene(), workspace_.library()));
      window_.set_title("Plume: " + workspace_.scene().name);
    }
    window_.set_full_screen(interface_.full_screen);
    if (interface_.closing || window_.size() == glm::uvec2(0)) continue;  // size 0: minimised

    try {
      follow_shaders();
      draw_what_is_due();
    } catch (const gpu::ShaderError& broken) {  // on disk: what was shown stays
      workspace_.problem = shader_problem_ = broken.what();
    }
    if (!show()) continue;
    ++shown;
    note_overlay();
  }
}

/// Where they break, the last good ones go on.
void Viewer::follow_shaders() {
  if (!shaders_.poll(now_s())) return;
  workspace_.reload_shaders();
  if (workspace_.problem == shader_problem_) workspace_.problem.clear();
  shader_problem_.clear();
}

void Viewer::draw_what_is_due() {
  if (interface_.recording.advance(workspace_)) {  // it draws for itself
    is_drawn_ = true;
  } else if (workspace_.advance(now_s()) || drawn_for_ != picture_area()) {
    if (drawn_for_ == glm::uvec2(0)) show();  // the panels, before the first picture is there
    draw();
  } else if (now_s() - moved_s_ > kRestSeconds && !moves() && workspace_.resolution.rest()) {
    workspace_.change();
  } else if (workspace_.compares && is_drawn_ && !workspace_.playback.playing() && !dragging_) {
    workspace_.measure_accuracy();
  }
  if (!is_drawn_) return;  // there is nothing to ask about
  interface_.crosshair.update(workspace_, now_s());
  interface_.account_a.update(workspace_, workspace_.a, now_s());
  interface_.account_b.update(workspace_, workspace_.b, now_s());
}

void Viewer::draw() {
  if (moves()) workspace_.resolution.move();
  drawn_for_ = picture_area();
  is_drawn_ = false;  // unless that ends well
  workspace_.draw(drawn_for_);
  is_drawn_ = true;
  moved_s_ = now_s();
  note_whole();
  interface_.recording.note(workspace_);
  if (moves() && workspace_.resolution.learn(workspace_.frame_ms())) workspace_.change();
}

/// A picture is likely to follow soon.
bool Viewer::moves() const {
  return workspace_.playback.playing() || held_;
}

void Viewer::react_to(const WindowInput& input) {
  if (!overlay_.takes_keys())
    for (const KeyPress& pressed : input.keys) press(pressed, interface_);
  if (input.wants_to_close) close_window(interface_);
  held_ = window_.holds(Button::kLeft) || window_.holds(Button::kMiddle) || window_.holds(Button::kRight);
  dragging_ = held_ && !overlay_.takes_pointer();
  if (!held_) starts_drag_ = true;
  if (!held_) drags_divider_ = false;
  if (!window_.holds(Button::kLeft)) let_go_of_instance(interface_);
  if (!overlay_.takes_pointer()) {
    drag_divider(input);
    drag_effect(input);
    move_camera(input);
    for (const WindowInput::Click& click : input.clicks) react_to(click);
    if (clicked_ && now_s() - clicked_s_ > kDoubleClickSeconds) {
      place_crosshair(*clicked_);
      clicked_.reset();
    }
    if (window_.holds(key('P')) && !overlay_.takes_keys()) place_crosshair(window_.pointer());
  }
  fly(std::min(now_s() - last_s_, kLongestStep));
  last_s_ = now_s();
}

void Viewer::drag_divider(const WindowInput& input) {
  if (workspace_.comparison() != Comparison::kSplit) return;
  const glm::vec2 pointer = window_.pointer(), moved = input.drag[size_t(Button::kLeft)];
  const float at = area_.corner.x + workspace_.divider * area_.size.x;
  if (moved != glm::vec2(0) && std::abs(pointer.x - moved.x - at) < kDividerReach) drags_divider_ = true;
  if (drags_divider_)
    workspace_.divider = std::clamp((pointer.x - area_.corner.x) / area_.size.x, 0.0f, 1.0f);
}

void Viewer::drag_effect(const WindowInput& input) {
  if (drags_divider_ || input.drag[size_t(Button::kLeft)] == glm::vec2(0)) return;
  if (interface_.effects.held || (starts_drag_ && grab_instance(interface_, window_.pressed_at())))
    drag_instance(interface_, window_.pointer(), window_.holds(Key::kLeftShift));
  starts_drag_ = false;
}

/// The crosshair's panel takes room from the picture when it opens, so it waits until it is no double click.
void Viewer::react_to(const WindowInput::Click& click) {
  const glm::vec2 share = (click.at - area_.corner) / area_.size;
  if (!interface_.effects.placing.empty()) {
    place_effect(interface_, share, window_.holds(Key::kLeftShift));
  } else if (click.is_second) {
    clicked_.reset();
    focus_at(interface_, share);
  } else if (interface_.crosshair.placed()) {
    place_crosshair(click.at);
  } else {
    clicked_ = click.at;
    clicked_s_ = now_s();
  }
}

void Viewer::place_crosshair(glm::vec2 pointer) {
  const glm::vec2 share = (pointer - area_.corner) / area_.size;
  if (glm::any(glm::lessThan(share, glm::vec2(0))) || glm::any(glm::greaterThanEqual(share, glm::vec2(1))))
    return;
  const glm::uvec2 size =
      workspace_.shown() ? workspace_.shown()->size : workspace_.resolution.picture_size(picture_area());
  interface_.crosshair.place(glm::ivec2(glm::floor(share * glm::vec2(size))), size);
}

void Viewer::move_camera(const WindowInput& input) {
  const auto& [left, right, middle] = input.drag;
  if (drags_divider_ || interface_.effects.held ||
      (left == glm::vec2(0) && right == glm::vec2(0) && middle == glm::vec2(0) && input.wheel.y == 0))
    return;
  CameraKey camera = orbit(workspace_.camera(), left * kDegreesPerPixel);
  camera = look(camera, glm::vec2(right.x, -right.y) * kDegreesPerPixel);
  camera = pan(camera, middle / area_.size.y);
  workspace_.set_camera(zoom(camera, input.wheel.y));
}

void Viewer::fly(double seconds) {
  if (!window_.holds(Button::kRight) || overlay_.takes_keys()) return;
  const auto push = [&](char ahead, char back) {
    return float(window_.holds(key(ahead))) - float(window_.holds(key(back)));
  };
  const glm::vec3 way{push('D', 'A'), push('E', 'Q'), push('W', 'S')};
  if (way == glm::vec3(0)) return;
  const float speed = kFlyMetresPerSecond * (window_.holds(Key::kLeftShift) ? kFlyFast : 1.0f);
  workspace_.set_camera(plume::fly(workspace_.camera(), way * speed * float(seconds)));
}

glm::uvec2 Viewer::picture_area() const {
  return glm::max(glm::uvec2(area_.size * window_.pixel_ratio()), glm::uvec2(1));
}

/// A picture is not drawn to its end while shaders are made ready for it; the last one stays.
void Viewer::note_whole() {
  whole_ = {};
  if (workspace_.a.targets) whole_[0] = workspace_.a.targets->display.vk();
  if (workspace_.b.targets) whole_[1] = workspace_.b.targets->display.vk();
}

void Viewer::note_overlay() {
  overlays_ms_.push_back(overlay_ms_);
  if (now_s() - overlays_since_s_ < 1.0) return;
  interface_.overlay_cpu_ms = summarise(overlays_ms_).median;
  overlays_ms_.clear();
  overlays_since_s_ = now_s();
}

void Viewer::tell(const gpu::Preparing& preparing) {
  window_.wait(0);
  if (now_s() - told_s_ < kTellSeconds || !overlay_.is_whole() || window_.size() == glm::uvec2(0)) return;
  Notice notice{.text = fmt::format("preparing shaders: {}", preparing.what),
                .middle = area_.corner + 0.5f * area_.size};
  if (preparing.total > 0) {
    notice.share = float(preparing.done) / float(preparing.total);
    notice.text += fmt::format(" ({} of {} passes)", preparing.done, preparing.total);
  }
  show(&notice);
  told_s_ = now_s();
}

bool Viewer::show(const Notice* notice) {
  const float ratio = window_.pixel_ratio();
  const glm::uvec2 area = picture_area();
  const auto& sequence = interface_.recording.sequence();  // whose pictures have a shape of their own
  const glm::uvec2 size = sequence ? fitted(sequence->options().size, area) : area;
  const glm::ivec2 corner = glm::ivec2(area_.corner * ratio) + glm::ivec2((area - size) / 2u);
  const auto columns = [&](float from, float to) {
    const int32_t first = int32_t(std::lround(from * float(size.x))),
                  last = int32_t(std::lround(to * float(size.x)));
    return vk::Rect2D{{corner.x + first, corner.y}, {uint32_t(std::max(last - first, 0)), size.y}};
  };
  std::vector<PlacedPicture> pictures;
  const bool split = workspace_.comparison() == Comparison::kSplit;
  const float border = split ? workspace_.divider : workspace_.shows(workspace_.a) ? 1.0f : 0.0f;
  const auto is_shown = [&](const std::optional<Targets>& targets, vk::Image whole) {
    return targets && (!notice || targets->display.vk() == whole);
  };
  if (border > 0 && is_shown(workspace_.a.targets, whole_[0]))
    pictures.push_back({&workspace_.a.targets->display, 0, border, columns(0, border)});
  if (border < 1 && is_shown(workspace_.b.targets, whole_[1]))
    pictures.push_back({&workspace_.b.targets->display, border, 1, columns(border, 1)});
  return swapchain_.show(window_.size(),
                         [&](const vk::raii::CommandBuffer& commands, const WindowImage& image) {
                           record_composition(commands, pictures, image);
                           const double before_ms = thread_cpu_ms();
                           overlay_.record(commands, image, notice);
                           overlay_ms_ += thread_cpu_ms() - before_ms;
                         });
}

void Viewer::save_picture(const std::filesystem::path& path) const {
  if (!workspace_.a.targets)
    throw std::runtime_error("--screenshot: the window was closed before anything was drawn");
  write_png(path, read_picture(workspace_.device(), *workspace_.a.targets).display);
}

void Viewer::place_crosshair(glm::dvec2 direction, std::vector<std::string> others) {
  interface_.crosshair.place(direction);
  interface_.crosshair.ask_of_others(workspace_, std::move(others));
}

void Viewer::save_crosshair(const std::filesystem::path& path) const {
  const Crosshair& crosshair = interface_.crosshair;
  if (!crosshair.told() || !crosshair.stale_because(workspace_).empty())
    throw std::runtime_error("--dump: the window was closed before the crosshair was answered");
  const std::string text = to_json(*crosshair.told()).dump(2) + "\n";
  write_file(path, text);
}

double Viewer::now_s() const {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
}

double Viewer::idle_s() const {
  const bool hidden = window_.size() == glm::uvec2(0);
  const bool due = workspace_.is_outdated() || workspace_.always_draw || dragging_ ||
                   interface_.recording.sequence().has_value();
  if (hidden || (!due && !workspace_.playback.playing())) return kIdleSeconds;
  return !due ? workspace_.playback.seconds_to_next(now_s()) : 0.0;
}

}  // namespace plume
