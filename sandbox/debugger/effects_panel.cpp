#include "sandbox/debugger/effects_panel.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <array>

#include "sandbox/debugger/bad_particles_line.h"
#include "sandbox/debugger/depth_ruler.h"
#include "sandbox/debugger/field_editor.h"
#include "sandbox/debugger/file_questions.h"
#include "sandbox/debugger/instance_marks.h"
#include "sandbox/debugger/preset_picker.h"
#include "sandbox/debugger/widget_places.h"
#include "sandbox/debugger/widgets.h"

namespace plume {
namespace {

constexpr double kDepthsPerSecond = 4;  // read while pictures follow each other
constexpr float kTreeLines = 10;        // of the hierarchy, at most
constexpr size_t kFew = 3;              // instances that need not be opened by hand

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

void select(EffectSelection& selection, const Instance& instance, std::optional<size_t> emitter) {
  if (selection.name != instance.effect) selection.refused.clear();
  selection.name = instance.effect;
  selection.instance = instance.name;
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
  if (local) text += fmt::format("\nits time: {:.2f} s, tick {}", *local / 60.0, *local);
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
  const std::string& name = stage.scene().instances[instance].name;
  const bool selected = selection.instance == name && selection.emitter == index;
  const float indent = 0.8f * ImGui::GetFontSize();
  ImGui::Indent(indent);
  if (ImGui::Selectable(instances.described(emitter).name.c_str(), selected))
    select(selection, stage.scene().instances[instance], index);
  name_widget(fmt::format("{} / {}", name, instances.described(emitter).name));
  ImGui::Unindent(indent);
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
  const bool selected = selection.instance == instance.name && !selection.emitter;
  const auto flags = ImGuiTreeNodeFlags_OpenOnArrow | ImGuiTreeNodeFlags_OpenOnDoubleClick |
                     ImGuiTreeNodeFlags_SpanAvailWidth |
                     (stage.scene().instances.size() <= kFew ? ImGuiTreeNodeFlags_DefaultOpen : 0) |
                     (selected ? ImGuiTreeNodeFlags_Selected : 0) | (call ? 0 : ImGuiTreeNodeFlags_Leaf);
  const bool open = ImGui::TreeNodeEx("instance", flags, "%s", instance.name.c_str());
  name_widget(instance.name);
  if (ImGui::IsItemClicked() && !ImGui::IsItemToggledOpen()) select(selection, instance, {});
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
  ImGui::TableSetupColumn("state", ImGuiTableColumnFlags_WidthFixed,
                          std::min(8 * em, 0.38f * ImGui::GetContentRegionAvail().x));
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
    if (ImGui::Button("cancel (Esc)", {-1, 0})) placing.clear();
    return;
  }
  if (ImGui::Button("+ drop an effect into the scene", {-1, 0})) ImGui::OpenPopup("effects");
  name_widget("drop");
  tooltip("Choose an effect, then click in the picture: it starts there, at this tick.");
  if (const auto picked = pick_preset("effects", {.kind = PresetKind::kEffect}, interface.workspace.library(),
                                      interface.gallery))
    placing = *picked;
}

/// What the scene says of the instance: where and when.
void edit_instance(Interface& interface) {
  const auto index = selected_instance(interface);
  PresetDocument* document = interface.workspace.scene_document();
  if (!index || !document) return;
  const bool open = ImGui::TreeNodeEx("in the scene", ImGuiTreeNodeFlags_AllowItemOverlap, "%s in the scene",
                                      interface.effects.instance.c_str());
  tooltip("Where it stands and when it starts: saved with the scene.");
  ImGui::SameLine();
  if (ImGui::SmallButton("frame")) focus_or_frame(interface);
  tooltip("Come near with the camera and turn about it. (F)");
  ImGui::SameLine();
  const bool removes = ImGui::SmallButton("remove");
  name_widget("remove");
  tooltip("Take it out of the scene; one step of undo. (Delete)");
  if (open) {
    constexpr std::array kFields{"position", "yaw_deg",    "call_tick", "stop_tick",
                                 "seed",     "draw_order", "layers"};
    std::vector<FieldEdit> edits;
    const FieldList list{document->fields(), false, edits};
    for (const char* name : kFields)
      if (const Field* field = document->field(fmt::format("instance[{}].{}", *index, name)))
        edit_field(list, *field);
    interface.effects.refused = made(*document, edits, std::move(interface.effects.refused));
    if (!ImGui::IsAnyItemActive() && !interface.effects.held) document->end_gesture();
    ImGui::TreePop();
  }
  if (removes) remove_instance(interface);
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
  const bool differs = document.is_changed() || on_disk != OpenDocuments::OnDisk::kSame;
  const PresetDocument* undone = interface.workspace.to_undo(interface.effects.name);
  const PresetDocument* redone = interface.workspace.to_redo(interface.effects.name);
  command_button("undo", undone ? undone->undo_name() : "", "Ctrl+Z", interface, undo_edit);
  command_button("redo", redone ? redone->redo_name() : "", "Ctrl+Shift+Z", interface, redo_edit);
  command_button("save", differs ? "Writes " + document.path().string() : "", "Ctrl+S", interface,
                 [](Interface& i) { save(i, i.workspace.documents, i.effects.name); });
  command_button("revert", differs ? "What is on disk, as one step of undo" : "", "one step of undo",
                 interface, revert);
  ImGui::Checkbox("only set", &interface.effects.only_set);
  name_widget("only set");
  tooltip("Hides fields that the file does not say; the others are written dim, with their default.");
}

void warnings(Interface& interface, const PresetDocument& document) {
  const EffectSelection& selection = interface.effects;
  using enum OpenDocuments::OnDisk;
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
  const bool open = ImGui::TreeNodeEx("depth in the picture", ImGuiTreeNodeFlags_NoTreePushOnOpen);
  name_widget("depth in the picture");
  tooltip(
      "Where in depth the particles are (outline) and where the camera offset draws them (filled), over the "
      "slices of the method. Virtual slices are as fine as it may cut; it keeps physical ones where there is "
      "something: what shares one is blended by weight, what is apart is sorted.");
  if (!open) return;
  SeenDepths& seen = selection.depths;
  const auto index = selected_instance(interface);
  if (!index) return;
  const Side& side = workspace.shows(workspace.a) ? workspace.a : workspace.b;
  const bool is_due = ImGui::GetTime() - seen.at_s >= 1.0 / kDepthsPerSecond;
  const bool differs = seen.instance != selection.instance || (seen.picture != workspace.picture() && is_due);
  if (!workspace.is_outdated() && side.targets && differs) {
    seen = {.picture = workspace.picture(),
            .instance = selection.instance,
            .at_s = ImGui::GetTime(),
            .emitters = emitter_depths(workspace.stage(), *index, workspace.camera()),
            .bins = {},
            .slices = sliced_depth(workspace.device(), side.methods[side.current])};
    seen.bins = depth_bins(seen.emitters, workspace.scene().near_m);
  }
  depth_ruler(seen.emitters, seen.bins, selection.emitter, workspace.scene().near_m, seen.slices);
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
  point_at_bad_particles(interface);
  hierarchy(interface);
  pick_effect_to_drop(interface);
  edit_instance(interface);
  PresetDocument* document = document_of(interface);
  if (!document) return note("Select an effect, or one of its emitters, to edit it.");
  ImGui::Separator();
  title(selection, *document);
  depths(interface);
  edit_effect(interface, *document);
}

std::optional<size_t> selected_instance(const Interface& interface) {
  const auto& instances = interface.workspace.scene().instances;
  const auto found = std::ranges::find(instances, interface.effects.instance, &Instance::name);
  if (found == instances.end() || found->effect != interface.effects.name) return {};
  return size_t(found - instances.begin());
}

void select_instance(Interface& interface, size_t index, std::optional<size_t> emitter) {
  select(interface.effects, interface.workspace.scene().instances[index], emitter);
}

void undo_edit(Interface& interface) {
  document_of(interface);  // which looks whether it can be opened
  if (PresetDocument* text = interface.workspace.to_undo(interface.effects.name)) text->undo();
  interface.effects.refused.clear();
}

void redo_edit(Interface& interface) {
  document_of(interface);
  if (PresetDocument* text = interface.workspace.to_redo(interface.effects.name)) text->redo();
  interface.effects.refused.clear();
}

void save_edits(Interface& interface) {
  const PresetDocument* effect = document_of(interface);
  Workspace& workspace = interface.workspace;
  const PresetDocument* scene = workspace.scene_document();
  if (scene && scene->is_changed() && !save(interface, workspace.scenes, workspace.scene().file)) return;
  if (effect && (effect->is_changed() ||
                 workspace.documents.on_disk(interface.effects.name) != OpenDocuments::OnDisk::kSame))
    save(interface, workspace.documents, interface.effects.name);
}

}  // namespace plume
