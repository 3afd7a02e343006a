#include "shared/bindings.h"
#include "shared/light.h"

layout(std140, binding = LIGHT_BINDING) uniform LightBlock { Light light; };
