// What the open world holds in memory, by kind; what the renderer made of it on the GPU is in its FrameStats.
#pragma once

#include <cstdint>

namespace editor {

class Document;

struct WorldMemory { // bytes
    std::uint64_t objects = 0, geometry = 0, pictures = 0, heights = 0;
};
WorldMemory memoryOf(const Document& document);

} // namespace editor
