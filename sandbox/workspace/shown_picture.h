// What is seen in the window without its panels: one side, or both with the divider between them.
#ifndef PLUME_WORKSPACE_SHOWN_PICTURE_H
#define PLUME_WORKSPACE_SHOWN_PICTURE_H

#include "sandbox/measure/image.h"
#include "sandbox/workspace/workspace.h"

namespace plume {

/// As it was last drawn. Throws std::runtime_error when nothing was.
DisplayImage shown_picture(Workspace& workspace);

}  // namespace plume
#endif
