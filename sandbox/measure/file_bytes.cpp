#include "sandbox/measure/file_bytes.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <optional>
#include <string_view>
#include <system_error>

namespace plume {
namespace {

std::string reason(int error) {
  return std::generic_category().message(error);
}

std::span<const uint8_t> bytes_of(std::string_view text) {
  return {reinterpret_cast<const uint8_t*>(text.data()), text.size()};
}

// Other threads and other shards may be writing beside us, perhaps the same file.
constexpr std::string_view kTemporary = ".tmp-";

// Returns 0 or the errno of what failed.
int write_all(int file, std::span<const uint8_t> bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(file, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return errno;
    bytes = bytes.subspan(static_cast<size_t>(written));
  }
  return 0;
}

}  // namespace

std::filesystem::path temporary_beside(const std::filesystem::path& path) {
  static std::atomic<unsigned> count{0};
  std::filesystem::path temporary = path;
  temporary += std::string(kTemporary) + std::to_string(::getpid()) + "-" + std::to_string(count++);
  return temporary;
}

std::vector<uint8_t> read_file(const std::filesystem::path& path) {
  const std::unique_ptr<FILE, int (*)(FILE*)> file(std::fopen(path.c_str(), "rb"), std::fclose);
  if (!file) throw FileError(path, reason(errno));
  std::vector<uint8_t> bytes;
  uint8_t buffer[1 << 16];
  while (const size_t got = std::fread(buffer, 1, sizeof buffer, file.get()))
    bytes.insert(bytes.end(), buffer, buffer + got);
  if (std::ferror(file.get())) throw FileError(path, reason(errno));
  return bytes;
}

namespace {

/// `mode`: permission bits of the new file, where they must be these whatever the process' mask is.
void write_and_rename(const std::filesystem::path& path, std::span<const uint8_t> bytes,
                      std::optional<mode_t> mode, bool sync) {
  const std::filesystem::path temporary = temporary_beside(path);
  const int file = ::open(temporary.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  if (file < 0) throw FileError(path, reason(errno));
  int error = write_all(file, bytes);
  if (error == 0 && mode && ::fchmod(file, *mode) != 0) error = errno;
  if (error == 0 && sync && ::fsync(file) != 0) error = errno;
  // A full disk or a network share may only tell at close.
  if (::close(file) != 0 && error == 0) error = errno;
  if (error == 0 && std::rename(temporary.c_str(), path.c_str()) != 0) error = errno;
  if (error == 0) return;
  ::unlink(temporary.c_str());
  throw FileError(path, reason(error));
}

}  // namespace

void write_file(const std::filesystem::path& path, std::span<const uint8_t> bytes) {
  write_and_rename(path, bytes, {}, false);
}

void write_file(const std::filesystem::path& path, std::string_view text) {
  write_file(path, bytes_of(text));
}

void make_folder(const std::filesystem::path& folder) {
  std::error_code failure;
  if (!folder.empty()) std::filesystem::create_directories(folder, failure);
  if (failure) throw FileError(folder, failure.message());
}

void rename_file(const std::filesystem::path& from, const std::filesystem::path& to) {
  if (std::rename(from.c_str(), to.c_str()) != 0) throw FileError(to, reason(errno));
}

void remove_abandoned(const std::filesystem::path& folder) {
  std::error_code gone;  // by somebody else, or not ours to look at
  for (const auto& entry : std::filesystem::directory_iterator(folder, gone)) {
    const std::string name = entry.path().filename().string();
    const size_t at = name.rfind(kTemporary);
    if (at == name.npos) continue;
    const int process = std::atoi(name.c_str() + at + kTemporary.size());
    if (process > 0 && ::kill(process, 0) != 0 && errno == ESRCH) std::filesystem::remove(entry.path(), gone);
  }
}

void replace_file(const std::filesystem::path& path, std::string_view text) {
  const std::span<const uint8_t> bytes = bytes_of(text);
  std::error_code absent;
  const std::filesystem::path target = std::filesystem::canonical(path, absent);
  remove_abandoned(std::filesystem::absolute(absent ? path : target).parent_path());
  struct stat old {};
  if (absent || ::stat(target.c_str(), &old) != 0) return write_and_rename(path, bytes, {}, true);
  // Renaming would get around the bit that protects it.
  if (::access(target.c_str(), W_OK) != 0) throw FileError(path, reason(errno));
  write_and_rename(target, bytes, old.st_mode & 07777, true);
}

}  // namespace plume
