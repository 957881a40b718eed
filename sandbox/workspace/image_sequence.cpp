#include "sandbox/workspace/image_sequence.h"

#include <fmt/format.h>

#include "sandbox/measure/image_io.h"
#include "sandbox/workspace/shown_picture.h"

namespace plume {

ImageSequence::ImageSequence(Workspace& workspace, SequenceOptions options)
    : workspace_(workspace),
      options_(std::move(options)),
      scene_(workspace.scene().id),
      playback_before_(workspace.playback),
      resolution_before_(workspace.resolution) {
  make_folder(options_.folder);
  if (workspace_.playback.playing()) workspace_.playback.toggle();
  workspace_.resolution.adapts = false;
  workspace_.resolution.set_step(0);
}

ImageSequence::~ImageSequence() {
  if (workspace_.scene().id == scene_) workspace_.playback = playback_before_;
  workspace_.resolution = resolution_before_;
  workspace_.change();
}

void ImageSequence::advance() {
  if (is_done()) return;
  if (workspace_.scene().id != scene_)
    throw std::runtime_error("another scene was opened; " + scene_ + " is not drawn to its end");
  workspace_.playback.go_to(options_.first + done_ * options_.step);
  workspace_.draw(options_.size);
  write_png(options_.folder / fmt::format("frame_{:06}.png", done_ + 1), shown_picture(workspace_));
  ++done_;
}

}  // namespace plume
