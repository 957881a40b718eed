// Accuracy against time of the methods that were shown on one and the same picture.
#ifndef PLUME_WORKSPACE_ACCURACY_LOG_H
#define PLUME_WORKSPACE_ACCURACY_LOG_H

#include <nlohmann/json.hpp>
#include <optional>
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
  bool has_reference() const { return reference_.has_value(); }
  bool has(const MethodInstance& instance) const;
  /// Another picture: what was measured is no longer true.
  void clear();
  void set_reference(DrawnPicture picture) { reference_ = std::move(picture); }
  /// Replaces what was known of the method with these settings. There must be a reference.
  void add(const MethodInstance& instance, const DrawnPicture& picture, double ms);

 private:
  std::optional<DrawnPicture> reference_;
  std::vector<Entry> entries_;
};

}  // namespace plume
#endif
