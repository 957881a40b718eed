#include "sandbox/debugger/effects_panel.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <imgui.h>

#include <algorithm>
#include <array>

#include "sandbox/debugger/depth_ruler.h"
#include "sandbox/debugger/field_editor.h"
#include "sandbox/debugger/widget_places.h"
#include "sandbox/debugger/widgets.h"

namespace plume {
namespace {

constexpr float kTreeLines = 10;  // of the hierarchy, at most
constexpr size_t kFew = 3;        // instances that need not be opened by hand
constexpr const char* kConflict = "Save over another change?";
constexpr const char* kUnsaved = "Effects are not saved";

PresetDocument* document_of(Interface& interface) {
  const std::string& name = interface.effects.name;
  if (name.empty()) return nullptr;
  try {
    return &interface.workspace.documents.open(name);
  } catch (const std::exception& problem) {
    interface.workspace.problem = problem.what();
    interface.effects.name.clear();
    return nullptr;
  }
}

void select(EffectSelection& selection, const Instance& instance, size_t index,
            std::optional<size_t> emitter) {
  if (selection.name != instance.effect) selection.refused.clear();
  selection.name = instance.effect;
  selection.instance = index;
  selection.emitter = emitter;
}

// ---- who is there ----------------------------------------------------------------------------------------

/// A letter that is large and framed while it is on.
bool switch_button(const char* off, const char* on, bool is_on, const char* help, const std::string& name) {
  if (!is_on) ImGui::PushStyleColor(ImGuiCol_Button, {0, 0, 0, 0});
  ImGui::PushStyleVar(ImGuiStyleVar_FrameBorderSize, is_on ? 1.0f : 0.0f);
  const bool pressed = ImGui::SmallButton(is_on ? on : off);
  ImGui::PopStyleVar();
  if (!is_on) ImGui::PopStyleColor();
  name_widget(fmt::format("{} = {}", name, is_on));
  tooltip(help);
  return pressed;
}

void flip(std::set<size_t>& set, size_t member) {
  if (!set.erase(member)) set.insert(member);
}

void switches_of(Workspace& workspace, size_t instance) {
  InstanceSwitches& switches = workspace.switches;
  const std::string& name = workspace.scene().instances[instance].name;
  if (switch_button("s", "S", switches.solo.contains(instance),
                    "Solo: only this one, and others that are solo, as if nothing else were called.",
                    "solo " + name))
    flip(switches.solo, instance);
  ImGui::SameLine(0, 2);
  if (switch_button("m", "M", switches.muted.contains(instance),
                    "Mute: as if the scene did not call it; it is not simulated.", "mute " + name))
    flip(switches.muted, instance);
  ImGui::SameLine(0, 2);
  const auto frozen = switches.frozen.find(instance);
  const std::string help =
      frozen == switches.frozen.end()
          ? "Freeze: its time stands still from this tick on."
          : fmt::format("Frozen: its time stands still from tick {} of the scene on.", frozen->second);
  if (switch_button("f", "F", frozen != switches.frozen.end(), help.c_str(), "freeze " + name)) {
    if (frozen == switches.frozen.end())
      switches.frozen[instance] = workspace.playback.tick();
    else
      switches.frozen.erase(frozen);
  }
}

struct Living {
  uint64_t alive = 0, capacity = 0;
};

Living living_of(const EmitterState& emitter) {
  return {emitter.wanted ? emitter.living() : 0, emitter.schedule.capacity()};
}

/// Filled: awake; a ring: asleep.
void mark(bool awake) {
  const float line = ImGui::GetTextLineHeight(), radius = 0.22f * line;
  const ImVec2 from = ImGui::GetCursorScreenPos();
  const ImVec2 centre{from.x + 0.35f * line, from.y + 0.5f * line};
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  if (awake)
    draw.AddCircleFilled(centre, radius, IM_COL32(120, 220, 120, 255));
  else
    draw.AddCircle(centre, radius, IM_COL32(160, 160, 165, 255));
  ImGui::Dummy({0.7f * line, line});
  ImGui::SameLine(0, 2);
}

std::string cost_text(const InstanceDemand& demand, const std::optional<uint32_t>& local) {
  std::string text = fmt::format("{}: {}", demand.awake ? "awake" : "asleep", demand.why);
  if (local) text += fmt::format("\nits tick: {}", *local);
  text +=
      fmt::format("\n{} ticks simulated, {} saved by sleeping\n{} dispatches\n{:.1f} KiB of particles",
                  demand.ticks_simulated, demand.ticks_saved, demand.dispatches, double(demand.bytes) / 1024);
  if (demand.bytes_saved > 0) text += fmt::format(", {:.1f} KiB saved", double(demand.bytes_saved) / 1024);
  return text;
}

void emitter_row(Interface& interface, size_t instance, uint32_t call, size_t index) {
  const Stage& stage = interface.workspace.stage();
  const Instances& instances = stage.simulation().instances();
  const EmitterState& emitter = instances.emitter_of(call, uint32_t(index));
  EffectSelection& selection = interface.effects;
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  ImGui::PushID(int(index));
  const bool selected = selection.instance == instance && selection.emitter == index;
  ImGui::Indent();
  if (ImGui::Selectable(instances.described(emitter).name.c_str(), selected))
    select(selection, stage.scene().instances[instance], instance, index);
  name_widget(
      fmt::format("{} / {}", stage.scene().instances[instance].name, instances.described(emitter).name));
  ImGui::Unindent();
  const Living living = living_of(emitter);
  cell(emitter.wanted ? fmt::format("{} of {}", living.alive, living.capacity) : "asleep");
  tooltip(fmt::format("{} particles alive, at most {} at once", living.alive, living.capacity));
  ImGui::PopID();
}

void instance_row(Interface& interface, size_t index, const InstanceDemand& demand) {
  Workspace& workspace = interface.workspace;
  const Stage& stage = workspace.stage();
  const Instance& instance = stage.scene().instances[index];
  const std::optional<uint32_t> call = stage.call_of(index);
  EffectSelection& selection = interface.effects;
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  const bool selected =
      selection.name == instance.effect && selection.instance == index && !selection.emitter;
  const auto flags = ImGuiTreeNodeFlags_OpenOnArrow | ImGuiTreeNodeFlags_OpenOnDoubleClick |
                     ImGuiTreeNodeFlags_SpanAvailWidth |
                     (stage.scene().instances.size() <= kFew ? ImGuiTreeNodeFlags_DefaultOpen : 0) |
                     (selected ? ImGuiTreeNodeFlags_Selected : 0) | (call ? 0 : ImGuiTreeNodeFlags_Leaf);
  const bool open = ImGui::TreeNodeEx("instance", flags, "%s", instance.name.c_str());
  name_widget(instance.name);
  if (ImGui::IsItemClicked() && !ImGui::IsItemToggledOpen()) select(selection, instance, index, {});
  const auto local = call ? stage.simulation().instances().calls[*call].clock.local(workspace.playback.tick())
                          : std::nullopt;
  const auto cost = [&] {
    if (wants_tooltip()) tooltip(fmt::format("effect {}\n{}", instance.effect, cost_text(demand, local)));
  };
  cost();
  ImGui::TableNextColumn();
  mark(demand.awake);
  if (demand.awake && call) {
    Living sum;
    for (uint32_t e = 0; e < stage.simulation().instances().calls[*call].described().size(); ++e) {
      const Living one = living_of(stage.simulation().instances().emitter_of(*call, e));
      sum.alive += one.alive, sum.capacity += one.capacity;
    }
    text(fmt::format("{} of {}", sum.alive, sum.capacity));
  } else {
    text(demand.why);
  }
  cost();
  ImGui::TableNextColumn();
  if (instance.call_tick) switches_of(workspace, index);
  if (!open) return;
  if (call)
    for (size_t e = 0; e < stage.simulation().instances().calls[*call].described().size(); ++e)
      emitter_row(interface, index, *call, e);
  ImGui::TreePop();
}

void hierarchy(Interface& interface) {
  const Stage& stage = interface.workspace.stage();
  if (stage.scene().instances.empty()) return note("This scene has no effects.");
  const std::vector<InstanceDemand> demand = stage.demand();
  const InstanceDemand sum = total(demand);
  const auto awake = std::ranges::count(demand, true, &InstanceDemand::awake);
  text(fmt::format("{} of {} awake, {:.2f} MiB of particles", awake, demand.size(),
                   double(sum.bytes) / (1 << 20)));
  tooltip(fmt::format("{} ticks simulated, {} saved by sleeping", sum.ticks_simulated, sum.ticks_saved));
  const ImGuiID rows = ImGui::GetID("rows");  // that there were in the last picture
  const float lines = std::min(float(ImGui::GetStateStorage()->GetInt(rows, 1)) + 0.5f, kTreeLines);
  if (!ImGui::BeginTable("hierarchy", 3,
                         ImGuiTableFlags_ScrollY | ImGuiTableFlags_RowBg | ImGuiTableFlags_BordersOuter |
                             ImGuiTableFlags_Resizable,
                         {0, lines * ImGui::GetTextLineHeightWithSpacing()}))
    return;
  const float em = ImGui::GetFontSize();
  ImGui::TableSetupColumn("name", ImGuiTableColumnFlags_WidthStretch);
  ImGui::TableSetupColumn("state", ImGuiTableColumnFlags_WidthFixed, 8 * em);
  ImGui::TableSetupColumn("switches", ImGuiTableColumnFlags_WidthFixed, 4.2f * em);
  for (size_t i = 0; i < demand.size(); ++i) {
    ImGui::PushID(int(i));
    instance_row(interface, i, demand[i]);
    ImGui::PopID();
  }
  const int shown = ImGui::TableGetRowIndex() + 1;
  ImGui::EndTable();
  ImGui::GetStateStorage()->SetInt(rows, shown);
}

void pick_effect_to_drop(Interface& interface) {
  std::string& placing = interface.effects.placing;
  if (!placing.empty()) {
    text(fmt::format("click in the picture: {} starts there", placing));
    ImGui::SameLine();
    if (ImGui::SmallButton("cancel")) placing.clear();
    return;
  }
  ImGui::SetNextItemWidth(-1);
  if (!ImGui::BeginCombo("##drop", "+ drop an effect into the scene", ImGuiComboFlags_HeightLargest))
    return tooltip("Choose an effect, then click in the picture: it starts there, at this tick.");
  for (const std::string& id : interface.workspace.library().ids(PresetKind::kEffect))
    if (ImGui::Selectable(id.c_str())) placing = id;
  ImGui::EndCombo();
}

// ---- what one of them is ---------------------------------------------------------------------------------

void command_button(const char* name, std::string_view what, const char* key, Interface& interface,
                    void (*act)(Interface&)) {
  ImGui::BeginDisabled(what.empty());
  if (ImGui::Button(name)) act(interface);
  ImGui::EndDisabled();
  tooltip(what.empty() ? fmt::format("({})", key) : fmt::format("{} ({})", what, key));
  ImGui::SameLine();
}

void revert(Interface& interface) {
  try {
    interface.workspace.documents.reload(interface.effects.name);
    interface.effects.refused.clear();
  } catch (const std::exception& problem) {
    interface.workspace.problem = problem.what();
  }
}

void commands(Interface& interface, const PresetDocument& document) {
  const auto on_disk = interface.workspace.documents.on_disk(interface.effects.name);
  const bool differs = document.is_changed() || on_disk != EffectDocuments::OnDisk::kSame;
  command_button("undo", document.undo_name(), "Ctrl+Z", interface, undo_edit);
  command_button("redo", document.redo_name(), "Ctrl+Shift+Z", interface, redo_edit);
  command_button("save", differs ? "Writes " + document.path().string() : "", "Ctrl+S", interface,
                 save_effect);
  command_button("revert", differs ? "What is on disk, as one step of undo" : "", "one step of undo",
                 interface, revert);
  ImGui::Checkbox("only set", &interface.effects.only_set);
  tooltip("Hides fields that the file does not say; the others are written dim, with their default.");
}

/// A bar at the side, so that it is told from what is said by the way.
void warning(const std::string& words) {
  const ImVec2 from = ImGui::GetCursorScreenPos();
  ImGui::Indent(0.6f * ImGui::GetFontSize());
  ImGui::PushStyleColor(ImGuiCol_Text, IM_COL32(255, 190, 120, 255));
  ImGui::PushTextWrapPos(0);
  ImGui::TextUnformatted(words.c_str());
  name_widget("warning = " + words);
  ImGui::PopTextWrapPos();
  ImGui::PopStyleColor();
  ImGui::Unindent(0.6f * ImGui::GetFontSize());
  ImGui::GetWindowDrawList()->AddRectFilled(from, {from.x + 3, ImGui::GetItemRectMax().y},
                                            IM_COL32(255, 150, 60, 255));
}

void warnings(Interface& interface, const PresetDocument& document) {
  const EffectSelection& selection = interface.effects;
  using enum EffectDocuments::OnDisk;
  const auto on_disk = interface.workspace.documents.on_disk(selection.name);
  if (on_disk == kChanged)
    warning(
        "The file was changed by another program, and so were you changing it here: save writes over "
        "the file, revert takes what is there.");
  if (on_disk == kGone) warning("The file is gone; save writes it anew.");
  if (!document.diagnostics().empty()) {
    std::string words = document.effect() ? "The file has mistakes; the last good one runs:" : "Mistakes:";
    for (const Diagnostic& mistake : document.diagnostics()) words += "\n" + to_string(mistake);
    warning(words);
  }
  if (const std::string& refused = interface.workspace.refused_edits(); !refused.empty())
    warning("The scene cannot take this; the last good effect runs:\n" + refused);
  if (!selection.refused.empty()) warning("Not changed: " + selection.refused);
}

/// As an artist works: births, places, ways, looks.
void edit_emitter(const FieldList& list, const std::string& path) {
  constexpr std::array kOrder{"name", "parent", "spawn", "shape", "motion", "look"};
  for (const char* name : kOrder) {
    const auto field = std::ranges::find(list.fields, fmt::format("{}.{}", path, name), &Field::path);
    if (field != list.fields.end()) edit_field(list, *field);
  }
}

void edit_effect(Interface& interface, PresetDocument& document) {
  EffectSelection& selection = interface.effects;
  commands(interface, document);
  warnings(interface, document);
  std::vector<FieldEdit> edits;
  const FieldList list{document.fields(), selection.only_set, edits};
  if (list.fields.empty()) return note("Fields are shown once the file can be read as TOML.");
  ImGui::PushID(selection.name.c_str());
  ImGui::PushStyleVar(ImGuiStyleVar_IndentSpacing, 0.7f * ImGui::GetFontSize());
  const std::string emitter = selection.emitter ? fmt::format("emitter[{}]", *selection.emitter) : "";
  if (selection.emitter && document.field(emitter + ".name")) {
    edit_emitter(list, emitter);
  } else {
    selection.emitter.reset();
    for (const Field& field : list.fields)
      if (field.path.find_first_of(".[") == std::string::npos && field.path != "emitter")
        edit_field(list, field);
    if (ImGui::Button("+ emitter")) edits.push_back({FieldEdit::Kind::kAdd, "emitter"});
    tooltip("A new part, at the end of the list.");
  }
  ImGui::PopStyleVar();
  ImGui::PopID();
  selection.refused = made(document, edits, std::move(selection.refused));
  if (!ImGui::IsAnyItemActive()) document.end_gesture();
}

void depths(Interface& interface) {
  Workspace& workspace = interface.workspace;
  EffectSelection& selection = interface.effects;
  const bool open = ImGui::TreeNodeEx("depth in the picture");
  tooltip(
      "Where in depth the particles are (outline) and where the camera offset draws them (filled), over the "
      "slices of the method: what shares a slice is blended by weight, what is apart is sorted.");
  if (!open) return;
  SeenDepths& seen = selection.depths;
  if (seen.picture != workspace.picture() || seen.instance != selection.instance)
    seen = {workspace.picture(), selection.instance,
            emitter_depths(workspace.stage(), selection.instance, workspace.camera())};
  Side& side = workspace.shows(workspace.a) ? workspace.a : workspace.b;
  depth_ruler(seen.emitters, selection.emitter, workspace.scene().near_m,
              depth_slices(*side.method().method));
  ImGui::TreePop();
}

/// Named, with a star while it is not saved.
void title(const EffectSelection& selection, const PresetDocument& document) {
  std::string words = selection.name;
  if (selection.emitter) {
    const Field* name = document.field(fmt::format("emitter[{}].name", *selection.emitter));
    const auto* called = name ? std::get_if<std::string>(&name->value) : nullptr;
    if (called) words += ": " + *called;
  }
  text(words + (document.is_changed() ? " * not saved" : ""));
}

}  // namespace

void effects_panel(Interface& interface) {
  EffectSelection& selection = interface.effects;
  hierarchy(interface);
  pick_effect_to_drop(interface);
  PresetDocument* document = document_of(interface);
  if (!document) return note("Select an effect, or one of its emitters, to edit it.");
  ImGui::Separator();
  title(selection, *document);
  depths(interface);
  edit_effect(interface, *document);
}

void ask_about_files(Interface& interface) {
  EffectSelection& selection = interface.effects;
  EffectDocuments& documents = interface.workspace.documents;
  if (!selection.conflict.empty() && !ImGui::IsPopupOpen(kConflict)) ImGui::OpenPopup(kConflict);
  if (ImGui::BeginPopupModal(kConflict, nullptr, ImGuiWindowFlags_AlwaysAutoResize)) {
    text(fmt::format("The file of {} is not as it was when it was read.", selection.conflict));
    const auto answer = [&](const char* name, const char* help, auto&& act) {
      if (ImGui::Button(name)) {
        try {
          act();
        } catch (const std::exception& problem) {
          interface.workspace.problem = problem.what();
        }
        selection.conflict.clear();
        ImGui::CloseCurrentPopup();
      }
      tooltip(help);
      ImGui::SameLine();
    };
    answer("save mine", "Writes over what another program wrote.",
           [&] { documents.save(selection.conflict, PresetDocument::OverChanges::kOverwrite); });
    answer("take theirs", "Reads the file; what you had is one undo away.",
           [&] { documents.reload(selection.conflict); });
    answer("neither", "Goes on without saving.", [] {});
    ImGui::EndPopup();
  }
  if (selection.closing && !ImGui::IsPopupOpen(kUnsaved)) ImGui::OpenPopup(kUnsaved);
  if (!ImGui::BeginPopupModal(kUnsaved, nullptr, ImGuiWindowFlags_AlwaysAutoResize)) return;
  text(fmt::format("Not saved: {}", fmt::join(documents.unsaved(), ", ")));
  const bool leaves = ImGui::Button("close without saving");
  ImGui::SameLine();
  if (ImGui::Button("stay") || leaves) {
    interface.closing = leaves;
    selection.closing = false;
    ImGui::CloseCurrentPopup();
  }
  ImGui::EndPopup();
}

void undo_edit(Interface& interface) {
  if (PresetDocument* document = document_of(interface)) document->undo();
  interface.effects.refused.clear();
}

void redo_edit(Interface& interface) {
  if (PresetDocument* document = document_of(interface)) document->redo();
  interface.effects.refused.clear();
}

void save_effect(Interface& interface) {
  PresetDocument* document = document_of(interface);
  if (!document) return;
  try {
    interface.workspace.documents.save(interface.effects.name, PresetDocument::OverChanges::kRefuse);
  } catch (const ChangedOnDisk&) {
    interface.effects.conflict = interface.effects.name;
  } catch (const std::exception& problem) {
    interface.workspace.problem = problem.what();
  }
}

void close_window(Interface& interface) {
  if (interface.workspace.documents.unsaved().empty())
    interface.closing = true;
  else
    interface.effects.closing = true;
}

bool place_effect(Interface& interface, Side& side, glm::vec2 place) {
  std::string& placing = interface.effects.placing;
  if (placing.empty()) return false;
  Workspace& workspace = interface.workspace;
  try {
    if (workspace.drop_effect(placing, side, place)) {
      const size_t last = workspace.scene().instances.size() - 1;
      select(interface.effects, workspace.scene().instances[last], last, {});
      placing.clear();
    } else {
      workspace.problem = "There is only sky: click on something solid.";
    }
  } catch (const std::exception& problem) {
    workspace.problem = problem.what();
    placing.clear();
  }
  return true;
}

}  // namespace plume
