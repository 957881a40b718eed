// What the method of a side says of its last picture. Asking waits for the device, so that it is asked at
// most kAnswersPerSecond times a second while pictures follow each other, and once when the picture stands
// still.
#ifndef PLUME_WORKSPACE_METHOD_ACCOUNT_H
#define PLUME_WORKSPACE_METHOD_ACCOUNT_H

#include "sandbox/workspace/workspace.h"

namespace plume {

class MethodAccount {
 public:
  static constexpr double kAnswersPerSecond = 4;

  /// For every turn of the window's loop, after drawing.
  void update(Workspace& workspace, Side& side, double now_s);
  /// What the side's picture lacks; nothing: its method was not drawn yet.
  const std::optional<std::vector<std::string>>& shortfalls(const Side& side) const;

 private:
  std::string told_by_;  // the method's owner
  uint64_t picture_ = 0;
  double told_s_ = -1e9;
  std::optional<std::vector<std::string>> shortfalls_;
};

}  // namespace plume
#endif
