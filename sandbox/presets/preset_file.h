// A preset's file as a whole: its text, and all that is read of it, with every mistake in it.
#ifndef PLUME_PRESETS_PRESET_FILE_H
#define PLUME_PRESETS_PRESET_FILE_H

#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "sandbox/presets/field.h"

namespace plume {

class TableReader;
/// What reads a table (table_reader.h).
using ReadTable = std::function<void(TableReader&)>;

/// The text of a file of at most 4 MiB; throws FileErrors when it cannot be read. Somebody who writes the
/// file meanwhile is waited for: it is what they were done with, before or after.
std::string load_text(const std::filesystem::path& path);

/// While one lives, load_text() gives of each file what it gave first: a run that reads a preset more than
/// once sees one of it, whoever edits it. Of one thread.
class SteadyTexts {
 public:
  SteadyTexts();
  ~SteadyTexts();
  SteadyTexts(const SteadyTexts&) = delete;

 private:
  std::map<std::filesystem::path, std::string> kept_;
  std::map<std::filesystem::path, std::string>* before_;
};

/// Parses `text` and hands its top table to `read`; throws FileErrors with everything wrong, in the order of
/// the file. A syntax error ends reading at once, because toml++ cannot go on after one.
void read_document(std::string_view text, const std::string& file, const ReadTable& read);

/// All that `read` asks for, in that order: what the text says and what it could say. Tables that are absent
/// are read too, as empty ones, so what `read` makes on the way is no good. Mistakes are passed over; where
/// the text is no TOML there is nothing.
std::vector<Field> asked_fields(std::string_view text, const std::string& file, const ReadTable& read);

/// The id of the preset in a file: its name without folder and extension.
std::string preset_id(const std::string& file);

}  // namespace plume
#endif
