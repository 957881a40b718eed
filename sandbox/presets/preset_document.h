// The text of an effect or a scene while somebody works on it. The text is the truth: fields are read from
// it, edits change it by the byte (toml_edit.h) with what they bring with them (edit_consequences.h), and
// after each the whole is read again by the reader that everybody uses. Undo goes through texts. What runs is
// made from the last text without mistakes.
#ifndef PLUME_PRESETS_PRESET_DOCUMENT_H
#define PLUME_PRESETS_PRESET_DOCUMENT_H

#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "sandbox/effects/effect.h"
#include "sandbox/presets/diagnostics.h"
#include "sandbox/presets/field.h"
#include "sandbox/presets/file_watch.h"
#include "sandbox/presets/library.h"
#include "sandbox/presets/text_history.h"
#include "sandbox/scene/scene.h"

namespace plume {

/// The file was not saved because somebody else changed it.
struct ChangedOnDisk : std::runtime_error {
  using std::runtime_error::runtime_error;
};

class PresetDocument {
 public:
  /// Opens a file with mistakes too. Throws FileErrors when it cannot be read, std::invalid_argument when
  /// `kind` is neither effect nor scene.
  PresetDocument(std::filesystem::path path, PresetKind kind, PresetLibrary library);

  const std::filesystem::path& path() const { return path_; }
  const std::string& text() const { return history_.text(); }
  /// All that is wrong in the text; empty when effect() or scene() is of it.
  const std::vector<Diagnostic>& diagnostics() const { return diagnostics_; }
  /// Of the last text without mistakes; nullptr when there was none yet, or the file is of the other kind.
  const Effect* effect() const { return good_ ? std::get_if<Effect>(&*good_) : nullptr; }
  const Scene* scene() const { return good_ ? std::get_if<Scene>(&*good_) : nullptr; }
  /// Counts up when effect() or scene() is another.
  uint64_t revision() const { return revision_; }

  /// All that the text says or could say, tables before what is in them; nothing where it is no TOML. An edit
  /// makes it anew: who walks through it keeps a copy, or edits after the walk.
  const std::vector<Field>& fields() const { return fields_; }
  const Field* field(std::string_view path) const;

  /// What came of an edit. Refused: the text is as it was, and this is what would have been wrong.
  struct Outcome {
    bool made = false;
    std::vector<Diagnostic> diagnostics;
  };
  /// kGoesOn: one of many of a drag, which are one step of undo until end_gesture().
  enum class Gesture { kWhole, kGoesOn };
  /// An edit that would add a mistake is refused. Values are of the type that the field has.
  Outcome set(std::string_view path, const FieldValue& value, Gesture gesture = Gesture::kWhole);
  /// A table, or one more in a list of tables (its path without a place: "emitter"), with what it needs.
  Outcome add(std::string_view path);
  /// A field, a table or an item of a list: then the default holds.
  Outcome remove(std::string_view path);
  /// Any change of the text, as one step of undo called `name`. Likewise refused.
  Outcome change(const std::string& name, const std::function<std::string(const std::string&)>& how);
  /// Any text, with mistakes too.
  void replace_text(std::string text, std::string name);
  void end_gesture() { history_.end_gesture(); }

  bool undo();
  bool redo();
  std::string_view undo_name() const { return history_.undo_name(); }
  std::string_view redo_name() const { return history_.redo_name(); }
  /// See TextHistory.
  uint64_t undo_order() const { return history_.undo_order(); }
  uint64_t redo_order() const { return history_.redo_order(); }

  /// Whether there is something to save.
  bool is_changed() const { return text() != on_disk_; }
  enum class OverChanges { kRefuse, kOverwrite };
  /// Throws ChangedOnDisk when the file is not as it was read or saved last, FileError when it cannot be
  /// written.
  void save(OverChanges over = OverChanges::kRefuse);
  /// Writes another file, and is the document of that from now on. Throws FileError, and
  /// std::invalid_argument when the file is there already.
  void save_as(const std::filesystem::path& path);

  /// kReloaded: it was changed by another program and read again, one step of undo; diagnostics() has its
  /// mistakes. kConflict: the same, but there is something to save: save(kOverwrite) or reload() decides.
  enum class Disk { kSame, kReloaded, kConflict, kGone };
  /// Meshes and vector fields that it names are looked at too: where one has changed, the text is read again
  /// with it, which is no step of undo. One that breaks is among the diagnostics, and the last good runs.
  Disk poll();
  /// What is on disk, one step of undo. Throws FileErrors when it cannot be read.
  void reload();

 private:
  template <class Change>
  Outcome edit(std::string_view path, std::string name, std::string_view gesture, const Change& change);
  std::vector<Field> describe(const std::string& text) const;
  std::variant<Effect, Scene> read(const std::string& text) const;
  Outcome step_to(std::string text, std::string name, std::string_view gesture);
  void refresh();
  void watch_parts();
  void poll_parts();
  std::string title(std::string_view path) const;

  std::filesystem::path path_;
  PresetKind kind_;
  PresetLibrary library_;
  std::string on_disk_;
  TextHistory history_;
  FileWatch watch_;
  std::map<std::filesystem::path, FileWatch> parts_;  // meshes and vector fields that the text names
  std::vector<Field> fields_;
  std::vector<Diagnostic> diagnostics_;
  std::optional<std::variant<Effect, Scene>> good_;
  uint64_t revision_ = 0;
};

}  // namespace plume
#endif
