// The methods there are.
#ifndef PLUME_METHODS_METHODS_H
#define PLUME_METHODS_METHODS_H

#include <memory>
#include <string>
#include <vector>

#include "renderer/methods/method.h"

namespace plume {

/// With its default parameters; null when there is no method of that name.
std::unique_ptr<Method> make_method(std::string_view id);
/// In the order in which they are listed, reference first.
std::vector<std::string> method_ids();

}  // namespace plume
#endif
