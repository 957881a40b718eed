#include <cstdio>
#include "sandbox/scene/stage.h"
#include "renderer/methods/methods.h"
#include "sandbox/measure/image_io.h"
using namespace plume;
int main(int argc, char** argv) {
  gpu::Device device({.validate = true});
  gpu::Shaders shaders(getenv("PLUME_SHADERS") ? getenv("PLUME_SHADERS") : "");
  gpu::Pipelines pipelines(device, shaders);
  PresetLibrary library(preset_root());
  Stage stage(device, pipelines, library, library.scene(argv[1]));
  Targets targets(device, {uint32_t(getenv("W")?atoi(getenv("W")):640),uint32_t(getenv("H")?atoi(getenv("H")):360)});
  for (auto& t : stage.go_to(uint32_t(atoi(argv[2])), targets.size)) printf("%s %.2f ms\n", t.name.c_str(), t.ms);
  for (int a = 3; a < argc; ++a) {
    MethodInstance m{make_method(argv[a]), {}};
    auto r = render_frame(device, pipelines, targets, stage.prelude(), stage.transparents(), m);
    r = render_frame(device, pipelines, targets, stage.prelude(), stage.transparents(), m);
    printf("%s: %u cards\n", argv[a], stage.transparents().count);
    for (auto& t : r.passes) printf("  %s %.2f ms\n", t.name.c_str(), t.ms);
    auto px = gpu::read<std::array<uint8_t,4>>(device, targets.display);
    DisplayImage img; img.width=int(targets.size.x); img.height=int(targets.size.y); for (auto& p : px) img.pixels.push_back({p[0],p[1],p[2]});
    write_png(std::string(std::string(getenv("SHOT_OUT") ? getenv("SHOT_OUT") : "/tmp/shots/"))+argv[a]+".png", img);
  }
  for (auto& m : device.validation_messages()) printf("VALIDATION %s\n", m.c_str());
}
