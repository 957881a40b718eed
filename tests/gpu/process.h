// What this process holds of the system. Linux alone.
#ifndef PLUME_TESTS_PROCESS_H
#define PLUME_TESTS_PROCESS_H

#include <malloc.h>
#include <unistd.h>

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <set>
#include <string>

namespace plume {

/// In use, the driver's part included, which on a CPU device is all of the device's memory.
inline uint64_t heap_bytes() {
  const auto heap = mallinfo2();
  return heap.uordblks + heap.hblkhd;
}

inline uint64_t resident_bytes() {
  uint64_t all_pages = 0, resident_pages = 0;
  std::ifstream("/proc/self/statm") >> all_pages >> resident_pages;
  return resident_pages * uint64_t(sysconf(_SC_PAGESIZE));
}

/// What is open, by name.
inline std::multiset<std::string> open_files() {
  std::multiset<std::string> names;
  for (const auto& file : std::filesystem::directory_iterator("/proc/self/fd")) {
    std::error_code gone;  // such as the folder that is read here
    names.insert(std::filesystem::read_symlink(file, gone).string());
  }
  return names;
}

inline int64_t thread_count() {
  namespace fs = std::filesystem;
  return std::distance(fs::directory_iterator("/proc/self/task"), fs::directory_iterator());
}

}  // namespace plume
#endif
