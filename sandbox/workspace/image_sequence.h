// Every tick of a range as a picture of its own, drawn at full resolution one after the other, so that a
// window stays alive between them.
#ifndef PLUME_WORKSPACE_IMAGE_SEQUENCE_H
#define PLUME_WORKSPACE_IMAGE_SEQUENCE_H

#include <filesystem>

#include "sandbox/workspace/workspace.h"

namespace plume {

struct SequenceOptions {
  std::filesystem::path folder;  ///< made if it is not there
  uint32_t first = 0, last = 0, step = 1;
  glm::uvec2 size{1280, 720};
};

class ImageSequence {
 public:
  /// Pauses the workspace. Throws FileError when the folder cannot be made.
  ImageSequence(Workspace& workspace, SequenceOptions options);
  /// Gives the workspace back as it was, unless another scene was opened.
  ~ImageSequence();
  ImageSequence(const ImageSequence&) = delete;

  /// Draws the next tick and writes it. Throws FileError, and std::runtime_error when another scene was
  /// opened meanwhile.
  void advance();
  bool is_done() const { return done_ == total(); }
  uint32_t done() const { return done_; }
  uint32_t total() const { return (options_.last - options_.first) / options_.step + 1; }
  const SequenceOptions& options() const { return options_; }
  /// Of the pictures' names, counted from 1: "frame_%06d.png".
  static constexpr const char* kPattern = "frame_%06d.png";

 private:
  Workspace& workspace_;
  SequenceOptions options_;
  uint32_t done_ = 0;
  std::string scene_;
  Playback playback_before_;
  ResolutionControl resolution_before_;
};

}  // namespace plume
#endif
