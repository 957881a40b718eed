// Particle state and what its emitter says of it. A particle is a function of (seed, birth index, tick).
#ifndef PLUME_SHARED_PARTICLE_H
#define PLUME_SHARED_PARTICLE_H

#include "shared/types.h"

PLUME_SHARED_BEGIN

const uint kAgeBits = 20u;          // of age_and_emitter; the emitter has the upper 12
const uint kCurveSamples = 32u;     // per curve, over normalised life
const uint kCurvesPerEmitter = 3u;  // (radius, fade, alpha, -), (color, -), (emission, -)

struct Particle {
  vec3 position;         // world, m
  uint birth;            // index among the births of its emitter
  vec3 velocity;         // m/s
  uint age_and_emitter;  // age in ticks | emitter << kAgeBits
};

// One emitter of one called instance.
struct EmitterData {
  uint seed;       // mixes effect seed, instance and emitter
  uint shape;      // ShapeKind
  uint call_tick;  // scene tick at which the instance was called
  uint life_min;   // ticks
  uint life_max;
  uint curl_octaves;
  uint texture_kind;  // TextureKind
  uint flags;         // kEmitter...
  vec3 origin;        // world, m
  float yaw_sin;
  vec3 size;  // box
  float yaw_cos;
  float radius;  // shape
  float thickness;
  float cone_angle;  // radians
  float speed_min;
  float speed_max;
  vec3 velocity;      // added at birth, world after yaw
  vec3 gravity;       // m/s^2
  float drag;         // 1/s
  vec3 wind;          // m/s, share applied
  float buoyancy;     // m/s^2
  float inv_cooling;  // 1/s
  float floor_y;
  float curl_strength;
  float curl_inv_scale;  // 1/m
  float curl_speed;      // wavelengths/s
  float vortex_strength;
  float vortex_inv_radius;
  float vortex_pull;
  float radius_scale_min;  // of the card
  float radius_scale_max;
  float cross_section;  // m^2; 0 = the alpha curve holds
  float inv_feather;
  float camera_offset;
  float frames_per_tick;  // flipbook
  float spin_min;         // rad/s
  float spin_max;
  float stretch;  // s
  vec3 core;      // world: what counts as the middle of the cloud for its shading
  vec3 transmission;
  float distortion;  // radians
  float diffusion;   // radians
};

const uint kEmitterLit = 1u;
const uint kEmitterSetApart = 2u;  // of a named layer

// Births first .. first + count - 1 of one emitter. Birth k lives in slot base + k mod capacity.
struct Span {
  uint emitter;
  uint first;  // birth index
  uint count;
  uint base;         // slot
  uint capacity;     // slots
  uint first_slot;   // first mod capacity: a division a thread saved
  uint offset;       // sum of counts before: first thread, first card
  uint births_base;  // catch-up: first entry of this emitter's births-by-tick table
  uint births_tick;  // catch-up: the tick (since the call) of that entry
  uint births_count;
};

PLUME_SHARED_END
#endif
