// What tests and the disk that they fill say to each other: see full_disk.cpp.
#ifndef PLUME_TESTS_FULL_DISK_H
#define PLUME_TESTS_FULL_DISK_H

#include <atomic>
#include <cstdint>

namespace plume {

/// In a file that a program, its children and the test share; zeros before the first.
struct FullDiskLog {
  std::atomic<uint64_t> operations;  ///< that needed room
  char first_failed[4088];           ///< the path that the first of those that failed was about
};
static_assert(sizeof(FullDiskLog) == 4096 && std::atomic<uint64_t>::is_always_lock_free);

}  // namespace plume
#endif
