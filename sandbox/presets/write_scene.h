// A scene as the text of a file that reads back as the same scene, to the bit. For scenes that have been
// changed while they were shown; a file that somebody writes is edited by PresetDocument instead, which keeps
// comments. Figures are written as the spheres and capsules they are made of.
#ifndef PLUME_PRESETS_WRITE_SCENE_H
#define PLUME_PRESETS_WRITE_SCENE_H

#include <string>

#include "sandbox/scene/scene.h"

namespace plume {

/// All but the id, which is the file's name.
std::string scene_text(const Scene& scene);

/// The lines of a camera's table, without its tick.
std::string camera_text(const CameraKey& camera);

}  // namespace plume
#endif
