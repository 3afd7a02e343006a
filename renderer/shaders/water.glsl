#include "shared/bindings.h"
#include "shared/water.h"

layout(std140, binding = WATER_BINDING) uniform WaterBlock { Water water; };
