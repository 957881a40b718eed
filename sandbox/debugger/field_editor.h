// A widget for every kind of field that a preset file has (presets/field.h). What the file does not say is
// written dim, with the default; to change it is to write it.
#ifndef PLUME_DEBUGGER_FIELD_EDITOR_H
#define PLUME_DEBUGGER_FIELD_EDITOR_H

#include <span>
#include <string>
#include <vector>

#include "sandbox/presets/preset_document.h"

namespace plume {

/// What the user wants done, once all widgets are through: an edit makes the list of fields anew.
struct FieldEdit {
  enum class Kind { kSet, kAdd, kRemove };
  Kind kind;
  std::string path;
  FieldValue value = false;
};

struct FieldList {
  std::span<const Field> fields;  ///< of a document
  bool only_set = false;          ///< hides what the file does not say
  std::vector<FieldEdit>& edits;
};

/// What is in a table, in the order of the list; "" is the file's top.
void edit_table(const FieldList& list, std::string_view path);
/// One field; a table with all that is in it.
void edit_field(const FieldList& list, const Field& field);

/// Makes the edits. What was wrong with the last that was refused; "" when all were made, and as it was
/// before when there are none.
std::string made(PresetDocument& document, std::span<const FieldEdit> edits, std::string refused_before);

}  // namespace plume
#endif
