#include "sandbox/workspace/video.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <csignal>
#include <cstdlib>
#include <sstream>
#include <stdexcept>
#include <system_error>
#include <vector>

#include "sandbox/measure/file_bytes.h"
#include "sandbox/workspace/image_sequence.h"

extern char** environ;

namespace plume {
namespace fs = std::filesystem;
namespace {

/// All that is in the pipe now.
std::string drain(int pipe) {
  std::string text;
  char buffer[4096];
  for (ssize_t got; (got = ::read(pipe, buffer, sizeof buffer)) > 0;) text.append(buffer, size_t(got));
  return text;
}

/// The end to read from does not wait, and no other child gets either.
std::pair<int, int> make_pipe() {
  int ends[2];
  if (::pipe2(ends, O_CLOEXEC) != 0)
    throw std::runtime_error("no pipe to ffmpeg: " + std::generic_category().message(errno));
  ::fcntl(ends[0], F_SETFL, O_NONBLOCK);
  return {ends[0], ends[1]};
}

/// A folder's own % signs are no places for numbers.
std::string pattern_in(const fs::path& pictures) {
  std::string folder;
  for (const char c : pictures.string()) folder += c == '%' ? "%%" : std::string(1, c);
  return (fs::path(folder) / ImageSequence::kPattern).string();
}

}  // namespace

bool Video::is_available() {
  const char* path = std::getenv("PATH");
  std::istringstream folders(path ? path : "");
  for (std::string folder; std::getline(folders, folder, ':');)
    if (::access((fs::path(folder) / "ffmpeg").c_str(), X_OK) == 0) return true;
  return false;
}

Video::Video(const fs::path& pictures, fs::path file, uint32_t frames, double frames_per_second)
    : file_(std::move(file)), unfinished_(temporary_beside(file_)), total_(frames) {
  std::vector<std::string> words{"ffmpeg",
                                 "-y",
                                 "-nostdin",
                                 "-hide_banner",
                                 "-loglevel",
                                 "error",
                                 "-nostats",
                                 "-progress",
                                 "pipe:1",
                                 "-framerate",
                                 fmt::format("{:g}", frames_per_second),
                                 "-i",
                                 pattern_in(pictures),
                                 "-vf",
                                 "pad=ceil(iw/2)*2:ceil(ih/2)*2",  // what the format below can hold
                                 "-c:v",
                                 "libx264",
                                 "-crf",
                                 "16",
                                 "-pix_fmt",
                                 "yuv420p",
                                 "-f",
                                 "mp4",  // which the temporary name does not tell
                                 unfinished_.string()};
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  const auto [progress, progress_end] = make_pipe();
  const auto [complaints, complaints_end] = make_pipe();
  progress_ = progress;
  complaints_ = complaints;
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, progress_end, STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&actions, complaints_end, STDERR_FILENO);
  const int error = posix_spawnp(&child_, "ffmpeg", &actions, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  ::close(progress_end);
  ::close(complaints_end);
  if (error == 0) return;
  child_ = -1;
  ::close(progress_);
  ::close(complaints_);
  throw std::runtime_error("ffmpeg does not start: " + std::generic_category().message(error));
}

Video::~Video() {
  if (child_ > 0) {
    ::kill(child_, SIGTERM);
    ::waitpid(child_, nullptr, 0);
  }
  ::close(progress_);
  ::close(complaints_);
  std::error_code absent;
  fs::remove(unfinished_, absent);
}

void Video::poll() {
  if (is_done()) return;
  int status = 0;
  const bool ended = ::waitpid(child_, &status, WNOHANG) == child_;
  line_ += drain(progress_);
  words_ += drain(complaints_);
  for (size_t end; (end = line_.find('\n')) != line_.npos; line_.erase(0, end + 1))
    if (line_.starts_with("frame=")) std::from_chars(line_.data() + 6, line_.data() + end, done_);
  if (!ended) return;
  child_ = -1;
  if (WIFEXITED(status) && WEXITSTATUS(status) == 0) {
    rename_file(unfinished_, file_);
    done_ = total_;
    return;
  }
  throw std::runtime_error(
      fmt::format("ffmpeg failed; the pictures are kept. It said: {}", words_.empty() ? "nothing" : words_));
}

}  // namespace plume
