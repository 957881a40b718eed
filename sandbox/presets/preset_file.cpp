#include "sandbox/presets/preset_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <utility>

#include "sandbox/presets/diagnostics.h"
#include "sandbox/presets/table_reader.h"
#include "sandbox/presets/toml_guard.h"

namespace plume {
namespace {

constexpr size_t kMaxFileBytes = size_t{4} << 20;

}  // namespace

std::string load_text(const std::filesystem::path& path) {
  const auto fail = [&](std::string message) {
    throw FileErrors({{path.string(), 1, 1, std::move(message)}});
  };
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(path, error);
  if (!std::filesystem::exists(status)) fail("there is no such file, expected a TOML file");
  if (std::filesystem::is_directory(status)) fail("this is a folder, expected a TOML file");
  std::ifstream in(path, std::ios::binary);
  if (!in) fail("cannot be opened, expected a TOML file you may read");
  std::string text(kMaxFileBytes + 1, '\0');  // one byte more than allowed tells a file that is too long
  in.read(text.data(), static_cast<std::streamsize>(text.size()));
  if (in.bad()) fail("cannot be read, expected a TOML file you may read");
  text.resize(static_cast<size_t>(in.gcount()));
  return text;
}

void read_noting(std::string_view text, const std::string& file, const ReadTable& read,
                 std::vector<Field>* fields) {
  std::vector<Diagnostic> found;
  const auto fail = [&](uint32_t line, uint32_t column, std::string message) {
    throw FileErrors({{file, std::max(1u, line), std::max(1u, column), std::move(message)}});
  };
  if (text.size() > kMaxFileBytes) fail(1, 1, "the file is larger than 4 MiB, expected at most 4 MiB");
  if (text.find_first_not_of(" \t\r\n") == text.npos)
    fail(1, 1, "the file is empty, expected the keys of an effect, a scene or a replay");
  if (const auto refusal = refuse_toml(text)) fail(refusal->line, refusal->column, refusal->message);

  toml::table document;
  try {
    document = toml::parse(text, file);
  } catch (const toml::parse_error& error) {
    fail(
        error.source().begin.line, error.source().begin.column,
        fmt::format("not TOML: {}, expected a valid TOML 1.0 document", printable(error.description(), 200)));
  }
  TableReader top(document, file, found, fields);
  read(top);
  top.reject_unknown_keys();
  if (found.empty()) return;
  std::ranges::stable_sort(found, {}, [](const Diagnostic& d) { return std::pair(d.line, d.column); });
  throw FileErrors(std::move(found));
}

void read_document(std::string_view text, const std::string& file, const ReadTable& read) {
  read_noting(text, file, read, nullptr);
}

std::vector<Field> asked_fields(std::string_view text, const std::string& file, const ReadTable& read) {
  std::vector<Field> fields;
  try {
    read_noting(text, file, read, &fields);
  } catch (const FileErrors&) {
    // Whatever is wrong is reported when the file is read for good.
  }
  return fields;
}

std::string preset_id(const std::string& file) {
  return std::filesystem::path(file).stem().string();
}

}  // namespace plume
