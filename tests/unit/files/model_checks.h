// What every model that is handed on promises to the renderer and to Embree.
#pragma once

#include "io/scene/model.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace io {

inline void expectSound(const Model& model, const std::string& name)
{
    ASSERT_FALSE(model.parts.empty()) << name;
    ASSERT_FALSE(model.materials.empty()) << name;
    ASSERT_FALSE(model.bounds.empty()) << name;
    for (const Part& part : model.parts) {
        ASSERT_TRUE(part.indexCount > 0 && part.indexCount % 3 == 0) << name;
        ASSERT_LE(std::size_t(part.firstIndex) + part.indexCount, model.indices.size()) << name;
        ASSERT_LT(std::size_t(part.material), model.materials.size()) << name;
    }
    for (const std::uint32_t index : model.indices) {
        ASSERT_LT(index, model.vertices.size()) << name;
        const Vertex& vertex = model.vertices[index];
        ASSERT_NEAR(glm::length(vertex.normal), 1, 1e-3) << name;
        ASSERT_NEAR(glm::length(glm::vec3{vertex.tangent}), 1, 1e-3) << name;
        ASSERT_TRUE(std::isfinite(vertex.position.x + vertex.position.y + vertex.position.z)) << name;
        ASSERT_EQ(std::abs(vertex.tangent.w), 1) << name;
    }
    for (const Material& material : model.materials)
        for (const TextureUse* use : {&material.baseColourTexture, &material.normalTexture, &material.emissiveTexture})
            ASSERT_TRUE(use->image >= -1 && use->image < int(model.images.size()) && use->uvSet >= 0 && use->uvSet <= 1)
                << name;
}

} // namespace io
