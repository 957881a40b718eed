// What stands in a particle's way: the scene's solids, which it meets as a ball of its body's radius, and kill volumes.
// Swept: the way of a tick is a segment against every solid grown by the body's radius, with the exact time of impact, so nothing
// is too thin or too fast; what is left of the tick goes on from there as the response says. A plane is the top of a deep box.
// Limits: grown boxes keep their sharp edges, so a body touches an edge up to 0.41 radii early (a corner 0.73); after
// kMostImpacts impacts in one tick the rest of the way is dropped.
#ifndef PLUME_EFFECTS_COLLIDE_GLSL
#define PLUME_EFFECTS_COLLIDE_GLSL
#include "effects/particle.glsl"
#include "shared/motion_tables.h"

layout(scalar, binding = 12) readonly buffer BoxColliders { BoxCollider box_colliders[]; };
layout(scalar, binding = 13) readonly buffer RoundColliders { RoundCollider round_colliders[]; };
layout(scalar, binding = 14) readonly buffer KillVolumes { KillVolumeData kill_volumes[]; };

const uint kMostImpacts = 4u;   // a corner of three walls, and once more
const float kNever = 2.0;       // shares of the way are at most 1
const float kRestSpeed = 1e-3;  // m/s: slower impacts do not bounce
const float kMostDepth = 1e-3;  // m: where solids meet, one pushes particles so little into another; deeper was never outside

struct Impact {
  float time;    // share of the way
  vec3 normal;   // of the surface, world
  float depth;   // m below the surface: rounding may leave a particle a little inside
};

// How far from surfaces particles are kept: above the rounding of their coordinates.
float skin_at(vec3 position, float size) {
  precise float far = max(max(abs(position.x), abs(position.z)), max(abs(position.y), size));
  precise float skin = 1e-5 + 4e-7 * far;
  return skin;
}

// When a point at `o` that moves by `d` enters the ball of radius r around 0. As near to grazing as floats allow: the distance of
// the line comes from a difference of vectors, not of squares (Haines et al., "Precision Improvements for Ray/Sphere Intersection",
// Ray Tracing Gems, 2019).
float entry(vec3 o, vec3 d, float r, float skin) {
  precise float b = dot(o, d);
  precise float dd = max(dot(d, d), 1e-30);
  precise vec3 line = o - d * (b / dd);
  precise float h = r * r - dot(line, line);
  precise float c = dot(o, o) - r * r;
  if (b >= 0.0 || h < 0.0 || c < -2.0 * max(kMostDepth, 4.0 * skin) * r) return kNever;   // receding, past it, inside
  precise float t = max(c, 0.0) / (sqrt(h * dd) - b);
  return t;
}

vec3 to_box(BoxCollider c, vec3 v) {
  precise vec3 r = vec3(v.x * c.yaw_cos - v.z * c.yaw_sin, v.y, v.z * c.yaw_cos + v.x * c.yaw_sin);
  return r;
}
vec3 from_box(BoxCollider c, vec3 v) {
  precise vec3 r = vec3(v.x * c.yaw_cos + v.z * c.yaw_sin, v.y, v.z * c.yaw_cos - v.x * c.yaw_sin);
  return r;
}

// Times at which a point enters and leaves the slabs of a box: the earliest per axis.
void slabs(vec3 o, vec3 d, vec3 low, vec3 high, out vec3 enter, out vec3 leave) {
  const vec3 v = mix(d, vec3(1e-30), equal(d, vec3(0.0)));
  const bvec3 back = lessThan(v, vec3(0.0));
  precise vec3 to_enter = (mix(low, high, back) - o) / v;
  precise vec3 to_leave = (mix(high, low, back) - o) / v;
  enter = to_enter;
  leave = to_leave;
}

void meet_box(BoxCollider c, float body, vec3 p, vec3 way, inout Impact first) {
  precise vec3 o = to_box(c, p - c.position);
  precise vec3 d = to_box(c, way);
  precise vec3 high = c.half_size + body;
  precise vec3 low = -high - vec3(0.0, c.depth, 0.0);
  vec3 enter, leave;
  slabs(o, d, low, high, enter, leave);
  const float time = max(max(enter.x, enter.y), enter.z);
  const uint axis = time == enter.y ? 1u : time == enter.x ? 0u : 2u;
  precise float depth = max(-time, 0.0) * abs(d[axis]);
  if (time >= first.time || max(time, 0.0) > min(min(leave.x, leave.y), leave.z)) return;
  if (d[axis] == 0.0 || depth > max(kMostDepth, 4.0 * skin_at(p, 0.0))) return;   // inside
  vec3 normal = vec3(0.0);
  normal[axis] = d[axis] < 0.0 ? 1.0 : -1.0;
  first = Impact(max(time, 0.0), from_box(c, normal), depth);
}

vec3 from_axis(RoundCollider c, vec3 o) {
  precise vec3 r = o - c.axis * clamp(dot(o, c.axis), 0.0, c.length_m);
  return r;
}

void meet_round(RoundCollider c, float body, vec3 p, vec3 d, inout Impact first) {
  precise vec3 o = p - c.position;
  precise float r = c.radius + body;
  const float skin = skin_at(p, r);
  precise float along = dot(o, c.axis);
  precise float along_way = dot(d, c.axis);
  float time = min(entry(o, d, r, skin), entry(o - c.axis * c.length_m, d, r, skin));
  const float side = entry(o - c.axis * along, d - c.axis * along_way, r, skin);
  precise float at = along + along_way * side;
  if (at > 0.0 && at < c.length_m) time = min(time, side);
  precise vec3 out_of = from_axis(c, o + d * time);
  precise float distance = length(out_of);
  if (time >= first.time || distance < 1e-9) return;
  precise vec3 normal = out_of / distance;
  first = Impact(time, normal, max(r - distance, 0.0));
}

// The position itself, or the nearest one on the surface of the solid it is in; solid after solid.
vec3 pushed_out(EmitterData e, vec3 start, bool wanted) {
  precise vec3 p = start;
  for (uint i = 0u; i < (wanted ? e.box_count : 0u); ++i) {
    const BoxCollider c = box_colliders[e.box_first + i];
    precise vec3 o = to_box(c, p - c.position);
    precise vec3 high = c.half_size + e.body_radius;
    precise vec3 low = -high - vec3(0.0, c.depth, 0.0);
    precise vec3 below = high - o;
    precise vec3 above = o - low;
    precise vec3 depth = min(below, above);
    const float least = min(min(depth.x, depth.y), depth.z);
    if (least <= 0.0) continue;
    const uint axis = least == depth.y ? 1u : least == depth.x ? 0u : 2u;
    vec3 normal = vec3(0.0);
    normal[axis] = below[axis] <= above[axis] ? 1.0 : -1.0;
    p += from_box(c, normal) * (least + skin_at(p, 0.0));
  }
  for (uint i = 0u; i < (wanted ? e.round_count : 0u); ++i) {
    const RoundCollider c = round_colliders[e.round_first + i];
    precise vec3 out_of = from_axis(c, p - c.position);
    precise float distance = length(out_of);
    precise float r = c.radius + e.body_radius;
    if (distance >= r) continue;
    // From the very axis any way out is the nearest: across it, and up from a ball's centre.
    const vec3 across = cross(c.axis, abs(c.axis.y) < 0.9 ? vec3(0.0, 1.0, 0.0) : vec3(1.0, 0.0, 0.0));
    precise vec3 any = dot(across, across) > 0.0 ? across / length(across) : vec3(0.0, 1.0, 0.0);
    precise vec3 normal = distance > 1e-6 ? out_of / max(distance, 1e-9) : any;
    p += normal * (r - distance + skin_at(p, r));
  }
  return p;
}

// `before` is the motion at the start of the tick and `m` at its end as if nothing stood in between.
//
// Bounce: u = restitution * impact along the normal, friction takes mu (u + v) from the tangential speed v_t (Coulomb), and what is
// left of the way turns and shrinks as the velocity does. The scheme's velocity at the end of a tick is half a tick ahead of the
// parabola through its positions; impact and rebound are corrected for it by where in the tick they happen, which conserves the
// energy of a ball that bounces without loss. What presses against a surface (`push`, gained this tick) and hardly moves
// rests.
Motion collide(EmitterData e, Motion before, Motion m, uint age) {
  precise vec3 p = pushed_out(e, before.position, age == 0u);
  precise vec3 way = m.position - before.position;
  precise vec3 velocity = m.velocity;
  precise vec3 gained = m.velocity - before.velocity;
  precise float left = 1.0;   // of the tick
  uint contact = m.contact;
  for (uint impacts = 0u; impacts < kMostImpacts; ++impacts) {
    Impact first = Impact(1.0, vec3(0.0), 0.0);
    for (uint i = 0u; i < e.box_count; ++i) meet_box(box_colliders[e.box_first + i], e.body_radius, p, way, first);
    for (uint i = 0u; i < e.round_count; ++i) meet_round(round_colliders[e.round_first + i], e.body_radius, p, way, first);
    p += way * first.time;
    if (first.time >= 1.0) break;
    const vec3 n = first.normal;
    p += n * (first.depth + skin_at(p, 0.0));
    left *= 1.0 - first.time;

    precise float speed = max(-dot(velocity, n), 0.0);   // into the surface
    precise float push = min(max(-dot(gained, n), 0.0), speed);
    precise float half_tick = push * (0.5 - left);
    precise float impact = speed + half_tick;
    if (impact > e.event_speed) contact = min(contact + kOneCollision, contact % kOneCollision + kMostCollisions);
    if (e.response == kResponseDie || e.response == kResponseStick) {
      contact |= e.response == kResponseDie ? kKilled : kStuck;
      velocity = vec3(0.0);
      break;
    }
    const bool bounces = e.response == kResponseBounce && impact > 2.0 * push + kRestSpeed;
    precise float rebound = bounces ? max(e.restitution * impact + half_tick, 0.0) : 0.0;
    precise vec3 along = velocity + n * speed;
    precise float tangential = length(along);
    precise float loss = e.friction * (speed + rebound);
    precise float kept = tangential > loss ? 1.0 - loss / tangential : 0.0;
    velocity = along * kept + n * rebound;
    precise float into = -dot(way, n);
    precise float turned = bounces ? into * rebound / speed : 0.0;
    way = ((way + n * into) * kept + n * turned) * (1.0 - first.time);
  }
  return Motion(p, velocity, contact);
}

// Whether the way of a tick leads into a volume that kills inside, or out of one that kills outside.
bool is_killed(EmitterData e, vec3 origin, vec3 from, vec3 to) {
  precise vec3 start = unrotate_yaw(e, from - origin);
  precise vec3 end = unrotate_yaw(e, to - origin);
  bool killed = false;
  for (uint i = 0u; i < e.kill_count; ++i) {
    const KillVolumeData volume = kill_volumes[e.kill_first + i];
    precise vec3 o = start - volume.position;
    precise vec3 d = end - start;
    if (volume.kind == kKillPlane) {
      killed = killed || dot(o + d, volume.extent) < 0.0;
    } else if (volume.kind == kKillBox) {
      vec3 enter, leave;
      slabs(o, d, -volume.extent, volume.extent, enter, leave);
      const bool touched = max(max(enter.x, enter.y), max(enter.z, 0.0)) <= min(min(leave.x, leave.y), min(leave.z, 1.0));
      killed = killed || (volume.outside == 0u ? touched : any(greaterThan(abs(o + d), volume.extent)));
    } else {
      precise float nearest = clamp(-dot(o, d) / max(dot(d, d), 1e-30), 0.0, 1.0);
      precise vec3 closest = volume.outside == 0u ? o + d * nearest : o + d;
      const bool inside = dot(closest, closest) <= volume.extent.x * volume.extent.x;
      killed = killed || inside == (volume.outside == 0u);
    }
  }
  return killed;
}

#endif
