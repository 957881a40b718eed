#include "sandbox/workspace/recording.h"

#include <fmt/format.h>

#include "renderer/gpu/errors.h"
#include "sandbox/measure/image_io.h"
#include "sandbox/workspace/shown_picture.h"

namespace plume {
namespace fs = std::filesystem;
namespace {

/// What concerns files is for the user to read; a device that fails is not to be hidden.
template <class Act>
bool attempt(Workspace& workspace, const Act& act) try {
  act();
  return true;
} catch (const gpu::DeviceFailure&) {
  throw;
} catch (const vk::SystemError&) {
  throw;
} catch (const std::exception& error) {
  workspace.problem = error.what();
  return false;
}

}  // namespace

fs::path Recording::free_name(const std::string& stem, const std::string& extension) const {
  for (unsigned number = 1;; ++number) {
    const fs::path name = folder / fmt::format("{}_{}", stem, number);
    fs::path file = name;
    file += extension;
    if (!fs::exists(name) && !fs::exists(file)) return file;
  }
}

void Recording::toggle(Workspace& workspace) {
  if (!recorder_.is_recording()) {
    recorder_.start(workspace);
    said.clear();
    workspace.change();  // what is shown now is the first picture
    return;
  }
  if (recorder_.shots() == 0) return recorder_.discard();
  attempt(workspace, [&] {
    const fs::path file = free_name("plume_recording", ".toml");
    const size_t shots = recorder_.shots();
    recorder_.save(file, workspace.library());
    said = fmt::format("{} pictures: plume replay {}", shots, fs::absolute(file).lexically_normal().string());
  });
}

void Recording::save_picture(Workspace& workspace) {
  attempt(workspace, [&] {
    const fs::path file = free_name("plume_picture", ".png");
    write_png(file, shown_picture(workspace));
    said = fs::absolute(file).lexically_normal().string();
  });
}

void Recording::start_pictures(Workspace& workspace, SequenceOptions options) {
  stop();
  attempt(workspace, [&] {
    options.folder = free_name("plume_pictures", "");
    sequence_.emplace(workspace, std::move(options));
    said.clear();
  });
}

void Recording::stop() {
  if (sequence_) said = fmt::format("stopped after {} pictures", sequence_->done());
  if (video_) said = "the video was not finished; the pictures are kept";
  sequence_.reset();
  video_.reset();
}

bool Recording::advance(Workspace& workspace) {
  bool drew = false;
  const bool went_well = attempt(workspace, [&] {
    if (video_) {
      video_->poll();
      if (!video_->is_done()) return;
      said = fs::absolute(video_->file()).lexically_normal().string();
      video_.reset();
    } else if (sequence_) {
      sequence_->advance();
      recorder_.note(workspace);
      drew = true;
      if (!sequence_->is_done()) return;
      const SequenceOptions options = sequence_->options();
      const uint32_t pictures = sequence_->done();
      sequence_.reset();
      said = fmt::format("{} pictures in {}", pictures,
                         fs::absolute(options.folder).lexically_normal().string());
      if (!wants_video) return;
      fs::path file = options.folder;
      file += ".mp4";
      video_.emplace(options.folder, file, pictures, double(kTicksPerSecond) / options.step);
    }
  });
  if (!went_well) sequence_.reset(), video_.reset();
  return drew;
}

}  // namespace plume
