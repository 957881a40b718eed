// That one run alone writes into a folder. The lock is on the folder itself: it leaves no file behind, and
// ends with the process, however that ends.
#ifndef PLUME_RUNS_FOLDER_LOCK_H
#define PLUME_RUNS_FOLDER_LOCK_H

#include <filesystem>
#include <utility>

namespace plume {

class FolderLock {
 public:
  /// Of a folder that is there. Throws std::runtime_error where another process holds it. A file system that
  /// has no such locks (NFS on folders) goes without.
  explicit FolderLock(const std::filesystem::path& folder);
  ~FolderLock();
  FolderLock(FolderLock&& other) noexcept : file_(std::exchange(other.file_, -1)) {}
  FolderLock& operator=(FolderLock&&) = delete;

 private:
  int file_ = -1;
};

}  // namespace plume
#endif
