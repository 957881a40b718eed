#include "sandbox/debugger/instance_marks.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "sandbox/debugger/effects_panel.h"
#include "sandbox/debugger/widget_places.h"
#include "sandbox/workspace/camera_moves.h"
#include "sandbox/workspace/key_edits.h"
#include "sandbox/workspace/living_particles.h"
#include "sandbox/workspace/seen_place.h"

namespace plume {
namespace {

constexpr ImU32 kInk = IM_COL32(255, 255, 255, 240), kGround = IM_COL32(0, 0, 0, 170);
constexpr float kReach = 12;         // of a hand, screen coordinates round a mark
constexpr double kGrainM = 0.001;    // of places
constexpr float kRingShare = 0.03f;  // of the picture's height

glm::vec2 share_of(glm::vec2 at, Area picture) {
  return (at - picture.corner) / picture.size;
}
bool is_inside(glm::vec2 share) {
  return glm::all(glm::greaterThanEqual(share, glm::vec2(0))) && glm::all(glm::lessThan(share, glm::vec2(1)));
}
ImVec2 on_screen(glm::vec2 share, Area picture) {
  const glm::vec2 at = picture.corner + share * picture.size;
  return {at.x, at.y};
}
std::optional<ImVec2> on_screen(const shared::ViewData& view, glm::vec3 point, Area picture) {
  const auto share = place_of(view, point);
  if (!share || glm::length(*share - 0.5f) > 10) return {};  // far outside, where lines become endless
  return on_screen(*share, picture);
}

void words_at(ImDrawList& draw, ImVec2 at, const std::string& words) {
  const ImVec2 size = ImGui::CalcTextSize(words.c_str());
  const float margin = 0.3f * ImGui::GetFontSize();
  draw.AddRectFilled({at.x - margin, at.y - margin}, {at.x + size.x + margin, at.y + size.y + margin},
                     kGround, margin);
  draw.AddText(at, kInk, words.c_str());
}

/// White on black, so that it is seen on fire and on smoke.
void line(ImDrawList& draw, std::span<const ImVec2> points, bool closed) {
  const auto flags = closed ? ImDrawFlags_Closed : ImDrawFlags_None;
  draw.AddPolyline(points.data(), int(points.size()), kGround, flags, 4);
  draw.AddPolyline(points.data(), int(points.size()), kInk, flags, 1.5f);
}

/// A ring that lies on a surface, with a stalk along its normal; as large on screen wherever it is.
void ring(ImDrawList& draw, const shared::ViewData& view, const SurfacePoint& at, Area picture) {
  constexpr int kSides = 32;
  const float depth = glm::dot(at.position - view.camera, view.forward);
  const float radius = 2 * kRingShare * depth * view.tan_half_fov.y;
  const glm::vec3 aside = std::abs(at.normal.y) < 0.9f ? glm::vec3(0, 1, 0) : glm::vec3(1, 0, 0);
  const glm::vec3 u = glm::normalize(glm::cross(aside, at.normal)), v = glm::cross(at.normal, u);
  std::vector<ImVec2> points;
  for (int i = 0; i < kSides; ++i) {
    const float angle = 2 * std::numbers::pi_v<float> * float(i) / kSides;
    const auto point =
        on_screen(view, at.position + radius * (std::cos(angle) * u + std::sin(angle) * v), picture);
    if (!point) return;
    points.push_back(*point);
  }
  line(draw, points, true);
  const auto foot = on_screen(view, at.position, picture);
  const auto tip = on_screen(view, at.position + 1.6f * radius * at.normal, picture);
  if (foot && tip) line(draw, std::array{*foot, *tip}, false);
}

void mark_placing(Interface& interface, ImDrawList& draw, Area picture) {
  Workspace& workspace = interface.workspace;
  const ImVec2 pointer = ImGui::GetIO().MousePos;
  const glm::vec2 share = share_of({pointer.x, pointer.y}, picture);
  if (ImGui::GetIO().WantCaptureMouse || !is_inside(share)) return;
  const float gap = 1.2f * ImGui::GetFontSize();
  const auto surface = workspace.surface_at(share);
  if (surface) {
    ring(draw, workspace.drawn_view(), *surface, picture);
    return words_at(draw, {pointer.x + gap, pointer.y + gap},
                    interface.effects.placing +
                        "\nclick: it starts here, at this tick\nShift+click: several; "
                        "Esc: none");
  }
  const float r = 0.5f * gap;
  line(draw, std::array{ImVec2{pointer.x - r, pointer.y - r}, ImVec2{pointer.x + r, pointer.y + r}}, false);
  line(draw, std::array{ImVec2{pointer.x - r, pointer.y + r}, ImVec2{pointer.x + r, pointer.y - r}}, false);
  words_at(draw, {pointer.x + gap, pointer.y + gap}, "nothing to stand on here");
}

void mark_selected(Interface& interface, ImDrawList& draw, Area picture) {
  const Workspace& workspace = interface.workspace;
  const auto index = selected_instance(interface);
  if (!index || !workspace.shown()) return;
  const Instance& instance = workspace.scene().instances[*index];
  const shared::ViewData view = workspace.drawn_view();
  const glm::vec3 place = instance.position;  // at its call; it may travel from there
  const auto at = on_screen(view, place, picture);
  if (!at || !is_inside(share_of({at->x, at->y}, picture))) return;
  ring(draw, view, {place, {0, 1, 0}}, picture);
  std::string words = instance.name;
  if (interface.effects.held)
    words += fmt::format("\n{:.3f}, {:.3f}, {:.3f}", place.x, place.y, place.z);
  else if (instance.call_tick && workspace.playback.tick() <= *instance.call_tick)
    words += fmt::format("\nstarts at tick {}", *instance.call_tick);
  const float gap = 0.8f * ImGui::GetFontSize();
  words_at(draw, {at->x + gap, at->y + gap}, words);
  name_place("mark of " + instance.name, {at->x, at->y});
}

}  // namespace

void mark_instances(Interface& interface, Area picture) {
  ImDrawList& draw = *ImGui::GetBackgroundDrawList();
  draw.PushClipRect({picture.corner.x, picture.corner.y},
                    {picture.corner.x + picture.size.x, picture.corner.y + picture.size.y});
  if (interface.effects.placing.empty())
    mark_selected(interface, draw, picture);
  else if (interface.workspace.shown())
    mark_placing(interface, draw, picture);
  draw.PopClipRect();
}

bool place_effect(Interface& interface, glm::vec2 place, bool goes_on) {
  std::string& placing = interface.effects.placing;
  if (placing.empty()) return false;
  Workspace& workspace = interface.workspace;
  try {
    if (!workspace.drop_effect(placing, place)) return true;  // the mark says that there is only sky
    select_instance(interface, workspace.scene().instances.size() - 1);
    if (!goes_on) placing.clear();
  } catch (const std::exception& problem) {
    workspace.problem = problem.what();
    placing.clear();
  }
  return true;
}

bool grab_instance(Interface& interface, glm::vec2 at) {
  Workspace& workspace = interface.workspace;
  const auto index = selected_instance(interface);
  if (!index || !workspace.shown() || !workspace.scene_document() || !interface.effects.placing.empty())
    return false;
  const glm::vec3 place = workspace.scene().instances[*index].position;
  const auto mark = on_screen(workspace.drawn_view(), place, interface.picture);
  if (!mark || glm::length(glm::vec2(mark->x, mark->y) - at) > kReach) return false;
  interface.effects.held = HeldInstance{.place = place, .off = glm::vec2(mark->x, mark->y) - at};
  return true;
}

void drag_instance(Interface& interface, glm::vec2 to, bool upright) {
  Workspace& workspace = interface.workspace;
  const auto index = selected_instance(interface);
  std::optional<HeldInstance>& held = interface.effects.held;
  if (!index || !held) return;
  const shared::ViewData view = workspace.drawn_view();
  const glm::vec3 facing = glm::vec3(-view.forward.x, 0, -view.forward.z);
  const auto wanted = on_plane(view, share_of(to + held->off, interface.picture), held->place,
                               upright ? facing : glm::vec3(0, 1, 0));
  if (!wanted) return;
  glm::vec3 place = held->place;
  for (int axis = 0; axis < 3; ++axis)
    if (upright == (axis == 1)) place[axis] = rounded((*wanted)[axis], kGrainM) + 0.0f;
  held->place = place;
  PresetDocument& document = *workspace.scene_document();
  const auto outcome =
      document.set(fmt::format("instance[{}].position", *index), place, PresetDocument::Gesture::kGoesOn);
  if (!outcome.made && !outcome.diagnostics.empty())
    workspace.problem = to_string(outcome.diagnostics.front());
}

void let_go_of_instance(Interface& interface) {
  if (!interface.effects.held) return;
  interface.effects.held.reset();
  if (PresetDocument* document = interface.workspace.scene_document()) document->end_gesture();
}

void remove_instance(Interface& interface) {
  const auto index = selected_instance(interface);
  PresetDocument* document = interface.workspace.scene_document();
  if (!index || !document) return;
  const auto outcome = document->remove(fmt::format("instance[{}]", *index));
  if (outcome.made)
    interface.effects = {};
  else if (!outcome.diagnostics.empty())
    interface.workspace.problem = to_string(outcome.diagnostics.front());
}

void focus_at(Interface& interface, glm::vec2 place) {
  Workspace& workspace = interface.workspace;
  if (!is_inside(place)) return;
  const auto seen = seen_at(workspace, place);
  if (!seen) return;
  workspace.set_camera(focus(workspace.camera(), seen->position));
  const auto& instances = workspace.scene().instances;
  const auto whose = std::ranges::find(instances, seen->instance, &Instance::name);
  if (whose != instances.end()) select_instance(interface, size_t(whose - instances.begin()));
}

void focus_or_frame(Interface& interface) {
  Workspace& workspace = interface.workspace;
  if (const auto index = selected_instance(interface)) {
    const Ball ball = ball_round(workspace.stage(), *index);
    return workspace.set_camera(frame(workspace.camera(), ball.centre, ball.radius_m,
                                      interface.picture.size.x / interface.picture.size.y));
  }
  const ImVec2 pointer = ImGui::GetIO().MousePos;
  if (!ImGui::GetIO().WantCaptureMouse)
    focus_at(interface, share_of({pointer.x, pointer.y}, interface.picture));
}

}  // namespace plume
