// Accuracy against time of the methods that were shown on one and the same picture.
#ifndef PLUME_WORKSPACE_ACCURACY_LOG_H
#define PLUME_WORKSPACE_ACCURACY_LOG_H

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "renderer/frame.h"
#include "sandbox/measure/picture.h"

namespace plume {

class AccuracyLog {
 public:
  struct Entry {
    std::string method;
    nlohmann::json settings;  ///< as results.json gives them
    double rmse, flip;        ///< against the reference
    double ms;                ///< the method's own, of its last drawing
  };

  const std::vector<Entry>& entries() const { return entries_; }
  bool has(const MethodInstance& instance) const;
  /// Another picture: what was measured is no longer true.
  void clear() { entries_.clear(); }
  /// Replaces what was known of the method with these settings.
  void add(const MethodInstance& instance, const DrawnPicture& picture, const DrawnPicture& exact, double ms);

 private:
  std::vector<Entry> entries_;
};

}  // namespace plume
#endif
