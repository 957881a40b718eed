// A preset that somebody replaces while it is read: the old one, the new one or an error that names it, never
// a mix.
#include <fcntl.h>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <thread>

#include "sandbox/presets/diagnostics.h"
#include "sandbox/presets/preset_file.h"
#include "tests/faults/every.h"

namespace plume {
namespace {

namespace fs = std::filesystem;

/// Every line says whose it is, so that half of one is told from the whole.
std::string text_of(char whose) {
  std::string text;
  for (int line = 0; line < 2000; ++line) text += fmt::format("{}{} = {}\n", whose, line, line);
  return text + "# end\n";
}

class ReplacedPreset : public testing::Test {
 protected:
  void SetUp() override { write(old_); }
  void TearDown() override { fs::remove_all(file_); }

  void write(std::string_view text) const { std::ofstream(file_, std::ios::binary) << text; }
  /// As editors do that write in place, with a pause where the file is shortest and where it is half there.
  void write_in_place(const std::string& text) const {
    const int file = open(file_.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0666);
    usleep(500);
    const size_t half = text.size() / 2;
    EXPECT_EQ(::write(file, text.data(), half), ssize_t(half));
    usleep(500);
    EXPECT_EQ(::write(file, text.data() + half, text.size() - half), ssize_t(text.size() - half));
    close(file);
  }
  void rename_over(const std::string& text) const {
    std::ofstream(file_ + ".new", std::ios::binary) << text;
    fs::rename(file_ + ".new", file_);
  }

  /// A writer whom a busy machine stopped for so long cannot be told from one who is done.
  void note_if_slow(const std::function<void()>& write) {
    const auto begin = std::chrono::steady_clock::now();
    write();
    if (std::chrono::steady_clock::now() - begin > std::chrono::milliseconds(40)) slow_ = true;
  }

  /// Reads while another thread replaces the file again and again.
  void read_while(const std::function<void(const std::string&)>& replace, bool may_be_gone) {
    std::atomic<bool> done = false;
    std::thread other([&] {
      for (int turn = 0; !done; ++turn) {
        note_if_slow([&] { replace(turn % 2 ? old_ : new_); });
        usleep(turn % 7 == 0 ? 150'000 : 1'000);  // at rest now and then, or nobody could read
      }
    });
    int whole = 0, mixed = 0;
    const auto end = std::chrono::steady_clock::now() + std::chrono::milliseconds(20'000 / every(20));
    while (std::chrono::steady_clock::now() < end) try {
        const std::string text = load_text(file_);
        ++(text == old_ || text == new_ ? whole : mixed);
      } catch (const FileErrors& errors) {
        EXPECT_NE(std::string(errors.what()).find(file_), std::string::npos) << errors.what();
        const bool said = std::string(errors.what()).find("no such file") != std::string::npos ||
                          std::string(errors.what()).find("cannot be opened") != std::string::npos ||
                          std::string(errors.what()).find("written all the time") != std::string::npos;
        EXPECT_TRUE(said && may_be_gone) << errors.what();
      }
    done = true;
    other.join();
    EXPECT_GT(whole, 0);
    EXPECT_TRUE(mixed == 0 || slow_) << mixed << " texts such as no one wrote";
  }

  std::atomic<bool> slow_ = false;
  const std::string old_ = text_of('a'), new_ = text_of('b');
  const std::string file_ = fs::path(testing::TempDir()) / fmt::format("replaced_{}.toml", getpid());
};

TEST_F(ReplacedPreset, InPlaceIsNeverSeenInHalves) {
  read_while([&](const std::string& text) { write_in_place(text); }, false);
}

TEST_F(ReplacedPreset, ByRenamingIsOneOrTheOther) {
  read_while([&](const std::string& text) { rename_over(text); }, false);
}

TEST_F(ReplacedPreset, ThatIsDeletedBetweenIsOneOrTheOtherOrNamed) {
  read_while(
      [&](const std::string& text) {
        fs::remove(file_);
        usleep(500);
        write(text);
      },
      true);
}

TEST_F(ReplacedPreset, ThatIsNeverAtRestIsNamed) {
  std::atomic<bool> done = false;
  std::thread other([&] {
    for (int turn = 0; !done; ++turn)
      note_if_slow([&] {
        write(turn % 2 ? old_ : new_);
        usleep(2'000);
      });
  });
  bool was_read = false;
  try {
    load_text(file_);
    was_read = true;
  } catch (const FileErrors& errors) {
    EXPECT_NE(std::string(errors.what()).find(file_ + ":1:1: is being written all the time"),
              std::string::npos)
        << errors.what();
  }
  done = true;
  other.join();
  EXPECT_TRUE(!was_read || slow_);
}

TEST_F(ReplacedPreset, IsOneForAsLongAsARunReadsIt) {
  {
    const SteadyTexts texts;
    EXPECT_EQ(load_text(file_), old_);
    rename_over(new_);
    EXPECT_EQ(load_text(file_), old_);
    EXPECT_EQ(load_text(fs::relative(file_)), old_);
    fs::remove(file_);
    EXPECT_EQ(load_text(file_), old_);
  }
  write(new_);
  EXPECT_EQ(load_text(file_), new_);
}

}  // namespace
}  // namespace plume
