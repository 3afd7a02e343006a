// The heavy data that a scene names, read from its files and shared by all that draw it or shoot rays at it.
#pragma once

#include "io/scene/model.h"
#include "io/scene/scene.h"

#include <memory>
#include <vector>

namespace io {

struct LayerImages {
    std::shared_ptr<const Image> colour; // null: the layer's colour alone
    std::shared_ptr<const Image> normal; // null: flat
    std::shared_ptr<const Image> roughness, height; // of which the first channel counts; null: as TerrainLayer says
};

struct Assets {
    // By template slot (TemplateId - 1), never null once read: a marker or a missing model is a box.
    std::vector<std::shared_ptr<const Model>> models;
    std::vector<LayerImages> layers;           // as Terrain::layers

    const Model* model(TemplateId id) const
    {
        const std::uint32_t n = number(id);
        return n == 0 || n > models.size() ? nullptr : models[n - 1].get();
    }
};

// Bounds of one object in the world; a group has none (empty box).
WorldBox worldBounds(const Assets& assets, const Object& object);

} // namespace io
