// Saving effects and scenes, and the questions that come with it; they stand over the picture until they are
// answered.
#ifndef PLUME_DEBUGGER_FILE_QUESTIONS_H
#define PLUME_DEBUGGER_FILE_QUESTIONS_H

#include "sandbox/debugger/interface.h"

namespace plume {

/// What is not saved, in the words of the user: "scene street", "effect sparks".
std::vector<std::string> unsaved(Workspace& workspace);
/// Saves one of `documents`, or asks where somebody else has changed the file. What goes wrong becomes the
/// workspace's problem. Whether it is saved.
bool save(Interface& interface, OpenDocuments& documents, const std::string& name);
/// Closes the window, once what is not saved is decided.
void close_window(Interface& interface);
void ask_about_files(Interface& interface);

}  // namespace plume
#endif
