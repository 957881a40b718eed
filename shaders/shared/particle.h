// Particle state and what its emitter says of it. A particle is a function of (seed, birth index, tick).
#ifndef PLUME_SHARED_PARTICLE_H
#define PLUME_SHARED_PARTICLE_H

#include "shared/types.h"

PLUME_SHARED_BEGIN

const uint kAgeBits = 20u;       // of Particle::state
const uint kContactShift = 20u;  // what its motion has met: see kStuck and below
const uint kContactBits = 6u;
const uint kGenerationShift = 26u;  // ancestors still to come
const uint kDeadAge = (1u << kAgeBits) - 1u;
const uint kCurveSamples = 64u;     // per curve, over normalised life
const uint kCurvesPerEmitter = 3u;  // (radius, fade, alpha, -), (color, -), (emission, -)

// Contact: what a particle has met.
const uint kStuck = 1u;                 // to a collider: it stays where it is
const uint kKilled = 2u;                // by a kill volume or a collider
const uint kOneCollision = 4u;          // collision events, counted up to
const uint kMostCollisions = 15u * 4u;  // so many

// What an emitter's motion is made of. Kernels leave out what none of their emitters uses: constant 0,
// kFeatures, is the union.
const uint kUsesCurl = 1u;
const uint kUsesVortex = 2u;
const uint kUsesAttractors = 4u;
const uint kUsesField = 8u;
const uint kUsesOrbit = 16u;
const uint kUsesCollision = 32u;
const uint kUsesKill = 64u;
const uint kUsesPath = 128u;
const uint kUsesLineage = 256u;
const uint kUsesDisplacement = 512u;  // of cards only
const uint kUsesMeshShape = 1024u;
const uint kIsAnalytic = 2048u;  // no state is kept: see shaders/effects/ballistic.glsl

struct Particle {
  vec3 position;  // world, m
  uint birth;     // index among the births of its emitter
  vec3 velocity;  // m/s
  uint state;     // age in ticks | contact << kContactShift | generation << kGenerationShift
};

// BirthEvent
const uint kBornOfBirth = 0u;
const uint kBornOfLife = 1u;
const uint kBornOfDeath = 2u;
const uint kBornOfCollision = 3u;
const uint kMostGenerations = 2u;  // below an emitter with a rate

// One emitter of one called instance.
struct EmitterData {
  uint seed;      // mixes effect seed, instance and emitter
  uint shape;     // ShapeKind
  uint life_min;  // ticks
  uint life_max;
  uint curl_octaves;
  uint texture_kind;  // TextureKind
  uint flags;         // kEmitter...
  vec3 origin;        // world, m
  float yaw_sin;
  vec3 size;  // box: full extents; line: from end to end
  float yaw_cos;
  float radius;  // shape; mesh: its scale
  float thickness;
  float cone_angle;  // radians
  float speed_min;
  float speed_max;
  vec3 velocity;      // added at birth, world after yaw
  vec3 gravity;       // m/s^2
  float drag;         // 1/s
  float decay;        // the same as analytic kernels need it: ln(1 + drag dt), per tick,
  float decay_share;  // that over drag dt,
  float decay_lag;    // and (1 - decay_share) / (drag dt)
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
  float orbit_sin;       // of the angle a tick
  float orbit_cos_less;  // its cosine, less 1
  // Ranges of the tables in shared/motion_tables.h: index of the first, and how many.
  uint attractor_first;
  uint attractor_count;
  uint kill_first;
  uint kill_count;
  uint box_first;  // colliders
  uint box_count;
  uint round_first;
  uint round_count;
  uint field_first;  // cells, x fastest
  uvec3 field_size;
  vec3 field_low;       // corner, in the emitter's frame
  vec3 field_inv_cell;  // 1/m
  float field_strength;
  uint response;      // CollisionResponse
  float restitution;  // share of the normal speed
  float friction;     // Coulomb's coefficient
  float body_radius;
  float event_speed;            // m/s: slower impacts are no events
  float displacement_m;         // amplitude: of the drawn position only
  float displacement_inv_m;     // 1/wavelength
  float displacement_speed;     // wavelengths/s
  float displacement_per_tick;  // growth: share of the amplitude
  uint displacement_octaves;
  float radius_scale_min;  // of the card
  float radius_scale_max;
  float cross_section;  // m^2; 0 = the alpha curve holds
  float inv_feather;
  float inv_near_fade;  // 1/m; 0: none
  float camera_offset;
  float frames_per_tick;  // flipbook
  float spin_min;         // rad/s
  float spin_max;
  float stretch;  // s
  vec3 transmission;
  float distortion;  // radians
  float diffusion;   // radians
  // Children: who bears them, and when.
  uint generation;   // ancestors above
  uint parent;       // emitter
  uint per_parent;   // children of one parent
  uint birth_event;  // kBorn...
  uint birth_count;  // of one collision
  uint birth_first;  // ticks: age of the parent at the first child of its life
  uint birth_every;  // ticks between them
  float inherit_velocity;
  uint path_first;  // keys of the path that the emitter moves on
  uint path_count;
  uint shape_mesh;   // of the mesh ranges
  uint look_mesh;    // the first of them
  uint look_meshes;  // to choose from; 0: particles are no meshes
  uint cards_each;   // cards a particle
  float tumble_min;  // rad/s
  float tumble_max;
  float gloss;
  uint strand_births;   // that one ribbon joins; 0: all
  float frames_a_life;  // flipbook
};

// Where an emitter is at a tick since its call, from where it was called.
struct PathKey {
  float tick;
  vec3 offset;  // m, world
};

const uint kEmitterLit = 1u;
const uint kEmitterSetApart = 2u;         // of a named layer
const uint kEmitterFieldIsVelocity = 4u;  // the vector field adds to the wind; otherwise it is a force
const uint kEmitterCasts = 8u;            // shadows on others and on what stands around

const uint kResponseBounce = 0u;
const uint kResponseSlide = 1u;
const uint kResponseDie = 2u;
const uint kResponseStick = 3u;

const uint kSpanGroup = 64u;  // threads of a work group of the kernels that spans are for

// Births first .. first + count - 1 of one emitter. Birth k lives in slot base + k mod capacity.
struct Span {
  uint emitter;
  uint first;  // birth index
  uint count;
  uint base;        // slot
  uint capacity;    // slots
  uint first_slot;  // first mod capacity: a division a thread saved
  uint offset;      // first thread
  uint tick;        // of the emitter, since its call
  uint per_root;    // births of one ancestor that has a rate
  uint resume;  // catch-up: particles born before this tick have been brought to the one before it; 0: none
  // Catch-up and analytic kernels, of roots:
  uint births_base;   // first entry of the table of how many of those were born before each tick
  uint births_tick;   // the tick of that entry
  uint births_count;  // ticks; the table has one entry more
};

PLUME_SHARED_END
#endif
