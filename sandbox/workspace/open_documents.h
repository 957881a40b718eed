// The effects or the scenes that somebody works on, as texts (presets/preset_document.h): each is opened once
// and stays open, so that undo and what is not saved survive another selection and another scene.
#ifndef PLUME_WORKSPACE_OPEN_DOCUMENTS_H
#define PLUME_WORKSPACE_OPEN_DOCUMENTS_H

#include <map>
#include <string>
#include <vector>

#include "sandbox/presets/preset_document.h"

namespace plume {

class OpenDocuments {
 public:
  /// `kind`: effects or scenes.
  OpenDocuments(PresetLibrary library, PresetKind kind) : library_(std::move(library)), kind_(kind) {}

  /// An effect by the name that a scene calls it, a scene by the path of its file. Opens it if it is not;
  /// throws what the library throws.
  PresetDocument& open(const std::string& name);

  /// Looks at the files, four times a second: those changed by another program are read again where nothing
  /// is lost by it.
  void poll(double now_s);
  /// At one of them now.
  void look_at(const std::string& name) { poll(opened_.at(name)); }
  enum class OnDisk {
    kSame,
    kChanged,  ///< by another program, while there is something to save: save(kOverwrite) or reload() decides
    kGone
  };
  OnDisk on_disk(const std::string& name) const;
  /// As those of the document; what is on disk is no longer in conflict with it.
  void save(const std::string& name, PresetDocument::OverChanges over);
  void reload(const std::string& name);
  /// Calls the document by the path from now on. Throws what PresetDocument::save_as() throws.
  void save_as(const std::string& name, const std::filesystem::path& path);

  /// Effects that are not, or may not be, as the library had them: the last good of each document that ever
  /// changed.
  std::map<std::string, Effect> edited_effects() const;
  /// Counts up when a document has another effect or scene.
  uint64_t revision() const;
  /// Names of those with something to save.
  std::vector<std::string> unsaved() const;

 private:
  struct Opened {
    PresetDocument document;
    uint64_t first_revision;
    OnDisk on_disk = OnDisk::kSame;
  };
  void poll(Opened& opened);

  PresetLibrary library_;
  PresetKind kind_;
  std::map<std::string, Opened> opened_;
  double next_poll_s_ = 0;
};

}  // namespace plume
#endif
