#include "sandbox/presets/file_watch.h"

#include <chrono>
#include <utility>

#include "sandbox/presets/diagnostics.h"
#include "sandbox/presets/preset_file.h"

namespace plume {
namespace fs = std::filesystem;
namespace {

constexpr std::chrono::seconds kGrain{2};  // of time stamps: FAT has the coarsest

/// FNV-1a, 64 bits.
uint64_t hash_of(std::string_view text) {
  uint64_t hash = 0xcbf29ce484222325;
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3;
  return hash;
}

std::optional<std::string> contents_of(const fs::path& path) {
  try {
    return load_text(path);
  } catch (const FileErrors&) {
    return {};
  }
}

}  // namespace

FileWatch::FileWatch(fs::path path, std::string_view known)
    : path_(std::move(path)), known_(hash_of(known)) {}

std::optional<FileWatch::Stamp> FileWatch::stamp() const {
  std::error_code error;
  const fs::file_time_type time = fs::last_write_time(path_, error);
  if (error) return {};
  const uintmax_t size = fs::file_size(path_, error);
  if (error) return {};
  return Stamp{time, size};
}

FileWatch::News FileWatch::poll() {
  const std::optional<Stamp> now = stamp();
  if (now && now == seen_ && settled_) return News::kNone;
  std::optional<std::string> contents = now ? contents_of(path_) : std::nullopt;
  if (!contents) {
    seen_.reset();
    return std::exchange(gone_, true) ? News::kNone : News::kGone;
  }
  gone_ = false;
  seen_ = now;
  settled_ = fs::file_time_type::clock::now() - now->time > kGrain;
  const uint64_t hash = hash_of(*contents);
  if (hash == known_) return News::kNone;
  known_ = hash;
  contents_ = *std::move(contents);
  return News::kChanged;
}

void FileWatch::know(std::string_view contents) {
  known_ = hash_of(contents);
  seen_.reset();
  gone_ = false;
}

}  // namespace plume
