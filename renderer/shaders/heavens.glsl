#include "shared/bindings.h"
#include "shared/heavens.h"

layout(std140, binding = HEAVENS_BINDING) uniform HeavensBlock { Heavens heavens; };
