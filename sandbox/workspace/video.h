// A video of the pictures of an ImageSequence, by the program ffmpeg, which runs beside us and tells how far
// it is. The pictures stay whatever comes of it.
#ifndef PLUME_WORKSPACE_VIDEO_H
#define PLUME_WORKSPACE_VIDEO_H

#include <sys/types.h>

#include <cstdint>
#include <filesystem>
#include <string>

namespace plume {

class Video {
 public:
  /// Whether there is an ffmpeg in $PATH.
  static bool is_available();

  /// Starts. Throws std::runtime_error when ffmpeg cannot be started.
  Video(const std::filesystem::path& pictures, std::filesystem::path file, uint32_t frames,
        double frames_per_second);
  /// Ends ffmpeg, if it still runs; of an unfinished video nothing is left.
  ~Video();
  Video(const Video&) = delete;

  /// Asks how far it is; the file is there when it is done. Throws std::runtime_error with ffmpeg's own words
  /// when it failed.
  void poll();
  bool is_done() const { return child_ < 0; }
  uint32_t done() const { return done_; }  ///< frames
  uint32_t total() const { return total_; }
  const std::filesystem::path& file() const { return file_; }

 private:
  std::filesystem::path file_, unfinished_;
  uint32_t done_ = 0, total_;
  pid_t child_ = -1;
  int progress_ = -1, complaints_ = -1;  // pipes
  std::string line_, words_;
};

}  // namespace plume
#endif
