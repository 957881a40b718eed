#include "sandbox/workspace/method_account.h"

#include "sandbox/measure/shortfalls.h"

namespace plume {

void MethodAccount::update(Workspace& workspace, Side& side, double now_s) {
  if (workspace.is_outdated() || !workspace.shows(side) || !side.targets) return;
  MethodInstance& method = side.method();
  const bool same_method = told_by_ == method.owner;
  if (same_method && picture_ == workspace.picture()) return;
  if (same_method && now_s - told_s_ < 1 / kAnswersPerSecond) return;
  shortfalls_ =
      shortfall_sentences(*method.method, method.method->statistics(workspace.device(), method.resources));
  told_by_ = method.owner;
  picture_ = workspace.picture();
  told_s_ = now_s;
}

const std::optional<std::vector<std::string>>& MethodAccount::shortfalls(const Side& side) const {
  static const std::optional<std::vector<std::string>> kNothing;
  return told_by_ == side.methods[side.current].owner ? shortfalls_ : kNothing;
}

}  // namespace plume
