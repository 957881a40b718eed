// Where a particle is born and which way is outwards, by the shape of its emitter. Every shape is filled evenly: by volume, by area or
// by length.
#ifndef PLUME_EFFECTS_SHAPES_GLSL
#define PLUME_EFFECTS_SHAPES_GLSL
#include "effects/particle.glsl"
#include "shared/mesh.h"

layout(scalar, binding = 7) readonly buffer MeshRanges { MeshRange mesh_ranges[]; };
layout(scalar, binding = 8) readonly buffer MeshTriangles { MeshTriangle mesh_triangles[]; };

struct Birth {
  vec3 place;     // from the emitter's origin, in the instance's frame, m
  vec3 outward;   // unit
};

// A unit vector across an axis.
vec3 around_axis(vec3 axis, float angle) {
  const vec3 other = abs(axis.y) < 0.9 ? vec3(0.0, 1.0, 0.0) : vec3(1.0, 0.0, 0.0);
  precise vec3 side = normalize(cross(other, axis));
  precise vec3 outward = side * cos(angle) + cross(axis, side) * sin(angle);
  return outward;
}

// A triangle with the probability of its area, by the table of sums; then evenly on it (Turk, "Generating random points in triangles",
// Graphics Gems, 1990).
Birth birth_on_mesh(MeshRange mesh, float scale, float a, float b, float c) {
  uint low = mesh.first, high = mesh.first + mesh.count - 1u;   // the first whose sum is above a; the last one's is 1
  while (low < high) {
    const uint middle = (low + high) / 2u;
    if (mesh_triangles[middle].area_until > a) high = middle;
    else low = middle + 1u;
  }
  const MeshTriangle t = mesh_triangles[low];
  precise float away = sqrt(b);
  precise vec3 place = (t.corner + (t.edge_u * (1.0 - c) + t.edge_v * c) * away) * scale;
  precise vec3 outward = normalize(cross(t.edge_u, t.edge_v));
  return Birth(place, outward);
}

Birth birth_of(EmitterData e, uint key) {
  const float a = random(key, 1u), b = random(key, 2u), c = random(key, 3u), d = random(key, 4u);
  precise float angle = kTwoPi * a;
  precise vec3 outward = vec3(0.0, 1.0, 0.0);
  precise vec3 place = vec3(0.0);
  precise float depth = 1.0 - e.thickness * (1.0 - pow(c, 1.0 / 3.0));   // 1 on the surface
  switch (e.shape) {
    case 1u:      // sphere
    case 2u: {    // hemisphere
      precise float y = e.shape == 1u ? 1.0 - 2.0 * b : b;
      precise float ring = sqrt(max(1.0 - y * y, 0.0));
      outward = vec3(ring * cos(angle), y, ring * sin(angle));
      place = outward * (e.radius * depth);
      break;
    }
    case 3u:      // box
      place = (vec3(a, b, c) - 0.5) * e.size;
      break;
    case 4u: {    // cone: a disc of births, directions within the half angle
      precise float disc = e.radius * (1.0 - e.thickness * (1.0 - sqrt(c)));
      precise float tilt = e.cone_angle * sqrt(b);
      place = vec3(cos(angle), 0.0, sin(angle)) * disc;
      precise float around = kTwoPi * d;
      outward = vec3(sin(tilt) * cos(around), cos(tilt), sin(tilt) * sin(around));
      break;
    }
    case 5u: {    // ring
      outward = vec3(cos(angle), 0.0, sin(angle));
      place = outward * (e.radius * (1.0 - e.thickness * b));
      break;
    }
    case 6u: {    // line
      place = e.size * c;
      outward = around_axis(normalize(e.size), angle);
      break;
    }
    case 7u:      // mesh
      if ((kFeatures & kUsesMeshShape) != 0u) return birth_on_mesh(mesh_ranges[e.shape_mesh], e.radius, a, b, c);
      break;
    default: {    // point: any direction
      precise float y = 1.0 - 2.0 * b;
      precise float ring = sqrt(max(1.0 - y * y, 0.0));
      outward = vec3(ring * cos(angle), y, ring * sin(angle));
    }
  }
  return Birth(place, outward);
}

// Around `origin`, world; `inherited` is the share of a parent's velocity, m/s.
Motion birth_motion(EmitterData e, uint key, vec3 origin, vec3 inherited) {
  const Birth birth = birth_of(e, key);
  Motion m;
  precise vec3 position = origin + rotate_yaw(e, birth.place);
  precise float speed = e.speed_min + (e.speed_max - e.speed_min) * random(key, 5u);
  precise vec3 velocity = rotate_yaw(e, birth.outward * speed) + e.velocity + inherited;
  m.position = position;
  m.velocity = velocity;
  m.contact = 0u;
  return m;
}

#endif
