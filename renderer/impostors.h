// Pictures that stand for models where they are small: taken from all around, lit anew where they are drawn.
#pragma once

#include "io/scene/model.h"
#include "renderer/gl/texture.h"
#include "renderer/vertex_format.h"

#include <array>
#include <span>
#include <vector>

namespace renderer {

// Of the radius: with one pixel allowed, an impostor comes when a texel of its frames is as large as a pixel.
constexpr float kImpostorError = 1.0f / 32;

// The pictures of all models that have them: layers of two texture arrays, so that one draw serves all.
class ImpostorAtlas {
public:
    static constexpr int kMost = 256; // layers; whoever comes later is drawn as a mesh

    bool full() const { return int(m_models.size()) == kMost; }
    int add(int model);                                     // to a layer, still to be filled
    std::span<const int> models() const { return m_models; } // by layer
    int filled() const { return m_filled; }
    void clear() { *this = {}; }

    void reserve();                                         // layers for all that was added
    void filledOne() { ++m_filled; }
    const gl::Texture& colours() const { return m_colours; }
    const gl::Texture& surfaces() const { return m_surfaces; }

private:
    std::vector<int> m_models;
    int m_filled = 0;
    gl::Texture m_colours, m_surfaces; // as shaders/impostor.glsl says
};

// The quad as impostors.vert.glsl reads it.
struct ImpostorShape {
    glm::vec3 centre{0}; // of the model's sphere, m
    float radius = 0;
    glm::vec3 extent{0}; // half the bounds, m
    float leafRoughness = 1, roughness = 1;
    float leaves = 0;    // share of the surface
    int layer = 0;
};
std::array<PackedVertex, 4> impostorQuad(const ImpostorShape& shape);

// Roughness and leaves, of all parts.
void measureSurface(const io::Model& model, ImpostorShape& shape);

} // namespace renderer
