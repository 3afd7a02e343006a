// A world as hand-written OpenGL would draw it: one instanced draw for each part of a model and 128 m cell, culled by
// cell, full models at any distance, Lambert light, one shadow map over everything, the ground as one plain grid.
#pragma once

#include "io/scene/assets.h"
#include "io/scene/camera.h"
#include "io/scene/image.h"
#include "renderer/gl/buffer.h"
#include "renderer/gl/framebuffer.h"
#include "renderer/gl/program.h"

#include <glm/glm.hpp>
#include <map>
#include <vector>

namespace bench {

struct BareCounts {
    std::size_t drawCalls = 0;
    std::size_t triangles = 0; // of the picture; the shadow map has all there are
};

class BareForest {
public:
    BareForest(const io::Scene& scene, const io::Assets& assets, glm::ivec2 size);

    BareCounts draw(const io::Camera& camera); // does not wait for the device
    io::Image readPicture() const;             // RGB8, top row first

private:
    struct Vertex {
        glm::vec3 position, normal;
        glm::vec2 uv;
        glm::u8vec4 colour;
    };
    using Instance = glm::mat3x4; // the rows of world from model
    struct Copies {               // those of one model in one cell
        std::uint32_t first = 0, count = 0;
        io::WorldBox bounds;
    };
    struct Part {
        std::uint32_t firstIndex = 0, indexCount = 0;
        std::int32_t baseVertex = 0;
        std::size_t model = 0;
        std::size_t texture = 0;
        glm::vec4 factor{1}, uvScaleOffset{1, 1, 0, 0};
        bool masked = false, twoSided = false;
        float cutoff = 0.5f;
    };
    struct Programs {
        renderer::gl::Program opaque, masked;
    };

    void addGround(const io::HeightMap& heights, const io::Assets& assets);
    void addModel(const io::Model& model, std::size_t slot);
    void placeCopies(const io::Scene& scene, const io::Assets& assets);
    std::size_t addTexture(const io::Image* image);
    void makeTargets();
    void drawShadows();
    BareCounts drawPicture(const io::Camera& camera);
    void prepare(const Programs& programs, const Part& part) const;
    void drawCopies(const Part& part, const Copies& copies) const;

    glm::ivec2 m_size;
    glm::vec3 m_towardSun{0, 1, 0};
    glm::mat4 m_shadowFromWorld{1};
    std::vector<Vertex> m_vertices; // until they are on the device
    std::vector<std::uint32_t> m_indices;
    std::vector<Instance> m_instances;
    std::vector<Part> m_parts;
    std::vector<std::vector<Copies>> m_copies; // by model, then cell
    std::vector<renderer::gl::Texture> m_textures;
    std::map<const io::Image*, std::size_t> m_textureOf;
    io::WorldBox m_bounds;

    Programs m_objectPrograms, m_casterPrograms;
    renderer::gl::Buffer m_vertexBuffer, m_indexBuffer, m_instanceBuffer;
    renderer::gl::VertexArray m_array;
    renderer::gl::Texture m_colour, m_depth, m_shadowMap;
    renderer::gl::Framebuffer m_picture, m_shadow;
};

} // namespace bench
