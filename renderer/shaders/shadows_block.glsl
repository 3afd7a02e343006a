#include "shared/bindings.h"
#include "shared/shadows.h"

layout(std140, binding = SHADOWS_BINDING) uniform ShadowsBlock { Shadows shadows; };
