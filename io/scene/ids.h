// Names of things inside a scene. Ids are stable for the life of a world and never used again; 0 is none.
#pragma once

#include <cstdint>
#include <functional>

namespace io {

enum class ObjectId : std::uint32_t { None = 0 };

// A slot in the scene's table of templates. Slots are not reused while the scene is loaded.
enum class TemplateId : std::uint32_t { None = 0 };

// The highest that a file may name, far enough from the end of 32 bits that fresh ones do not run out.
constexpr std::uint32_t kHighestId = 4'000'000'000;

constexpr std::uint32_t number(ObjectId id)
{
    return static_cast<std::uint32_t>(id);
}
constexpr std::uint32_t number(TemplateId id)
{
    return static_cast<std::uint32_t>(id);
}

} // namespace io
