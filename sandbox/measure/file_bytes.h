// Whole files in and out of memory, so that no reader ever sees half a result.
#ifndef PLUME_MEASURE_FILE_BYTES_H
#define PLUME_MEASURE_FILE_BYTES_H

#include <cstdint>
#include <filesystem>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

namespace plume {

/// A file could not be read, written or understood. The message is "PATH: reason".
struct FileError : std::runtime_error {
  FileError(const std::filesystem::path& path, const std::string& reason)
      : std::runtime_error(path.string() + ": " + reason) {}
};

/// The bytes of the file. Throws FileError with the system's reason.
std::vector<uint8_t> read_file(const std::filesystem::path& path);

/// Writes to a temporary name in the same folder and renames it onto `path`, replacing what was there. When
/// that fails, `path` is as it was, the temporary file is gone, and FileError has the system's reason.
/// The folder must exist.
void write_file(const std::filesystem::path& path, std::span<const uint8_t> bytes);

/// The same for a file that somebody works on: the new one has the permission bits of the old, is on the disk
/// before the old one goes, and where `path` is a link, what it points to is replaced. A file that is
/// protected against writing stays.
void replace_file(const std::filesystem::path& path, std::span<const uint8_t> bytes);

/// Removes temporary files that a process left in a folder when it was killed; those of processes that live
/// stay.
void remove_abandoned(const std::filesystem::path& folder);

}  // namespace plume
#endif
