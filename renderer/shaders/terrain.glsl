#include "shared/bindings.h"
#include "shared/terrain.h"

layout(std140, binding = TERRAIN_BINDING) uniform TerrainBlock { Terrain terrain; };
