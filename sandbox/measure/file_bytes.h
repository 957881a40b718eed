// Whole files in and out of memory, so that no reader ever sees half a result.
#ifndef PLUME_MEASURE_FILE_BYTES_H
#define PLUME_MEASURE_FILE_BYTES_H

#include <cstdint>
#include <filesystem>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
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
void write_file(const std::filesystem::path& path, std::string_view text);

/// The same for a file that somebody works on: the new one has the permission bits of the old, is on the disk
/// before the old one goes, and where `path` is a link, what it points to is replaced. A file that is
/// protected against writing stays. What a killed process left beside it goes.
void replace_file(const std::filesystem::path& path, std::string_view text);

/// The folder, and those that it is in, where they are not there yet. Throws FileError.
void make_folder(const std::filesystem::path& folder);

/// Gives a file the name of another, which it replaces, on the same file system. Throws FileError that names
/// the new name, which is then as it was.
void rename_file(const std::filesystem::path& from, const std::filesystem::path& to);

/// A name in the folder of `path` that nothing else has, for what is to be renamed onto `path` once it is
/// whole.
std::filesystem::path temporary_beside(const std::filesystem::path& path);

/// Removes temporary files that a process left in a folder when it was killed; those of processes that live
/// stay, and all where the folder cannot be looked at.
void remove_abandoned(const std::filesystem::path& folder);

}  // namespace plume
#endif
