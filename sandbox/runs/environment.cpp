#include "sandbox/runs/environment.h"

#include <thread>

#include "sandbox/runs/build_info.h"
#include "sandbox/runs/machine_load.h"

namespace plume {

nlohmann::json environment_of(const gpu::Device& device) {
  const Processor processor = read_processor();
  return {{"device", device.info().name}, {"driver", device.info().driver},
          {"api", device.info().api},     {"build", build_name()},
          {"commit", build_commit()},     {"threads", std::thread::hardware_concurrency()},
          {"cpu", processor.name},        {"cores", processor.cores}};
}

}  // namespace plume
