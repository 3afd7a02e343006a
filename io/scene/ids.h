// Names of things inside a scene. Ids are stable for the life of a world and never used again; 0 is none.
#pragma once

#include <cstdint>
#include <functional>

namespace io {

enum class ObjectId : std::uint32_t { None = 0 };

// A scatter layer of a scene.
enum class ScatterId : std::uint32_t { None = 0 };

// A slot in the scene's table of templates. Slots are not reused while the scene is loaded.
enum class TemplateId : std::uint32_t { None = 0 };

// The highest that a file may name, far enough from the end of 32 bits that fresh ones do not run out.
constexpr std::uint32_t kHighestId = 4'000'000'000;

constexpr std::uint32_t kHighestScatterId = 1'000'000; // likewise

// Instances have numbers beyond those of objects, for as long as a scene is loaded (io/scene/instance_ids.h). What is left above
// them stands for the ground in pictures of ids.
constexpr std::uint32_t kFirstInstanceId = 4'100'000'000, kLastInstanceId = 0xfffffffe;

constexpr std::uint32_t number(ObjectId id)
{
    return static_cast<std::uint32_t>(id);
}
constexpr bool isInstance(ObjectId id)
{
    return number(id) >= kFirstInstanceId && number(id) <= kLastInstanceId;
}
constexpr std::uint32_t number(ScatterId id)
{
    return static_cast<std::uint32_t>(id);
}
constexpr std::uint32_t number(TemplateId id)
{
    return static_cast<std::uint32_t>(id);
}

} // namespace io
