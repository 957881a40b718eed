// What two runs of one plan on one device and build must agree in, to the byte: everything in results.json
// but times.
#ifndef PLUME_RUNS_WITHOUT_TIMES_H
#define PLUME_RUNS_WITHOUT_TIMES_H

#include <nlohmann/json.hpp>

namespace plume {

/// A results.json, or any part of one, less its times and what is said about them.
nlohmann::json without_times(nlohmann::json results);

}  // namespace plume
#endif
