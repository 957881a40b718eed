// Light that reaches effects and what stands around them: see shaders/effects/light_volume.glsl.
#ifndef PLUME_SHARED_LIGHT_H
#define PLUME_SHARED_LIGHT_H

#include "shared/types.h"

PLUME_SHARED_BEGIN

// A particle as light sees it: the same from every camera.
struct LitBody {
  vec3 position;  // world, m
  float radius;   // m
  vec3 power;     // emission * projected area / pi, W/sr over pi: irradiance / pi at one metre, rgb
  float depth;    // optical, mean over its disc, gray; 0: casts no shadow
  uvec2 albedo;   // rgb; a: 1 where light falls on it, 0: it is radiance itself
};

// A lattice of cells in a frame whose third axis runs with the light: one for the sun, one for the zenith.
struct LightGrid {
  vec3 axis_s;  // unit vectors, world
  vec3 axis_t;
  vec3 axis_l;  // away from the light
  vec3 origin;  // corner of the first cell in that frame, m
  vec3 cell;    // m
  uint cells;   // each way
};

// The glowing particles of one fire as a ball of light.
struct FireLight {
  vec3 position;  // world, m
  float radius_squared;
  vec3 power;  // irradiance / pi at one metre, rgb, times m^2
  float radius;
};

// Where the glowing particles of a fire are: `count` ranges from `first` on.
struct FireSource {
  vec3 origin;  // near it: sums are taken from here
  uint first;
  uint count;
};

// Of bodies.
struct FireRange {
  uint first;
  uint count;
};

const uint kLightGrids = 2u;  // sun, sky
const uint kLightBounds =
    7u;  // words a grid: least s, t, l, then complements of the greatest and of the radius
const uint kMostFires = 8u;         // of a scene: more are joined to their neighbours
const uint kLeastLightCells = 16u;  // a grid, each way
const uint kMostLightCells = 128u;

PLUME_SHARED_END
#endif
