#include "shared/bindings.h"
#include "shared/terrain.h"

layout(std140, binding = TERRAIN_BINDING) uniform TerrainBlock { Terrain terrain; };

#ifdef WINDOWS
#define MAP_TEXTURE sampler2DArray // terrain_windows.cpp

// Where a level holds one of its samples.
ivec3 windowTexel(ivec2 sample_, int level)
{
    return ivec3(sample_ % terrain.windowSide, level);
}

#ifdef FROM_ABOVE
layout(location = 1) uniform int pixelLevel; // whose samples lie as far apart as pixels
#endif

// A level that holds a place of the map for sure, as does the next finer whole number.
float windowLevel(vec2 texel)
{
#ifdef FROM_ABOVE
    return float(min(pixelLevel, terrain.windows - 1));
#else
    vec2 away = abs(texel - terrain.windowsFrom);
    return clamp(log2(max(max(away.x, away.y), 1.0) / terrain.windowReach) + 1.0, 0.0, float(terrain.windows - 1));
#endif
}
#else
#define MAP_TEXTURE sampler2D
#endif
