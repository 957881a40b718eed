// Time that the calling thread has spent on a processor: what work costs, whoever else is busy.
#ifndef PLUME_WORKSPACE_CPU_CLOCK_H
#define PLUME_WORKSPACE_CPU_CLOCK_H

#include <ctime>

namespace plume {

inline double thread_cpu_ms() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return double(now.tv_sec) * 1e3 + double(now.tv_nsec) * 1e-6;
}

}  // namespace plume
#endif
