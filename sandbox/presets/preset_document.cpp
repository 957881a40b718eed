#include "sandbox/presets/preset_document.h"

#include <fmt/format.h>

#include <utility>

#include "sandbox/measure/file_bytes.h"
#include "sandbox/presets/edit_consequences.h"
#include "sandbox/presets/field_toml.h"
#include "sandbox/presets/preset_file.h"
#include "sandbox/presets/read_effect.h"
#include "sandbox/presets/read_scene.h"
#include "sandbox/presets/toml_edit.h"
#include "sandbox/presets/toml_layout.h"
#include "sandbox/presets/value_path.h"

namespace plume {

PresetDocument::PresetDocument(std::filesystem::path path, PresetKind kind, PresetLibrary library)
    : path_(std::move(path)),
      kind_(kind),
      library_(std::move(library)),
      on_disk_(load_text(path_)),
      history_(on_disk_),
      watch_(path_, on_disk_) {
  if (kind != PresetKind::kEffect && kind != PresetKind::kScene)
    throw std::invalid_argument("only effects and scenes are edited by field");
  refresh();
}

std::vector<Field> PresetDocument::describe(const std::string& text) const {
  std::vector<Field> fields =
      kind_ == PresetKind::kEffect ? effect_fields(text, path_.string()) : scene_fields(text, path_.string());
  std::optional<std::vector<std::string>> meshes, effects;
  for (Field& field : fields)
    if (field.names == "mesh")
      field.options = meshes ? *meshes : meshes.emplace(library_.ids(PresetKind::kMesh));
    else if (field.names == "effect")
      field.options = effects ? *effects : effects.emplace(library_.ids(PresetKind::kEffect));
  return fields;
}

std::variant<Effect, Scene> PresetDocument::read(const std::string& text) const {
  if (kind_ == PresetKind::kEffect) return library_.effect_text(text, path_.string());
  Scene scene = read_scene_text(text, path_.string());
  if (auto missing = check_references(scene, library_); !missing.empty())
    throw FileErrors(std::move(missing));
  return scene;
}

/// Those that it named before are watched on, others from what they have now.
void PresetDocument::watch_parts() {
  std::map<std::filesystem::path, FileWatch> named;
  const auto name = [&](const std::filesystem::path& path) {
    if (const auto watched = parts_.find(path); watched != parts_.end()) {
      named.insert(*watched);
      return;
    }
    std::string contents;
    try {
      contents = load_text(path);
    } catch (const FileErrors&) {
      // It is news when it is there.
    }
    named.emplace(path, FileWatch(path, contents));
  };
  for (const Field& field : fields_) {
    std::vector<std::string> ids;
    if (const auto* one = std::get_if<std::string>(&field.value)) ids = {*one};
    if (const auto* several = std::get_if<Texts>(&field.value)) ids = *several;
    for (const std::string& id : ids) {
      if (id.empty()) continue;
      if (field.names == "field") name(field_folder(path_) / (id + ".fga"));
      if (field.names == "mesh") name(library_.place(PresetKind::kMesh, id));
    }
  }
  parts_ = std::move(named);
}

void PresetDocument::poll_parts() {
  bool news = false;
  for (auto& [path, watch] : parts_) {
    const FileWatch::News found = watch.poll();
    if (found == FileWatch::News::kGone) watch.know("");  // then its return is news
    news |= found != FileWatch::News::kNone;
  }
  if (news) refresh();
}

void PresetDocument::refresh() {
  fields_ = describe(text());
  watch_parts();
  try {
    good_ = read(text());
    diagnostics_.clear();
    ++revision_;
  } catch (const FileErrors& errors) {
    diagnostics_ = errors.diagnostics();
  } catch (const PresetError& gone) {  // while it was read
    diagnostics_ = {{path_.string(), 1, 1, gone.what()}};
  }
}

const Field* PresetDocument::field(std::string_view path) const {
  return find_field(fields_, path);
}

/// emitter[1].look.lit as "smoke: look.lit".
std::string PresetDocument::title(std::string_view path) const {
  const std::vector<Step> steps = parse_path(path);
  if (!steps[0].index) return std::string(path);
  const std::string item = to_string({steps[0]});
  const Field* named = field(item + ".name");
  const auto* name = named ? std::get_if<std::string>(&named->value) : nullptr;
  const std::string called = name && !name->empty() ? *name : item;
  const std::string rest = to_string({steps.begin() + 1, steps.end()});
  return rest.empty() ? called : fmt::format("{}: {}", called, rest);
}

template <class Change>
PresetDocument::Outcome PresetDocument::edit(std::string_view path, std::string name,
                                             std::string_view gesture, const Change& change) {
  // Where the text is no TOML, nothing can be found in it.
  if (fields_.empty()) return {false, diagnostics_};
  const auto see = [&](const std::string& text) { return describe(text); };
  return step_to(with_consequences(change(parse_path(path)), path, fields_, see), std::move(name), gesture);
}

PresetDocument::Outcome PresetDocument::step_to(std::string text, std::string name,
                                                std::string_view gesture) {
  if (text == history_.text()) return {true, {}};
  std::vector<Diagnostic> mistakes;
  std::optional<std::variant<Effect, Scene>> read_back;
  try {
    read_back = read(text);
  } catch (const FileErrors& errors) {
    mistakes = errors.diagnostics();
  }
  if (mistakes.size() > diagnostics_.size()) return {false, std::move(mistakes)};
  history_.step(std::move(text), std::move(name), gesture);
  fields_ = describe(history_.text());
  watch_parts();
  diagnostics_ = mistakes;
  if (read_back) good_ = std::move(read_back), ++revision_;
  return {true, std::move(mistakes)};
}

PresetDocument::Outcome PresetDocument::set(std::string_view path, const FieldValue& value, Gesture gesture) {
  const Field* field = this->field(path);
  if (!field && !fields_.empty())
    throw std::invalid_argument(fmt::format("`{}` is no field of {}", path, path_.string()));
  if (field && field->state == Field::State::kRead && field->value == value) return {true, {}};
  const std::string merged = gesture == Gesture::kGoesOn ? std::string(path) : "";
  return edit(path, "Set " + title(path), merged, [&](const std::vector<Step>& steps) {
    const TomlLayout layout(text());
    const Place* place = layout.find(steps);
    return with_value(text(), steps, to_toml_value(*field, value, place ? place->nesting() : 0));
  });
}

PresetDocument::Outcome PresetDocument::add(std::string_view path) {
  std::string where(path);
  const Field* field = this->field(path);
  if (const Groups* groups = field ? std::get_if<Groups>(&field->value) : nullptr)
    where += fmt::format("[{}]", groups->count);
  return edit(where, "Add " + title(where), "",
              [&](const std::vector<Step>& steps) { return with_table(text(), steps); });
}

PresetDocument::Outcome PresetDocument::remove(std::string_view path) {
  return edit(path, "Remove " + title(path), "",
              [&](const std::vector<Step>& steps) { return without(text(), steps); });
}

PresetDocument::Outcome PresetDocument::change(const std::string& name,
                                               const std::function<std::string(const std::string&)>& how) {
  if (fields_.empty()) return {false, diagnostics_};
  return step_to(how(text()), name, "");
}

void PresetDocument::replace_text(std::string text, std::string name) {
  history_.step(std::move(text), std::move(name));
  refresh();
}

bool PresetDocument::undo() {
  const bool done = history_.undo();
  if (done) refresh();
  return done;
}

bool PresetDocument::redo() {
  const bool done = history_.redo();
  if (done) refresh();
  return done;
}

void PresetDocument::save(OverChanges over) {
  if (over == OverChanges::kRefuse) {
    std::optional<std::string> there;
    try {
      there = load_text(path_);
    } catch (const FileErrors&) {
      // Gone or not to be read: not as it was.
    }
    if (there != on_disk_)
      throw ChangedOnDisk(fmt::format("{}: not saved, the file {} since it was read", path_.string(),
                                      there ? "was changed by another program" : "is gone or unreadable"));
  }
  replace_file(path_, text());
  on_disk_ = text();
  watch_.know(on_disk_);
}

void PresetDocument::save_as(const std::filesystem::path& path) {
  if (std::filesystem::exists(path))
    throw std::invalid_argument(fmt::format("{} is there already, expected a new name", path.string()));
  make_folder(path.parent_path());
  replace_file(path, text());
  path_ = path;
  on_disk_ = text();
  watch_ = FileWatch(path_, on_disk_);
  refresh();  // which names the file
}

PresetDocument::Disk PresetDocument::poll() {
  poll_parts();
  switch (watch_.poll()) {
    case FileWatch::News::kNone:
      return Disk::kSame;
    case FileWatch::News::kGone:
      return Disk::kGone;
    case FileWatch::News::kChanged:
      break;
  }
  if (watch_.contents() == on_disk_) return Disk::kSame;
  if (is_changed()) return Disk::kConflict;
  reload();
  return Disk::kReloaded;
}

void PresetDocument::reload() {
  on_disk_ = load_text(path_);
  watch_.know(on_disk_);
  replace_text(on_disk_, "Read the changed file");
}

}  // namespace plume
