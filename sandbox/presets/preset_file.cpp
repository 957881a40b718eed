#include "sandbox/presets/preset_file.h"

#include <fmt/format.h>
#include <sys/stat.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <ctime>
#include <memory>
#include <thread>
#include <utility>

#include "sandbox/presets/diagnostics.h"
#include "sandbox/presets/printable.h"
#include "sandbox/presets/table_reader.h"
#include "sandbox/presets/toml_guard.h"

namespace plume {
namespace {

constexpr size_t kMaxFileBytes = size_t{4} << 20;
constexpr std::chrono::milliseconds kSettled{50};  // nobody pauses for so long between two parts of a file
constexpr std::chrono::seconds kPatience{2};       // with a file that never settles

[[noreturn]] void fail(const std::filesystem::path& path, std::string message) {
  throw FileErrors({{path.string(), 1, 1, std::move(message)}});
}

/// What a file held at one time, and what tells that it was changed.
struct Reading {
  struct stat at {};
  bool is_steady = false;  // nobody was writing
  std::string text;

  bool is_of_the_same(const Reading& other) const {
    return at.st_dev == other.at.st_dev && at.st_ino == other.at.st_ino && at.st_size == other.at.st_size &&
           at.st_mtim.tv_sec == other.at.st_mtim.tv_sec && at.st_mtim.tv_nsec == other.at.st_mtim.tv_nsec;
  }
};

std::chrono::nanoseconds age(const struct stat& file) {
  timespec now{};
  ::clock_gettime(CLOCK_REALTIME, &now);
  return std::chrono::seconds(now.tv_sec - file.st_mtim.tv_sec) +
         std::chrono::nanoseconds(now.tv_nsec - file.st_mtim.tv_nsec);
}

Reading read_once(const std::filesystem::path& path) {
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(path, error);
  if (!std::filesystem::exists(status)) fail(path, "there is no such file, expected a TOML file");
  if (std::filesystem::is_directory(status)) fail(path, "this is a folder, expected a TOML file");
  const std::unique_ptr<FILE, int (*)(FILE*)> file(std::fopen(path.c_str(), "rb"), std::fclose);
  Reading before, now;
  if (!file || ::fstat(::fileno(file.get()), &before.at) != 0)
    fail(path, "cannot be opened, expected a TOML file you may read");
  // Before it is read: what is written within a tick of the clock of an earlier change leaves no later time.
  const bool was_at_rest = age(before.at) > kSettled;
  now.text.resize(kMaxFileBytes + 1);  // one byte more than allowed tells a file that is too long
  now.text.resize(std::fread(now.text.data(), 1, now.text.size(), file.get()));
  now.text.shrink_to_fit();  // documents keep their text
  if (std::ferror(file.get()) || ::fstat(::fileno(file.get()), &now.at) != 0)
    fail(path, "cannot be read, expected a TOML file you may read");
  // A pipe is read but once. Of a file that is being emptied, the size may change before the time does.
  now.is_steady =
      !S_ISREG(now.at.st_mode) || (was_at_rest && now.is_of_the_same(before) && !now.text.empty());
  return now;
}

std::string load_steady(const std::filesystem::path& path) {
  const auto deadline = std::chrono::steady_clock::now() + kPatience;
  Reading now = read_once(path);
  while (!now.is_steady) {
    std::this_thread::sleep_for(kSettled);
    Reading next = read_once(path);
    next.is_steady |= next.is_of_the_same(now) && next.text == now.text;  // where clocks do not agree
    if (!next.is_steady && std::chrono::steady_clock::now() > deadline)
      fail(path, "is being written all the time, expected a file that somebody is done with");
    now = std::move(next);
  }
  return std::move(now.text);
}

std::map<std::filesystem::path, std::string>* g_kept = nullptr;  // of the SteadyTexts there is

}  // namespace

SteadyTexts::SteadyTexts() : before_(std::exchange(g_kept, &kept_)) {}
SteadyTexts::~SteadyTexts() {
  g_kept = before_;
}

std::string load_text(const std::filesystem::path& path) {
  if (!g_kept) return load_steady(path);
  const std::filesystem::path key = std::filesystem::absolute(path).lexically_normal();
  if (const auto known = g_kept->find(key); known != g_kept->end()) return known->second;
  return g_kept->emplace(key, load_steady(path)).first->second;
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
