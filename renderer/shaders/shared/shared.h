// What lets one header serve both compilers. GLSL reads nothing here but the macros; C++ gets GLSL's names from GLM.
// Rows are 16 bytes (a vec3 is followed by a scalar), so std140 and std430 lay a struct out as C++ does.
#ifndef SHARED_SHARED_H
#define SHARED_SHARED_H

#ifdef __cplusplus
#include <glm/glm.hpp>
namespace glsl {
using namespace glm;
using uint = glm::uint;
} // namespace glsl
#define SHARED_BEGIN namespace glsl {
#define SHARED_END }
#define SHARED_STRUCT_END(type, bytes) static_assert(sizeof(type) == (bytes));
#define SHARED_FUNCTION inline
#else
#define SHARED_BEGIN
#define SHARED_END
#define SHARED_STRUCT_END(type, bytes)
#define SHARED_FUNCTION
#endif

#endif
