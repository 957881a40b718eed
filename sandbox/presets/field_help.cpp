#include "sandbox/presets/field_help.h"

#include <algorithm>

#include "sandbox/presets/value_path.h"

namespace plume {
namespace {

constexpr FieldHelp kHelp[] = {
    {"name", "What lists call it.", "New"},
    {"description", "One sentence for lists: what is to be seen, and for how long."},
    {"off_screen",
     "What happens while nobody looks: time goes on as if it had been watched, or stands still."},
    {"layer", "Named depth offsets that emitters share, to choose what shows through what."},
    {"layer.name", "What emitters and scenes call this layer.", "layer"},
    {"layer.camera_offset_m",
     "Moves all in this layer along the line of sight, towards the camera where positive. Its size in the "
     "picture stays."},
    {"bounds", "A box about the effect: what leaves it ends. Tight bounds let the effect sleep when unseen."},
    {"bounds.position_m", "Centre of the box, from the effect's origin."},
    {"bounds.size_m", "Full width, height and depth of the box.", "[20.0, 20.0, 20.0]"},

    {"emitter", "The parts of the effect: each bears one kind of particle."},
    {"emitter.name", "What this part is called.", "emitter"},
    {"emitter.parent", "Particles are born where those of another emitter are: trails, splashes, debris."},
    {"emitter.parent.emitter", "The emitter whose particles bear these. It stands earlier in the list."},
    {"emitter.parent.on",
     "When they are born: as the parent is born, all along its life, as it dies, or where it hits something.",
     "\"death\""},
    {"emitter.parent.count", "Particles each time."},
    {"emitter.parent.collisions", "How many hits of one parent count; later ones bear nothing."},
    {"emitter.parent.every_ticks", "Time from one particle to the next. Fewer make a denser trail.", "2"},
    {"emitter.parent.first_tick", "Age of the parent at which its trail begins."},
    {"emitter.parent.inherit_velocity",
     "Share of the parent's velocity that they start with; below 0 they fly backwards."},

    {"emitter.spawn", "How many particles are born, when, and how long they live."},
    {"emitter.spawn.rate", "Particles a second: one number for a time, or keys of tick and rate.", "20.0",
     true},
    {"emitter.spawn.duration", "For how long a constant rate goes on.", "120"},
    {"emitter.spawn.bursts", "Many at once: at which tick, how many."},
    {"emitter.spawn.per_metre", "Particles for each metre that the effect travels on its path."},
    {"emitter.spawn.life", "How long a particle lives; each draws its own between the two.", "[60, 120]"},

    {"emitter.shape", "Where particles are born and which way is outwards."},
    {"emitter.shape.kind", "The form that particles are born in."},
    {"emitter.shape.radius_m", "Radius of the ball, the ring or the foot of the cone.", "0.5"},
    {"emitter.shape.thickness", "0 bears on the surface only, 1 in the whole body."},
    {"emitter.shape.size_m", "Full width, height and depth of the box.", "[1.0, 1.0, 1.0]"},
    {"emitter.shape.angle_deg", "How far directions lean from straight up, at most.", "20.0"},
    {"emitter.shape.to_m", "The other end of the line, as seen from the first.", "[1.0, 0.0, 0.0]"},
    {"emitter.shape.mesh", "Births all over the surface of this mesh, outwards along its normals."},
    {"emitter.shape.scale", "Size of the mesh: metres for a unit of its file."},
    {"emitter.shape.offset_m", "Moves the shape from the effect's origin."},

    {"emitter.motion", "What moves the particles."},
    {"emitter.motion.speed",
     "Speed outwards at birth; each draws its own between the two. Below 0: inwards."},
    {"emitter.motion.velocity", "Added at birth, the same for all."},
    {"emitter.motion.gravity", "1 falls as on Earth, 0 floats, below 0 rises."},
    {"emitter.motion.drag", "How firmly the air holds: larger takes on the wind's speed sooner."},
    {"emitter.motion.wind", "Share of the scene's wind that these feel."},
    {"emitter.motion.buoyancy", "Pull upwards of hot gas as it is born; it cools away."},
    {"emitter.motion.cooling_s", "Time in which the pull upwards falls to about a third."},
    {"emitter.motion.floor_y", "Height in the scene below which nothing falls."},
    {"emitter.motion.orbit", "Turns everything about the upright axis, so many times a second."},
    {"emitter.motion.curl", "Swirling without a pattern: what makes smoke billow."},
    {"emitter.motion.curl.strength", "How hard the swirls push.", "2.0"},
    {"emitter.motion.curl.scale_m", "Size of the largest swirls."},
    {"emitter.motion.curl.speed", "How fast the swirls drift upwards."},
    {"emitter.motion.curl.octaves", "Finer swirls within the swirls. Each costs time."},
    {"emitter.motion.vortex", "A whirl about the upright axis."},
    {"emitter.motion.vortex.strength", "How hard it turns them, at its core.", "2.0"},
    {"emitter.motion.vortex.radius_m", "Radius of its core."},
    {"emitter.motion.vortex.pull", "Draws in to the axis; below 0 throws out."},
    {"emitter.motion.attractor", "Points or lines that pull particles, or push them off."},
    {"emitter.motion.attractor.position", "The point that pulls."},
    {"emitter.motion.attractor.from", "One end of the line that pulls.", "[0.0, 0.0, 0.0]"},
    {"emitter.motion.attractor.to", "The other end of the line.", "[0.0, 1.0, 0.0]"},
    {"emitter.motion.attractor.strength", "Pull at the radius; below 0 pushes off.", "2.0"},
    {"emitter.motion.attractor.radius_m", "Within this distance the pull softens to nothing."},
    {"emitter.motion.field", "Directions from a file (.fga), painted in another program."},
    {"emitter.motion.field.file", "Which file of the folder fields."},
    {"emitter.motion.field.as", "Whether its vectors push, or are a wind that drag pulls to."},
    {"emitter.motion.field.strength", "Times the vectors of the file."},
    {"emitter.motion.field.scale", "Size of the field: metres for a unit of its file."},
    {"emitter.motion.field.offset_m", "Moves the field from the emitter's origin."},
    {"emitter.motion.kill", "Where particles end."},
    {"emitter.motion.kill.kind", "The form of the place."},
    {"emitter.motion.kill.position", "Its centre; of a plane, any point on it."},
    {"emitter.motion.kill.size_m", "Full width, height and depth of the box.", "[4.0, 4.0, 4.0]"},
    {"emitter.motion.kill.radius_m", "Radius of the ball.", "2.0"},
    {"emitter.motion.kill.normal", "What is behind the plane ends; this points to where particles live on."},
    {"emitter.motion.kill.where", "Whether particles end inside or outside."},
    {"emitter.motion.collision", "Particles meet the solid things of the scene."},
    {"emitter.motion.collision.response", "They bounce off, slide along, die or stick."},
    {"emitter.motion.collision.bounce", "Share of the speed that is left after a bounce.", "0.3"},
    {"emitter.motion.collision.friction", "How much sliding along takes away."},
    {"emitter.motion.collision.radius_m", "Size of the body that hits, however large it looks."},
    {"emitter.motion.collision.event_speed", "Softer hits bear no children."},
    {"emitter.motion.curl_displacement",
     "Bends what is drawn as swirling would, and leaves paths alone: cheap detail."},
    {"emitter.motion.curl_displacement.amplitude_m", "How far things move, at most.", "0.1"},
    {"emitter.motion.curl_displacement.scale_m", "Size of the largest swirls."},
    {"emitter.motion.curl_displacement.speed", "How fast the swirls drift upwards."},
    {"emitter.motion.curl_displacement.octaves", "Finer swirls within the swirls. Each costs time."},
    {"emitter.motion.curl_displacement.grow_s", "Age at which it has its full size."},
    {"emitter.motion.analytic",
     "Keeps no state: flight follows from the age alone. For what gravity, drag and wind move, such as "
     "rain."},

    {"emitter.look", "How a particle looks."},
    {"emitter.look.mesh", "Each particle is one of these meshes instead of a flat card."},
    {"emitter.look.radius_m", "Size over life, from birth at 0 to death at 1."},
    {"emitter.look.radius_scale", "Each particle is so much larger or smaller; it draws once."},
    {"emitter.look.lit", "Sun and sky light the colour. Off: the colour shines as it is."},
    {"emitter.look.color", "Colour over life, linear: what it does with light that falls on it."},
    {"emitter.look.emission", "Light of its own over life: fire, sparks."},
    {"emitter.look.tumble_deg_s", "How fast pieces tumble, each about an axis of its own."},
    {"emitter.look.opaque", "Solid pieces that hide what is behind them. Cheaper than glass."},
    {"emitter.look.ribbon", "Joins particles, in the order of birth, to a band: trails, streamers."},
    {"emitter.look.ribbon_births", "After so many a new band begins; 0 makes one of all."},
    {"emitter.look.cross_section_m2",
     "How much smoke is in one puff. It thins by itself as the puff grows, as real smoke does."},
    {"emitter.look.opacity", "How much it hides over life, whatever its size.", "0.8"},
    {"emitter.look.fade", "Times how thick it is, over life: to let it come and go softly."},
    {"emitter.look.feather_m",
     "Fades within this distance of solid things, so that no edge shows where they meet."},
    {"emitter.look.transmission",
     "Share of light that passes where it covers, by colour: tinted glass, coloured smoke."},
    {"emitter.look.diffusion_deg", "Blurs what is seen through it, by this angle: frosted glass, steam."},
    {"emitter.look.camera_offset_m",
     "Moves it along the line of sight, towards the camera where positive, to show through others. Its size "
     "in the picture stays."},
    {"emitter.look.layer", "Takes the depth offset of a named layer, besides its own."},
    {"emitter.look.draw_order", "For methods that draw in an order by hand: lower ones first, behind."},
    {"emitter.look.texture", "What is painted on the card."},
    {"emitter.look.distortion_deg",
     "Bends what is seen through it, as hot air does. It then shows nothing of its own."},
    {"emitter.look.flipbook_loops", "How often the puff's animation runs in a life, however long that is."},
    {"emitter.look.flipbook_fps", "Speed of the puff's animation."},
    {"emitter.look.spin_deg_s", "How fast cards turn; each draws its own between the two."},
    {"emitter.look.stretch_s", "Draws it out along its way, by the way of this time: streaks."},
    {"emitter.look.gloss", "Reflections, as a share of those on glass."},
};

}  // namespace

std::span<const FieldHelp> all_field_help() {
  return kHelp;
}

const FieldHelp* field_help(std::string_view path) {
  const auto help = std::ranges::find(kHelp, pattern_of(path), &FieldHelp::pattern);
  return help == std::end(kHelp) ? nullptr : &*help;
}

}  // namespace plume
