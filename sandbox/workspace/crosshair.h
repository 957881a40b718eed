// The one pixel that is looked into, and what is known of it. It is asked again when the picture or the pixel
// has changed: of the methods that are shown at most kAnswersPerSecond times a second while pictures follow
// each other, for little more than a draw of one pixel; of others, which must be drawn for it, only once the
// picture has stood still. What is not of the present picture says so.
#ifndef PLUME_WORKSPACE_CROSSHAIR_H
#define PLUME_WORKSPACE_CROSSHAIR_H

#include <map>

#include "sandbox/measure/pixel_probe.h"
#include "sandbox/workspace/workspace.h"

namespace plume {

class Crosshair {
 public:
  static constexpr double kAnswersPerSecond = 4, kStillSeconds = 0.3;

  bool placed() const { return direction_.has_value(); }
  /// On a pixel of a picture of `size`. Kept as a direction of view, in heights of the picture from its
  /// middle: exact at that size, and on the same thing at others.
  void place(glm::ivec2 pixel, glm::uvec2 size);
  void place(glm::dvec2 direction) { direction_ = direction; }
  void move(glm::ivec2 pixels, glm::uvec2 size);
  /// Others leave their memory.
  void remove(Workspace& workspace);
  /// Where it is in a picture of `size`: at its edge where it would be outside. It must be placed.
  glm::uvec2 pixel(glm::uvec2 size) const;

  /// Methods beside those that are shown, by id, with the settings that they have on side A.
  const std::vector<std::string>& others() const { return others_; }
  void ask_of_others(Workspace& workspace, std::vector<std::string> ids);

  /// Asks where something has changed. For every turn of the window's loop, after drawing.
  void update(Workspace& workspace, double now_s);
  /// The last answer: methods shown first, then others. Nothing: there was none yet.
  const std::optional<PixelProbe>& told() const { return told_; }
  /// Why that is not of what is shown now, for people; empty: it is.
  std::string stale_because(const Workspace& workspace) const;
  /// Others that wait until the picture stands still.
  std::vector<std::string> waiting(Workspace& workspace) const;

 private:
  struct Question {
    uint64_t picture = 0;
    glm::uvec2 pixel{0}, size{0};
    bool operator==(const Question&) const = default;
  };
  std::optional<Question> question(const Workspace& workspace) const;
  MethodInstance* other(Workspace& workspace, const std::string& id) const;
  bool draw_others(Workspace& workspace);
  void ask(Workspace& workspace, const Question& question);

  std::optional<glm::dvec2> direction_;
  std::vector<std::string> others_;
  std::map<std::string, uint64_t> drawn_;  // other -> picture it was drawn for
  std::optional<Targets> targets_;         // that others are drawn into
  std::optional<PixelProbe> told_;
  Question answered_;
  uint64_t seen_picture_ = 0;
  double picture_since_s_ = 0, answered_s_ = -1e9;
  bool others_changed_ = false;
};

}  // namespace plume
#endif
