// The effects that somebody works on, as texts (presets/preset_document.h): each is opened once and stays
// open, so that undo and what is not saved survive another selection and another scene.
#ifndef PLUME_WORKSPACE_EFFECT_DOCUMENTS_H
#define PLUME_WORKSPACE_EFFECT_DOCUMENTS_H

#include <map>
#include <string>
#include <vector>

#include "sandbox/presets/preset_document.h"

namespace plume {

class EffectDocuments {
 public:
  explicit EffectDocuments(PresetLibrary library) : library_(std::move(library)) {}

  /// By the name that a scene calls an effect. Opens it if it is not; throws what the library throws.
  PresetDocument& open(const std::string& name);

  /// Looks at the files, four times a second: those changed by another program are read again where nothing
  /// is lost by it.
  void poll(double now_s);
  enum class OnDisk {
    kSame,
    kChanged,  ///< by another program, while there is something to save: save(kOverwrite) or reload() decides
    kGone
  };
  OnDisk on_disk(const std::string& name) const;
  /// As those of the document; what is on disk is no longer in conflict with it.
  void save(const std::string& name, PresetDocument::OverChanges over);
  void reload(const std::string& name);

  /// Effects that are not, or may not be, as the library had them: the last good of each document that ever
  /// changed.
  std::map<std::string, Effect> edited() const;
  /// Counts up when edited() has changed.
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
  std::map<std::string, Opened> opened_;
  double next_poll_s_ = 0;
};

}  // namespace plume
#endif
