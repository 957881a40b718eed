#include "sandbox/debugger/keys.h"

#include <imgui.h>

#include <algorithm>
#include <array>

#include "sandbox/debugger/effects_panel.h"
#include "sandbox/debugger/file_questions.h"
#include "sandbox/debugger/instance_marks.h"
#include "sandbox/debugger/widgets.h"

namespace plume {
namespace {

/// Skips what this device cannot run.
void next_method(Workspace& workspace, Side& side) {
  size_t next = side.current;
  do next = (next + 1) % side.methods.size();
  while (next != side.current && !side.methods[next].method->missing(workspace.device()).empty());
  workspace.choose_method(side, next);
}

void step(Workspace& workspace, int ticks) {
  const uint32_t before = workspace.playback.tick();
  if (ticks < 0)
    workspace.playback.step_back();
  else
    workspace.playback.step_forward();
  if (workspace.playback.tick() != before) workspace.change();
}

/// Of an arrow: moves the crosshair, where one is placed.
bool nudge(Interface& interface, glm::ivec2 pixels) {
  if (!interface.crosshair.placed() || !interface.workspace.shown()) return false;
  interface.crosshair.move(pixels, interface.workspace.shown()->size);
  return true;
}

void go_to(Workspace& workspace, uint32_t tick) {
  workspace.playback.go_to(tick);
  workspace.change();
}

void turn(Workspace& workspace, Comparison comparison) {
  workspace.compare(workspace.comparison() == comparison ? Comparison::kNone : comparison);
}

void scale_text(Interface& interface, float by) {
  interface.text_scale = std::clamp(interface.text_scale + by, kSmallestText, kLargestText);
}

struct Action {
  KeyPress press;
  const char* name;  ///< of the key
  const char* help;
  void (*act)(Interface&);
};

constexpr std::array kActions{
    Action{{Key::kSpace}, "Space", "play, pause", [](Interface& i) { i.workspace.playback.toggle(); }},
    Action{{key(',')}, "Comma", "one tick back", [](Interface& i) { step(i.workspace, -1); }},
    Action{{key('.')}, "Period", "one tick on", [](Interface& i) { step(i.workspace, 1); }},
    Action{{Key::kLeft},
           "Left",
           "with a crosshair, a pixel to the left; without, one tick back",
           [](Interface& i) {
             if (!nudge(i, {-1, 0})) step(i.workspace, -1);
           }},
    Action{{Key::kRight},
           "Right",
           "with a crosshair, a pixel to the right; without, one tick on",
           [](Interface& i) {
             if (!nudge(i, {1, 0})) step(i.workspace, 1);
           }},
    Action{{Key::kUp},
           "Up",
           "the crosshair a pixel up",
           [](Interface& i) {
             nudge(i, {0, -1});
           }},
    Action{{Key::kDown},
           "Down",
           "the crosshair a pixel down",
           [](Interface& i) {
             nudge(i, {0, 1});
           }},
    Action{{Key::kHome}, "Home", "first tick", [](Interface& i) { go_to(i.workspace, 0); }},
    Action{{Key::kEnd},
           "End",
           "last tick",
           [](Interface& i) { go_to(i.workspace, i.workspace.playback.last_tick()); }},
    Action{{key('M')}, "M", "next method", [](Interface& i) { next_method(i.workspace, i.workspace.a); }},
    Action{{key('M'), true},
           "Shift+M",
           "next method on side B",
           [](Interface& i) { next_method(i.workspace, i.workspace.b); }},
    Action{{key('X')},
           "X",
           "method B in the place of A, and back",
           [](Interface& i) { turn(i.workspace, Comparison::kFlip); }},
    Action{{key('V')},
           "V",
           "split view: A to the left, B to the right; drag the divider",
           [](Interface& i) { turn(i.workspace, Comparison::kSplit); }},
    Action{
        {key('C')}, "C", "the scene's camera again", [](Interface& i) { i.workspace.follow_scene_camera(); }},
    Action{{key('F')},
           "F",
           "frame the selected instance; without one, turn about what is under the pointer",
           focus_or_frame},
    Action{{Key::kDelete}, "Delete", "take the selected instance out of the scene", remove_instance},
    Action{{key('R')},
           "R",
           "adapt the resolution to the rate, or hold it",
           [](Interface& i) { i.workspace.resolution.adapts = !i.workspace.resolution.adapts; }},
    Action{{key('Z'), false, true},
           "Ctrl+Z",
           "undo an edit of the scene or the selected effect, whichever was last",
           undo_edit},
    Action{{key('Z'), true, true}, "Ctrl+Shift+Z", "redo it", redo_edit},
    Action{{key('S'), false, true}, "Ctrl+S", "save the selected effect and the scene", save_edits},
    Action{{key('S'), true, true},
           "Ctrl+Shift+S",
           "save the scene under another name",
           [](Interface& i) { i.naming.asked = true; }},
    Action{{key('R'), false, true},
           "Ctrl+R",
           "record the session as a replay; again: stop and save",
           [](Interface& i) { i.recording.toggle(i.workspace); }},
    Action{{Key::kF12},
           "F12",
           "save the picture, without the panels",
           [](Interface& i) { i.recording.save_picture(i.workspace); }},
    Action{{key('='), false, true}, "Ctrl+=", "larger text", [](Interface& i) { scale_text(i, 0.125f); }},
    Action{{key('-'), false, true}, "Ctrl+-", "smaller text", [](Interface& i) { scale_text(i, -0.125f); }},
    Action{{Key::kTab}, "Tab", "hide and show the panels", [](Interface& i) { i.panels = !i.panels; }},
    Action{{Key::kF1}, "F1", "this list", [](Interface& i) { i.help = !i.help; }},
    Action{{Key::kF11}, "F11", "full screen", [](Interface& i) { i.full_screen = !i.full_screen; }},
    Action{{key('Q'), false, true}, "Ctrl+Q", "quit", close_window},
    Action{{Key::kEscape},
           "Esc",
           "close a list or a question, drop nothing; else take the crosshair away; else quit",
           [](Interface& i) {
             if (i.help || !i.workspace.problem.empty() || !i.effects.placing.empty())
               i.help = false, i.workspace.problem.clear(), i.effects.placing.clear();
             else if (i.crosshair.placed())
               i.crosshair.remove(i.workspace);
             else
               close_window(i);
           }},
};

constexpr std::array<std::pair<const char*, const char*>, 9> kPointer{{
    {"click", "place the crosshair: what is at that pixel"},
    {"double click", "turn about what is there, and select the effect whose that is"},
    {"drag the ring", "of an instance: move it; with Shift, up and down"},
    {"P held", "the crosshair follows the pointer"},
    {"left drag", "orbit round the target"},
    {"middle drag", "pan"},
    {"right drag", "look round; with it held W A S D Q E fly, Shift faster"},
    {"wheel", "nearer, farther"},
    {"Ctrl+click on a slider", "type a value"},
}};

void row(const char* key, const char* help) {
  cell(key);
  cell(help);
}

}  // namespace

void press(const KeyPress& pressed, Interface& interface) {
  const auto action = std::ranges::find(kActions, pressed, &Action::press);
  if (action != kActions.end()) action->act(interface);
}

void describe_keys(Interface& interface) {
  if (!interface.help) return;
  const ImVec2 window = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos({0.5f * window.x, 0.5f * window.y}, ImGuiCond_Appearing, {0.5f, 0.5f});
  ImGui::SetNextWindowSizeConstraints({0, 0}, {window.x, 0.98f * window.y});  // beyond, it scrolls
  ImGui::SetNextWindowBgAlpha(1);
  if (ImGui::Begin("Keys", &interface.help,
                   ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoSavedSettings) &&
      ImGui::BeginTable("keys", 2, ImGuiTableFlags_SizingFixedFit | ImGuiTableFlags_RowBg)) {
    for (const Action& action : kActions) row(action.name, action.help);
    for (const auto& [what, help] : kPointer) row(what, help);
    ImGui::EndTable();
  }
  ImGui::End();
}

}  // namespace plume
