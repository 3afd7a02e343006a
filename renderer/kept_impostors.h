// The pictures of impostors from one run to the next: kept by all that they were made of, so that a world's first frame
// need not make them again.
#pragma once

#include "io/base/kept_bytes.h"
#include "renderer/model_library.h"

#include <memory>

namespace renderer {

class ShaderLibrary;

class KeptImpostors {
public:
    // Null: nothing is kept. `shaders` is what the pictures are made with.
    KeptImpostors(std::shared_ptr<io::KeptBytes> kept, const ShaderLibrary& shaders);

    // Fills a layer of the atlas with the model's pictures; false when they are not known.
    bool fill(const ModelLibrary& models, int model, const ImpostorAtlas& atlas, int layer);
    // Remembers what the layer holds.
    void keep(const ModelLibrary& models, int model, const ImpostorAtlas& atlas, int layer);

private:
    io::ContentKey keyOf(const ModelLibrary& models, int model) const;

    std::shared_ptr<io::KeptBytes> m_kept;
    const ShaderLibrary& m_shaders;
};

} // namespace renderer
