// What the panels are about: the workspace, and what concerns the window alone.
#ifndef PLUME_DEBUGGER_INTERFACE_H
#define PLUME_DEBUGGER_INTERFACE_H

#include <array>

#include "sandbox/debugger/effect_selection.h"
#include "sandbox/debugger/preset_gallery.h"
#include "sandbox/workspace/crosshair.h"
#include "sandbox/workspace/method_account.h"
#include "sandbox/workspace/recording.h"
#include "sandbox/workspace/settings.h"

namespace plume {

/// In ImGui's coordinates, from the upper left.
struct Area {
  glm::vec2 corner, size;
};

/// How the crosshair's panel shows what it knows.
struct DepthGraph {
  bool logarithmic = true;
  bool each_channel = false;       ///< otherwise the mean of the three
  std::optional<size_t> fragment;  ///< that is pointed out
};
struct CrosshairView {
  DepthGraph graph{};
  size_t weights_of = 0;  ///< among the methods told: whose weights the table has
};

/// The name that a copy of the scene is to have.
struct SceneNaming {
  bool asked = false;  ///< the question is to be opened
  std::array<char, 64> typed{};
  std::string refused;  ///< why not
};

/// Questions that stand over the picture; see file_questions.h.
struct FileQuestions {
  struct Conflict {
    OpenDocuments* documents;
    std::string name;
  };
  std::optional<Conflict> conflict;  ///< what was not saved because its file is another by now
  bool closing = false;              ///< the window would close, but something is not saved
};

struct Interface {
  Workspace& workspace;
  PresetGallery gallery{workspace.library()};
  Crosshair crosshair{};
  CrosshairView crosshair_view{};
  MethodAccount account_a{}, account_b{};  ///< of the sides
  EffectSelection effects;
  FileQuestions questions;
  SceneNaming naming;
  Area picture{{0, 0}, {1, 1}};  ///< where it is in the window

  bool panels = true;  ///< otherwise the picture has the whole window
  bool help = false;   ///< the list of keys is open
  bool full_screen = false;
  bool closing = false;
  float text_scale = 1.0f;  ///< the user's, besides that of the monitor
  Recording recording{};
  Settings settings{};  ///< of the last session; those of this one are taken when it ends
  bool has_ffmpeg = Video::is_available();
  double overlay_cpu_ms = 0;  ///< that the panels took last: described, and recorded for the device
};

}  // namespace plume
#endif
