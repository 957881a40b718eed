// What can be taken out of a session: a replay of it, a picture, the pictures of a range of ticks, a video.
// Everything is written under a name that is free, and `said` tells where.
#ifndef PLUME_WORKSPACE_RECORDING_H
#define PLUME_WORKSPACE_RECORDING_H

#include "sandbox/workspace/image_sequence.h"
#include "sandbox/workspace/recorder.h"
#include "sandbox/workspace/video.h"

namespace plume {

class Recording {
 public:
  std::filesystem::path folder = ".";  ///< of all files
  bool wants_video = false;            ///< of the next pictures of a range
  std::string said;                    ///< what came of the last of these, for the user to read

  const Recorder& recorder() const { return recorder_; }
  const std::optional<ImageSequence>& sequence() const { return sequence_; }
  const std::optional<Video>& video() const { return video_; }
  bool is_busy() const { return sequence_ || video_; }

  /// Starts to record; or stops and writes plume_recording_<n>.toml. What goes wrong, here and below, becomes
  /// the workspace's problem.
  void toggle(Workspace& workspace);
  /// plume_picture_<n>.png, what is seen without the panels.
  void save_picture(Workspace& workspace);
  /// plume_pictures_<n>/, and plume_pictures_<n>.mp4 if a video is wanted; `options.folder` is chosen here.
  void start_pictures(Workspace& workspace, SequenceOptions options);
  /// The pictures that there are stay.
  void stop();

  /// After each drawing of the workspace.
  void note(Workspace& workspace) { recorder_.note(workspace); }
  /// Goes on with what was started. True when it has drawn in the place of the workspace.
  bool advance(Workspace& workspace);

 private:
  std::filesystem::path free_name(const std::string& stem, const std::string& extension) const;

  Recorder recorder_;
  std::optional<ImageSequence> sequence_;
  std::optional<Video> video_;
};

}  // namespace plume
#endif
