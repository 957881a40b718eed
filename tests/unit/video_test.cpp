// A video by ffmpeg: here a program of that name that does what the test wants.
#include "sandbox/workspace/video.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cstdlib>
#include <fstream>
#include <memory>
#include <thread>
#include <vector>

namespace plume {
namespace {

namespace fs = std::filesystem;

class VideoTest : public testing::Test {
 protected:
  VideoTest() {
    fs::remove_all(folder_);
    fs::create_directories(folder_);
    setenv("PATH", folder_.c_str(), 1);
  }
  ~VideoTest() override {
    setenv("PATH", path_.c_str(), 1);
    fs::remove_all(folder_);
  }

  void ffmpeg(const std::string& script) {
    std::ofstream(folder_ / "ffmpeg") << "#!/bin/sh\nPATH=/bin:/usr/bin\n" << script;
    fs::permissions(folder_ / "ffmpeg", fs::perms::owner_all);
  }
  std::unique_ptr<Video> video() {
    return std::make_unique<Video>(folder_ / "pictures", folder_ / "out.mp4", 9, 30);
  }
  template <class Done>
  static bool wait_until(Video& video, const Done& done) {
    const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(20);
    while (!done() && std::chrono::steady_clock::now() < deadline) {
      video.poll();
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    return done();
  }

  const std::string path_ = std::getenv("PATH");
  const fs::path folder_ =
      fs::path(testing::TempDir()) /
      (std::string("plume_video_") + testing::UnitTest::GetInstance()->current_test_info()->name());
};

TEST_F(VideoTest, WithoutFfmpegThereIsNone) {
  EXPECT_FALSE(Video::is_available());
  EXPECT_THROW(video(), std::runtime_error);
}

TEST_F(VideoTest, TellsHowFarItIsAndWhenItIsDone) {
  ffmpeg(
      "for file in \"$@\"; do :; done; echo whole > \"$file\"; echo frame=2; echo progress=continue; echo "
      "frame=5; while [ ! -e " +
      (folder_ / "go_on").string() + " ]; do sleep 0.01; done; echo frame=9\n");
  EXPECT_TRUE(Video::is_available());
  Video running(folder_ / "pictures", folder_ / "out.mp4", 9, 30);
  EXPECT_TRUE(wait_until(running, [&] { return running.done() == 5; }));
  EXPECT_FALSE(running.is_done());
  std::ofstream(folder_ / "go_on") << "now";
  EXPECT_TRUE(wait_until(running, [&] { return running.is_done(); }));
  EXPECT_EQ(running.done(), 9u);
}

TEST_F(VideoTest, GivesThePicturesTheRateAndTheFile) {
  ffmpeg("for word in \"$@\"; do echo \"$word\" >> " + (folder_ / "words").string() +
         "; done; echo whole > \"$word\"\n");
  Video running(folder_ / "100% pictures", folder_ / "out.mp4", 9, 30);
  ASSERT_TRUE(wait_until(running, [&] { return running.is_done(); }));
  std::ifstream in(folder_ / "words");
  const std::string words{std::istreambuf_iterator<char>(in), {}};
  EXPECT_NE(words.find("-framerate\n30\n-i\n" + (folder_ / "100%% pictures/frame_%06d.png").string() + "\n"),
            std::string::npos)
      << words;
  EXPECT_NE(words.find("-f\nmp4\n" + (folder_ / "out.mp4.tmp-").string()), std::string::npos) << words;
}

TEST_F(VideoTest, StandsUnderItsNameOnceItIsWhole) {
  const std::string write = "for file in \"$@\"; do :; done; echo whole > \"$file\"; echo frame=1; ";
  const auto files = [&] {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder_))
      if (entry.path().filename() != "ffmpeg") names.push_back(entry.path().filename());
    return names;
  };
  ffmpeg(write + "exec sleep 60\n");
  {
    Video stopped(folder_ / "pictures", folder_ / "out.mp4", 9, 30);
    ASSERT_TRUE(wait_until(stopped, [&] { return stopped.done() == 1; }));
    EXPECT_EQ(files().size(), 1u);
    EXPECT_FALSE(fs::exists(folder_ / "out.mp4"));
  }
  EXPECT_TRUE(files().empty());
  ffmpeg(write + "exit 1\n");
  {
    Video failed(folder_ / "pictures", folder_ / "out.mp4", 9, 30);
    EXPECT_THROW(wait_until(failed, [&] { return failed.is_done(); }), std::runtime_error);
  }
  EXPECT_TRUE(files().empty());
  ffmpeg(write);
  Video good(folder_ / "pictures", folder_ / "out.mp4", 9, 30);
  ASSERT_TRUE(wait_until(good, [&] { return good.is_done(); }));
  EXPECT_EQ(files(), std::vector<std::string>{"out.mp4"});
}

TEST_F(VideoTest, ThatFailsSaysWhatFfmpegSaid) {
  ffmpeg("echo 'Unknown encoder' >&2; exit 1\n");
  Video running(folder_ / "pictures", folder_ / "out.mp4", 9, 30);
  try {
    wait_until(running, [&] { return running.is_done(); });
    FAIL() << "no error";
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("Unknown encoder"), std::string::npos);
  }
  EXPECT_TRUE(running.is_done());
}

TEST_F(VideoTest, ThatIsStoppedEndsFfmpeg) {
  ffmpeg("echo $$ > " + (folder_ / "pid").string() + "; echo frame=1; exec sleep 60\n");
  pid_t pid = 0;
  {
    Video running(folder_ / "pictures", folder_ / "out.mp4", 9, 30);
    ASSERT_TRUE(wait_until(running, [&] { return running.done() == 1; }));
    std::ifstream(folder_ / "pid") >> pid;
  }
  ASSERT_GT(pid, 0);
  EXPECT_FALSE(fs::exists("/proc/" + std::to_string(pid)));
}

}  // namespace
}  // namespace plume
