// What one looks at and works on: a scene at a tick, seen by a camera, drawn by one method or by two side by
// side. Knows no window: panels show and change it, the viewer draws what has changed.
#ifndef PLUME_WORKSPACE_WORKSPACE_H
#define PLUME_WORKSPACE_WORKSPACE_H

#include <functional>
#include <memory>

#include "sandbox/measure/timing_history.h"
#include "sandbox/scene/bad_particles.h"
#include "sandbox/workspace/accuracy_log.h"
#include "sandbox/workspace/instance_switches.h"
#include "sandbox/workspace/open_documents.h"
#include "sandbox/workspace/playback.h"
#include "sandbox/workspace/resolution_control.h"
#include "sandbox/workspace/side_view.h"
#include "sandbox/workspace/surface_point.h"

namespace plume {

/// One picture of the scene, by one of the methods.
struct Side {
  std::vector<MethodInstance> methods;  ///< all there are, so that each keeps its settings
  size_t current = 0;
  std::optional<Targets> targets;  ///< nothing: it is not drawn
  TimingHistory timings;
  FrameReport report;  ///< of the last drawing
  SideView view;       ///< instead of the picture

  MethodInstance& method() { return methods[current]; }
};

enum class Comparison {
  kNone,   ///< side A alone
  kSplit,  ///< A to the left of the divider, B to the right
  kFlip    ///< B in the place of A
};

class Workspace {
 public:
  /// Throws what Stage throws.
  Workspace(gpu::Device& device, gpu::Pipelines& pipelines, const PresetLibrary& library, Scene scene,
            const Playback& playback);

  gpu::Device& device() { return device_; }
  gpu::Pipelines& pipelines() { return pipelines_; }
  const PresetLibrary& library() const { return library_; }
  const Stage& stage() const { return *stage_; }
  const Scene& scene() const { return stage_->scene(); }

  /// Shows another scene from its default tick, with the scene's own camera. Throws what the library throws,
  /// and leaves everything as it was.
  void open_scene(const std::string& id);
  /// Changes the scene that is shown, at the tick that is shown, and not its text.
  void change_scene(const std::function<void(Scene&)>& change);

  /// Effects and scenes that are worked on. An edit is seen in the next picture.
  OpenDocuments documents, scenes;
  /// The text of the scene that is shown; nullptr: it is of no file.
  PresetDocument* scene_document();
  /// Shows what was edited of the scene at once.
  void take_edits();
  /// Writes the scene as it is now as another of the library, and works on that from now on. Throws
  /// FileError, and std::invalid_argument when there is no document, `id` is no name for a file, or it is
  /// taken.
  void save_scene_as(const std::string& id);
  /// Of an effect ("": none) and the scene, the text that the last step is to be taken back of, or made
  /// again; nullptr: there is none. Throws what the library throws.
  PresetDocument* to_undo(const std::string& effect);
  PresetDocument* to_redo(const std::string& effect);
  /// Which instances are heard and whose time goes on; likewise.
  InstanceSwitches switches;
  /// Why the scene cannot bear the effects as they were edited last, and shows those before; empty: it can.
  const std::string& refused_edits() const { return refused_edits_; }
  /// The opaque surface that is seen at a place of the picture that was drawn last: shares of its width and
  /// height, from the upper left. Nothing: the sky.
  std::optional<SurfacePoint> surface_at(glm::vec2 place);
  /// As the picture that was drawn last was seen.
  shared::ViewData drawn_view() const;
  /// Calls an effect at the tick that is shown, on that surface, as one edit of the scene's text. Returns
  /// false, and does nothing, where there is only sky. Throws what the library throws and FileErrors, and
  /// std::runtime_error when the scene is of no file.
  bool drop_effect(const std::string& effect, glm::vec2 place);

  CameraKey camera() const;
  /// One's own from now on.
  void set_camera(const CameraKey& camera);
  bool has_own_camera() const { return camera_.has_value(); }
  void follow_scene_camera();

  /// Leaves the old method without memory, and its times behind.
  void choose_method(Side& side, size_t method);
  void compare(Comparison comparison);
  Comparison comparison() const { return comparison_; }
  /// Whether a side is drawn.
  bool shows(const Side& side) const;

  /// The picture no longer shows what is set.
  void change() { outdated_ = true; }
  /// Makes all pipelines anew, and draws with them what was drawn with the old ones. A failure throws
  /// ShaderError and keeps the old ones.
  void reload_shaders();
  bool is_outdated() const { return outdated_; }
  /// Draws what is shown in an area of so many pixels. Throws what Stage throws; a ShaderError leaves what
  /// was shown, and no change that would be drawn again.
  void draw(glm::uvec2 area);
  /// Draws the reference of the picture that is shown, unless that was done, and measures the methods that
  /// are shown against it, unless they were. Returns whether there was anything to do.
  bool measure_accuracy();
  const AccuracyLog& accuracy() const { return accuracy_; }
  /// What views of the error, and the measurements, are held against.
  const GroundTruth& truth() const { return inspector_.truth; }
  /// Notes the time that has passed: plays, and reads what was changed on disk. True when the picture must
  /// be drawn.
  bool advance(double now_s);
  /// Of what is shown; nothing before the first drawing.
  const std::optional<Targets>& shown() const { return shows(a) ? a.targets : b.targets; }
  /// What the last drawing left out.
  const BadParticles& bad_particles() const { return bad_particles_; }
  /// How many different pictures have been drawn: the same number, the same picture.
  uint64_t picture() const { return picture_; }
  /// Counts scenes, their changes and edits: the same number, the same stage since.
  uint64_t scene_version() const { return scene_version_; }
  /// Wall time of the last drawing.
  double frame_ms() const { return frame_ms_; }

  Side a, b;
  Playback playback;
  ResolutionControl resolution;
  float divider = 0.5f;      ///< share of the picture's width that is A's
  bool compares = false;     ///< measures what is shown against the reference when it stands still
  bool always_draw = false;  ///< draws though nothing changed, so that times mean something
  std::string problem;       ///< what last went wrong, for the user to read; empty: nothing

 private:
  /// All that a picture depends on but the method.
  struct PictureKey {
    uint64_t scene = 0;  // counts scenes and their changes
    uint32_t tick = 0;
    glm::vec3 position{0}, target{0};
    float fov = 0;
    glm::uvec2 size{0};
    bool operator==(const PictureKey&) const = default;
  };
  struct Applied {                    ///< of the edits, in the stage
    uint64_t effects = 0, scene = 0;  // revisions
    InstanceSwitches switches;
    bool operator==(const Applied&) const = default;
  };
  Applied wanted_edits();
  SceneEdits edits_with(const InstanceSwitches& wanted, size_t instances) const;
  void open_scene_document();
  void show_scene(Scene scene);
  std::vector<PresetDocument*> worked_on(const std::string& effect);
  void open_documents();
  void draw_side(Side& side, glm::uvec2 size, const std::vector<gpu::PassTime>& simulation);
  bool needs_truth() const;

  gpu::Device& device_;
  gpu::Pipelines& pipelines_;
  const PresetLibrary& library_;
  std::unique_ptr<Stage> stage_;
  std::string scene_file_;        // that `scenes` calls the document; "": there is none
  std::optional<uint32_t> seed_;  // instead of that of the document
  uint64_t shown_scene_ = 0;      // revision of the document that the stage shows
  Applied applied_;
  std::string refused_edits_;
  std::optional<CameraKey> camera_;  // nothing: the scene's own
  AccuracyLog accuracy_;
  PictureKey key_;  // of the last drawing
  uint64_t scene_version_ = 0;
  Comparison comparison_ = Comparison::kNone;
  bool outdated_ = true;
  double frame_ms_ = 0;  // that drawing took last
  uint64_t picture_ = 0;
  BadParticles bad_particles_;
  Inspector inspector_;
  std::optional<SurfaceDepths> surface_;  // of picture surface_of_
  uint64_t surface_of_ = 0;
};

}  // namespace plume
#endif
