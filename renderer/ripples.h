// The pattern of small waves and of foam that tiles over water.
#pragma once

#include "renderer/gl/texture.h"

namespace renderer {

// R, G: slope along and across the wind, whose mean square is 1; B: that square, so that mips tell how much of it they lost
// (Olano and Baker, "LEAN Mapping", 2010); A: foam, 0 where bubbles go last. Made by arithmetic, always alike.
gl::Texture makeRipples();

} // namespace renderer
