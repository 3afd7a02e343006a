#include "shared/bindings.h"
#include "shared/clouds.h"

layout(std140, binding = CLOUDS_BINDING) uniform CloudsBlock { Clouds clouds; };
