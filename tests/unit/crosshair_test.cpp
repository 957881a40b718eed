#include "sandbox/workspace/crosshair.h"

#include <gtest/gtest.h>

namespace plume {
namespace {

TEST(CrosshairPlaceTest, StaysExactlyOnItsPixel) {
  Crosshair crosshair;
  for (const glm::uvec2 size :
       {glm::uvec2(1, 1), glm::uvec2(96, 54), glm::uvec2(97, 53), glm::uvec2(3840, 2160)})
    for (uint32_t x = 0; x < size.x; x += 1 + size.x / 97)
      for (uint32_t y = 0; y < size.y; y += 1 + size.y / 89) {
        crosshair.place(glm::ivec2(x, y), size);
        ASSERT_EQ(crosshair.pixel(size), glm::uvec2(x, y)) << size.x << "x" << size.y;
      }
}

TEST(CrosshairPlaceTest, SurvivesAChangeOfResolution) {
  Crosshair crosshair;
  crosshair.place({30, 11}, {96, 54});
  for (const uint32_t finer : {2u, 3u, 10u}) {
    const glm::uvec2 at = crosshair.pixel(glm::uvec2(96, 54) * finer);
    EXPECT_EQ(at / finer, glm::uvec2(30, 11));
  }
  EXPECT_EQ(crosshair.pixel({96, 54}), glm::uvec2(30, 11));  // no drift
}

TEST(CrosshairPlaceTest, KeepsItsDirectionOfViewInANarrowerPicture) {
  Crosshair crosshair;
  crosshair.place({60, 27}, {96, 54});  // 12.5 pixels right of the middle
  EXPECT_EQ(crosshair.pixel({54, 54}), glm::uvec2(39, 27));
  EXPECT_EQ(crosshair.pixel({10, 54}), glm::uvec2(9, 27));  // outside: at the edge
  EXPECT_EQ(crosshair.pixel({96, 54}), glm::uvec2(60, 27));
}

TEST(CrosshairPlaceTest, MovesByPixelsAndStopsAtTheEdge) {
  Crosshair crosshair;
  crosshair.place({1, 52}, {96, 54});
  crosshair.move({-1, 1}, {96, 54});
  EXPECT_EQ(crosshair.pixel({96, 54}), glm::uvec2(0, 53));
  crosshair.move({-1, 1}, {96, 54});
  EXPECT_EQ(crosshair.pixel({96, 54}), glm::uvec2(0, 53));
}

}  // namespace
}  // namespace plume
