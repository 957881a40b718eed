// An effect that somebody replaces while a run reads it: what is drawn, and what the results say was drawn,
// is the old one or the new one.
#include <fmt/format.h>

#include <atomic>
#include <functional>

#include "tests/command/program.h"
#include "tests/faults/every.h"

namespace plume {
namespace {

constexpr const char* kScene =
    "name = 'S'\n[camera]\nposition = [0, 1, 6]\ntarget = [0, 1, 0]\n[[instance]]\nname = 'it'\neffect = "
    "'puff'\n"
    "call_tick = 0\nposition = [0, 1, 0]\n";

std::string effect_of(double radius_m) {
  return fmt::format(
      "name = 'Puff'\n[[emitter]]\nname = 'puffs'\n[emitter.spawn]\nrate = 60.0\nduration = 100\nlife = [20, "
      "40]\n"
      "[emitter.look]\nradius_m = {}\nopacity = 0.5\n",
      radius_m);
}

class ReplacedPresetTest : public ProgramTest {
 protected:
  void SetUp() override {
    ProgramTest::SetUp();
    write("presets/scenes/s.toml", kScene);
    for (const std::string& effect : effects_) {
      write(file_, effect);
      ASSERT_EQ(draw().exit_code, 0);
      drawn_[plan()] = pictures();
    }
    ASSERT_EQ(drawn_.size(), 2u);
  }
  Outcome draw() {
    fs::remove_all(at("out"));
    return run({"compare", "s", "--at", "30", "--methods", "sorted", "--size", "48x27", "--frames", "1"},
               {{"PLUME_PRESETS", at("presets").string()}});
  }
  std::string plan() const { return results()["plan"]["id"]; }

  void draw_while(const std::function<void(const std::string&)>& replace, uint64_t most_ms) {
    std::atomic<bool> done = false;
    std::thread other([&] {
      for (uint64_t turn = 0; !done; ++turn) {
        replace(effects_[turn % 2]);
        std::this_thread::sleep_for(std::chrono::milliseconds(1 + turn * 37 % most_ms));
      }
    });
    int whole = 0;
    for (uint64_t i = 0; i < 160; i += every(40)) {
      const Outcome outcome = draw();
      if (outcome.exit_code == 0) {
        ++whole;
        EXPECT_TRUE(drawn_.contains(plan()));
        EXPECT_EQ(pictures(), drawn_[plan()]) << "another effect was drawn than is told";
      } else {
        EXPECT_EQ(outcome.exit_code, 2);
        EXPECT_TRUE(says(outcome.err, {"puff"}));
      }
    }
    done = true;
    other.join();
    EXPECT_GT(whole, 0);
  }

  const fs::path file_ = "presets/effects/puff.toml";
  const std::string effects_[2] = {effect_of(0.2), effect_of(0.6)};
  std::map<std::string, std::map<std::string, std::string>> drawn_;  // by plan
};

TEST_F(ReplacedPresetTest, ByRenamingIsDrawnAsItIsTold) {
  draw_while(
      [&](const std::string& effect) {
        write("new", effect);
        fs::rename(at("new"), at(file_));
      },
      400);  // what is renamed more often than every 50 ms is never at rest
}

TEST_F(ReplacedPresetTest, InPlaceIsDrawnAsItIsTold) {
  draw_while([&](const std::string& effect) { write(file_, effect); }, 400);
}

TEST_F(ReplacedPresetTest, AfterItWasDeletedIsDrawnAsItIsToldOrNamed) {
  draw_while(
      [&](const std::string& effect) {
        fs::remove(at(file_));
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
        write(file_, effect);
      },
      200);
}

}  // namespace
}  // namespace plume
