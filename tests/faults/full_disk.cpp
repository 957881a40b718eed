// A disk that becomes full, for a program that this is loaded into (LD_PRELOAD). Below the folder that the
// program is started in, whatever needs room is counted: each file and folder that is made, each write, each
// new name, each flush. From number FULL_DISK_AT on, counted from 1, all of it fails with the errno
// FULL_DISK_ERROR; a write first takes half, as where the last block is gone. FULL_DISK_LOG names the file of
// the FullDiskLog.
#include "tests/faults/full_disk.h"

#include <dlfcn.h>
#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdarg>
#include <cstdlib>
#include <cstring>
#include <string>

namespace {

template <class Function>
Function* next(const char* name) {
  return reinterpret_cast<Function*>(dlsym(RTLD_NEXT, name));
}

class Disk {
 public:
  Disk() {
    char folder[4096] = "";
    if (::getcwd(folder, sizeof folder)) folder_ = std::string(folder) + "/";
    const char *at = std::getenv("FULL_DISK_AT"), *error = std::getenv("FULL_DISK_ERROR");
    if (at) at_ = std::strtoull(at, nullptr, 10);
    if (error) error_ = std::atoi(error);
    const char* name = std::getenv("FULL_DISK_LOG");
    const int file = name ? next<int(const char*, int, ...)>("open")(name, O_RDWR | O_CLOEXEC) : -1;
    if (file < 0) return;
    void* log = ::mmap(nullptr, sizeof(plume::FullDiskLog), PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
    if (log != MAP_FAILED) log_ = static_cast<plume::FullDiskLog*>(log);
    ::close(file);
  }

  bool has(const char* path) const {
    return path && (*path != '/' || std::string_view(path).starts_with(folder_));
  }
  /// Whether the disk has no room for it, which errno then says.
  bool refuses(const char* path) {
    if (!log_) return false;
    const uint64_t number = ++log_->operations;
    if (at_ == 0 || number < at_) return false;
    if (number == at_) std::strncpy(log_->first_failed, path, sizeof log_->first_failed - 1);
    errno = error_;
    return true;
  }
  /// The path of a regular file on the disk that is open; empty: it is none.
  std::string path_of(int file) const {
    struct stat is {};
    if (file <= STDERR_FILENO || ::fstat(file, &is) != 0 || !S_ISREG(is.st_mode)) return "";
    char path[4096];
    const ssize_t length = ::readlink(("/proc/self/fd/" + std::to_string(file)).c_str(), path, sizeof path);
    const std::string text(path, size_t(length < 0 ? 0 : length));
    return has(text.c_str()) ? text : "";
  }

 private:
  std::string folder_;
  uint64_t at_ = 0;
  int error_ = ENOSPC;
  plume::FullDiskLog* log_ = nullptr;
};

Disk& disk() {
  static Disk disk;
  return disk;
}
const Disk& g_begun = disk();  // before the program can go elsewhere

int open_next(const char* path, int flags, mode_t mode) {
  if ((flags & O_CREAT) && disk().has(path) && disk().refuses(path)) return -1;
  return next<int(const char*, int, ...)>("open")(path, flags, mode);
}

}  // namespace

extern "C" {

int open(const char* path, int flags, ...) {
  va_list more;
  va_start(more, flags);
  const mode_t mode = (flags & O_CREAT) ? va_arg(more, mode_t) : 0;
  va_end(more);
  return open_next(path, flags, mode);
}

ssize_t write(int file, const void* bytes, size_t count) {
  const auto really = next<ssize_t(int, const void*, size_t)>("write");
  const std::string path = disk().path_of(file);
  if (path.empty() || !disk().refuses(path.c_str())) return really(file, bytes, count);
  if (count < 2) return -1;
  return really(file, bytes, count / 2);  // what is left of it fails
}

int fsync(int file) {
  const std::string path = disk().path_of(file);
  return !path.empty() && disk().refuses(path.c_str()) ? -1 : next<int(int)>("fsync")(file);
}

int rename(const char* from, const char* to) noexcept {
  return disk().has(to) && disk().refuses(to) ? -1 : next<int(const char*, const char*)>("rename")(from, to);
}

int mkdir(const char* path, mode_t mode) noexcept {
  struct stat is {};
  if (disk().has(path) && ::stat(path, &is) != 0 && disk().refuses(path)) return -1;
  return next<int(const char*, mode_t)>("mkdir")(path, mode);
}
}
