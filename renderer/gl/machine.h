// What the current context draws with.
#pragma once

namespace renderer::gl {

bool drawsInSoftware(); // llvmpipe and its like: triangles and samples are dear, calls and waiting are not

} // namespace renderer::gl
