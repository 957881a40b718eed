#include "sandbox/debugger/scene_panel.h"

#include <imgui.h>

#include <algorithm>

#include "sandbox/debugger/effects_panel.h"
#include "sandbox/debugger/file_questions.h"
#include "sandbox/debugger/preset_picker.h"
#include "sandbox/debugger/widget_places.h"
#include "sandbox/debugger/widgets.h"
#include "sandbox/measure/image_io.h"
#include "sandbox/measure/small_picture.h"
#include "sandbox/workspace/shown_picture.h"

namespace plume {
namespace {

constexpr const char* kNaming = "Save the scene as";

/// What opens the list: the scene's picture, its name and what it is.
void pick_scene(Interface& interface) {
  Workspace& workspace = interface.workspace;
  const Scene& scene = workspace.scene();
  const float line = ImGui::GetTextLineHeight(), height = 4 * line;
  const float width = height * float(kPictureSize.x) / float(kPictureSize.y);
  if (ImGui::Button("##scene", {-1, height + 2 * ImGui::GetStyle().FramePadding.y}))
    ImGui::OpenPopup("scenes");
  name_widget("scene = " + scene.id);
  tooltip("Shows another scene.\n\n" + scene.name + "\n" + scene.description);
  ImVec2 from = ImGui::GetItemRectMin();
  const ImVec2 padding = ImGui::GetStyle().FramePadding, end = ImGui::GetItemRectMax();
  const auto picked = pick_preset(
      "scenes", {.kind = PresetKind::kScene, .current = scene.id, .recent = interface.settings.recent_scenes},
      workspace.library(), interface.gallery);
  from = {from.x + padding.x, from.y + padding.y};
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const std::string name = scene.file.empty() ? scene.id : scene.file;
  interface.gallery.draw(draw, PresetKind::kScene, name, from, {from.x + width, from.y + height});
  const float x = from.x + width + 2 * padding.x;
  draw.PushClipRect({x, from.y}, end, true);
  const PresetDocument* document = workspace.scene_document();
  const bool differs = document && document->is_changed();
  const ImU32 ink = ImGui::GetColorU32(ImGuiCol_Text), dim = ImGui::GetColorU32(ImGuiCol_TextDisabled);
  draw.AddText({x, from.y}, ink, (scene.id + (differs ? " *" : "")).c_str());
  draw.AddText({x, from.y + line}, dim, scene.name.c_str());
  if (differs) draw.AddText({x, from.y + 2 * line}, ink, "not saved");
  draw.AddText({x, from.y + 3 * line}, dim, "click: all scenes");
  draw.PopClipRect();
  if (!picked) return;
  try {
    workspace.open_scene(*picked);
    interface.effects = {};
  } catch (const std::exception& problem) {
    workspace.problem = problem.what();
  }
}

void commands(Interface& interface) {
  Workspace& workspace = interface.workspace;
  const PresetDocument* document = workspace.scene_document();
  const std::string file = workspace.scene().file;
  using enum OpenDocuments::OnDisk;
  const auto on_disk = document ? workspace.scenes.on_disk(file) : kSame;
  const bool differs = document && (document->is_changed() || on_disk != kSame);
  const auto button = [](const std::string& name, bool enabled, const std::string& help) {
    ImGui::BeginDisabled(!enabled);
    const bool pressed = ImGui::Button(name.c_str());
    ImGui::EndDisabled();
    name_widget(name + " scene");
    tooltip(help);
    ImGui::SameLine();
    return pressed;
  };
  if (button("save", differs, "Writes " + file + " (Ctrl+S)")) save(interface, workspace.scenes, file);
  if (button("save as", document, "Writes it under another name (Ctrl+Shift+S)"))
    interface.naming.asked = true;
  if (button("revert", differs, "What is on disk, as one step of undo")) {
    try {
      workspace.scenes.reload(file);
    } catch (const std::exception& problem) {
      workspace.problem = problem.what();
    }
  }
  if (button("camera", workspace.has_own_camera(),
             "Follow the camera of the scene again (C). Drag in the picture to take it over."))
    workspace.follow_scene_camera();
  ImGui::NewLine();
  if (on_disk == kChanged)
    warning(
        "The file was changed by another program, and so were you changing it here: save writes over the "
        "file, "
        "revert takes what is there.");
  if (on_disk == kGone) warning("The file is gone; save writes it anew.");
  if (document && !document->diagnostics().empty()) {
    std::string words = "The file has mistakes; the last good scene is shown:";
    for (const Diagnostic& mistake : document->diagnostics()) words += "\n" + to_string(mistake);
    warning(words);
  }
}

/// The picture that is shown becomes that of the new scene.
void save_picture_of(Workspace& workspace, const std::filesystem::path& scene) {
  if (!workspace.shown()) return;
  const std::filesystem::path file = picture_path(PresetKind::kScene, scene);
  make_folder(file.parent_path());
  write_png(file, small_picture(shown_picture(workspace), kPictureSize));
}

}  // namespace

void ask_for_scene_name(Interface& interface) {
  SceneNaming& naming = interface.naming;
  Workspace& workspace = interface.workspace;
  if (naming.asked && workspace.scene_document()) {
    naming = {};
    const std::string id = workspace.scene().id.substr(0, naming.typed.size() - 3) + "_2";
    std::ranges::copy(id, naming.typed.begin());
    ImGui::OpenPopup(kNaming);
  }
  naming.asked = false;
  if (!begin_question(kNaming)) return;
  text("The scene as it is now, with what is shown as its picture, goes to\n" +
       (workspace.library().root() / "scenes").string() + " under the name");
  if (ImGui::IsWindowAppearing()) ImGui::SetKeyboardFocusHere();
  ImGui::SetNextItemWidth(28 * ImGui::GetFontSize());
  bool saves = ImGui::InputText("##name", naming.typed.data(), naming.typed.size(),
                                ImGuiInputTextFlags_EnterReturnsTrue);
  if (!naming.refused.empty()) warning(naming.refused);
  saves |= ImGui::Button("Save");
  name_widget("save as name");
  ImGui::SameLine();
  if (ImGui::Button("Cancel") || pressed_escape()) ImGui::CloseCurrentPopup();
  if (saves) {
    try {
      workspace.save_scene_as(naming.typed.data());
      save_picture_of(workspace, workspace.scene().file);
      interface.gallery.forget(PresetKind::kScene, workspace.scene().file);
      interface.gallery.forget(PresetKind::kScene, workspace.scene().id);
      ImGui::CloseCurrentPopup();
    } catch (const std::exception& problem) {
      naming.refused = problem.what();
    }
  }
  ImGui::EndPopup();
}

void scene_panel(Interface& interface) {
  pick_scene(interface);
  commands(interface);
}

}  // namespace plume
