// A device with validation for every GPU test: any message of the layers fails the test.
#ifndef PLUME_TESTS_GPU_TEST_H
#define PLUME_TESTS_GPU_TEST_H

#include <gtest/gtest.h>

#include <cstdlib>

#include "renderer/methods/methods.h"
#include "sandbox/measure/picture.h"
#include "sandbox/scene/stage.h"

namespace plume {

class GpuTest : public testing::Test {
 protected:
  explicit GpuTest(bool validate = true)
      // PLUME_TEST_SYNCHRONIZATION=1 checks hazards too, at several times the cost.
      : device({.validate = validate,
                .synchronization_validation =
                    validate && std::getenv("PLUME_TEST_SYNCHRONIZATION") != nullptr}) {}

  gpu::Device device;
  // PLUME_TEST_SHADERS=folder takes shaders from there: to see that a test fails on a broken one.
  gpu::Shaders shaders{std::getenv("PLUME_TEST_SHADERS") ? std::getenv("PLUME_TEST_SHADERS") : ""};
  gpu::Pipelines pipelines{device, shaders};
  PresetLibrary library{PLUME_SOURCE_PRESETS};

  void TearDown() override {
    for (const std::string& message : device.validation_messages()) ADD_FAILURE() << message;
  }

  MethodInstance instance(std::string_view id, const std::map<std::string, std::string>& settings = {}) {
    MethodInstance made{.method = make_method(id), .owner = std::string(id), .resources = {}};
    for (const auto& [name, value] : settings) set_parameter(*made.method, name, value);
    return made;
  }

  DrawnPicture draw(Stage& stage, const Targets& targets, MethodInstance& method) {
    render_frame(device, pipelines, targets, stage.prelude(), stage.transparents(), method);
    return read_picture(device, targets);
  }

  DrawnPicture draw(Stage& stage, uint32_t tick, glm::uvec2 size, std::string_view id,
                    const std::map<std::string, std::string>& settings = {}) {
    const Targets targets(device, size, stage.post());
    stage.go_to(tick, size);
    MethodInstance method = instance(id, settings);
    return draw(stage, targets, method);
  }
};

}  // namespace plume
#endif
