// What a picture lacks of what its method can do, in sentences for people.
#ifndef PLUME_MEASURE_SHORTFALLS_H
#define PLUME_MEASURE_SHORTFALLS_H

#include "renderer/methods/method.h"

namespace plume {

/// "Fragments that found no layer free and were merged into the farthest: 36 120. Raise `nodes`." One for
/// each of the method's shortfalls that its statistics have counted, in the method's order.
std::vector<std::string> shortfall_sentences(const Method& method, const nlohmann::json& statistics);

}  // namespace plume
#endif
