#include "sandbox/debugger/bad_particles_line.h"

#include <imgui.h>

#include <algorithm>

#include "sandbox/debugger/effects_panel.h"
#include "sandbox/debugger/widgets.h"

namespace plume {
namespace {

/// Where it is still there: effects may have been edited since the picture was drawn.
void select(Interface& interface, const CardOwner& owner) {
  const Stage& stage = interface.workspace.stage();
  const auto& instances = stage.scene().instances;
  const auto instance = std::ranges::find(instances, owner.instance, &Instance::name);
  if (instance == instances.end()) return;
  const auto index = size_t(instance - instances.begin());
  const auto& emitters = stage.effects().at(instance->effect).emitters;
  const auto emitter = std::ranges::find(emitters, owner.emitter, &Emitter::name);
  if (emitter == emitters.end())
    select_instance(interface, index);
  else
    select_instance(interface, index, size_t(emitter - emitters.begin()));
}

}  // namespace

void point_at_bad_particles(Interface& interface) {
  const BadParticles& bad = interface.workspace.bad_particles();
  if (!bad.first) return;
  warning(to_text(bad), "bad particles");
  tooltip("Click: selects the emitter. " + remedy(bad) + ".");
  if (ImGui::IsItemClicked() && !bad.first->pane) select(interface, *bad.first);
}

}  // namespace plume
