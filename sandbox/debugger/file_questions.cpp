#include "sandbox/debugger/file_questions.h"

#include <fmt/format.h>
#include <imgui.h>

#include "sandbox/debugger/widget_places.h"
#include "sandbox/debugger/widgets.h"

namespace plume {
namespace {

constexpr const char* kConflict = "Save over another change?";
constexpr const char* kUnsaved = "Save before closing?";
bool answer(const char* name, const char* help) {
  const bool given = ImGui::Button(name, {ImGui::GetFontSize() * 9, 0});
  name_widget(name);
  tooltip(help);
  ImGui::SameLine();
  return given;
}

void ask_about_conflict(Interface& interface) {
  FileQuestions& asked = interface.questions;
  if (asked.conflict && !ImGui::IsPopupOpen(kConflict)) ImGui::OpenPopup(kConflict);
  if (!begin_question(kConflict)) return;
  if (!asked.conflict) {
    ImGui::CloseCurrentPopup();
    return ImGui::EndPopup();
  }
  const auto [documents, name] = *asked.conflict;
  text(fmt::format("{}\nis not as it was when it was read: another program has changed it, or it is gone.",
                   documents->open(name).path().string()));
  ImGui::Spacing();
  const bool mine = answer("Save mine", "Writes over what another program wrote.");
  const bool theirs = answer("Take theirs", "Reads the file; what you had is one undo away.");
  if (answer("Cancel", "Goes on without saving. (Esc)") || pressed_escape() || mine || theirs) {
    try {
      if (mine) documents->save(name, PresetDocument::OverChanges::kOverwrite);
      if (theirs) documents->reload(name);
    } catch (const std::exception& problem) {
      interface.workspace.problem = problem.what();
    }
    if (!mine && !theirs) asked.closing = false;
    asked.conflict.reset();
  }
  ImGui::EndPopup();
}

/// True when nothing is left to save.
bool save_all(Interface& interface) {
  Workspace& workspace = interface.workspace;
  for (OpenDocuments* documents : {&workspace.scenes, &workspace.documents})
    for (const std::string& name : documents->unsaved())
      if (!save(interface, *documents, name)) return false;
  return true;
}

void ask_before_closing(Interface& interface) {
  FileQuestions& asked = interface.questions;
  const bool due = asked.closing && !asked.conflict;
  if (due && unsaved(interface.workspace).empty()) interface.closing = true;  // the last was in conflict
  if (due && !ImGui::IsPopupOpen(kUnsaved)) ImGui::OpenPopup(kUnsaved);
  if (!begin_question(kUnsaved)) return;
  if (!asked.closing) {
    ImGui::CloseCurrentPopup();
    return ImGui::EndPopup();
  }
  text("These were changed and are not saved:");
  for (const std::string& what : unsaved(interface.workspace)) ImGui::BulletText("%s", what.c_str());
  ImGui::Spacing();
  const bool saves = answer("Save", "Saves all of them and closes the window. (Enter)") || pressed_enter();
  const bool discards = answer("Discard", "Closes the window; the files stay as they are.");
  const bool stays = answer("Cancel", "Goes on working. (Esc)") || pressed_escape();
  if (saves) interface.closing = save_all(interface);
  if (discards) interface.closing = true;
  if (saves || discards || stays) {
    asked.closing = asked.conflict.has_value();  // goes on once that is decided
    ImGui::CloseCurrentPopup();
  }
  ImGui::EndPopup();
}

}  // namespace

std::vector<std::string> unsaved(Workspace& workspace) {
  std::vector<std::string> names;
  for (const std::string& file : workspace.scenes.unsaved())
    names.push_back("scene " + std::filesystem::path(file).stem().string());
  for (const std::string& name : workspace.documents.unsaved()) names.push_back("effect " + name);
  return names;
}

bool save(Interface& interface, OpenDocuments& documents, const std::string& name) {
  try {
    documents.save(name, PresetDocument::OverChanges::kRefuse);
    return true;
  } catch (const ChangedOnDisk&) {
    interface.questions.conflict = {&documents, name};
  } catch (const std::exception& problem) {
    interface.workspace.problem = problem.what();
  }
  return false;
}

void close_window(Interface& interface) {
  if (unsaved(interface.workspace).empty())
    interface.closing = true;
  else
    interface.questions.closing = true;
}

void ask_about_files(Interface& interface) {
  ask_about_conflict(interface);
  ask_before_closing(interface);
}

}  // namespace plume
