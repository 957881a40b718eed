// Takes down what is drawn, picture after picture, as a replay: the tick, the camera, the method with all of
// its parameters, the view that was looked at, the scene as it was then, with what was muted and frozen.
// `plume replay` draws the same pictures from it, to the bit on the same device. Presets that were other than
// the library's while they were shown go into a folder beside it. Both sides of a split view are pictures of
// their own; the divider, the panels and the crosshair are not taken down.
#ifndef PLUME_WORKSPACE_RECORDER_H
#define PLUME_WORKSPACE_RECORDER_H

#include <filesystem>

#include "sandbox/workspace/workspace.h"

namespace plume {

class Recorder {
 public:
  bool is_recording() const { return recording_; }
  /// Where a scene remembers what was looked at, it begins anew, so that a replay remembers the same.
  void start(Workspace& workspace);
  /// After each drawing. Takes a picture down once for as long as it stays the same.
  void note(Workspace& workspace);
  /// Pictures so far; two for each drawing of a split view.
  size_t shots() const { return replay_.shots.size(); }
  /// Writes the replay, and the presets it needs that `library` does not have as they were into the folder of
  /// the same name without extension. Ends the recording where that succeeds; otherwise it leaves nothing,
  /// and can be tried again. Throws FileError, FileErrors where the replay would not be read, and
  /// std::runtime_error when nothing was drawn.
  void save(const std::filesystem::path& file, const PresetLibrary& library);
  /// Ends the recording without a file.
  void discard();

 private:
  /// A scene at one time of the recording.
  struct State {
    Scene scene;
    std::string text;
    std::map<std::string, std::string> effects;  // what the scene calls it -> its text
    uint64_t beginning = 0;  // of a scene that remembers what was looked at: two are two, alike or not
  };
  size_t state_of(const Workspace& workspace);
  size_t method_of(MethodInstance& instance);
  void write(const std::filesystem::path& file, const std::filesystem::path& folder,
             const PresetLibrary& library) const;
  static bool library_has(const State& state, const PresetLibrary& library);

  bool recording_ = false;
  Replay replay_;
  std::vector<State> states_;
  std::vector<size_t> state_of_shot_;
};

}  // namespace plume
#endif
