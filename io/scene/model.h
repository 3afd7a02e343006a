// A model as plain data: what glTF describes, flattened into model space. io/files makes it, renderer/ draws it.
#pragma once

#include "io/scene/bounds.h"
#include "io/scene/image.h"

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <memory>
#include <string>
#include <vector>

namespace io {

struct Vertex {
    glm::vec3 position{0};       // m
    glm::vec3 normal{0, 1, 0};   // unit
    glm::vec4 tangent{1, 0, 0, 1}; // unit, w is the sign of the bitangent
    glm::vec2 uv0{0};
    glm::vec2 uv1{0};
    glm::u8vec4 colour{255};     // linear, multiplies the base colour
};

enum class Wrap : std::uint8_t { Repeat, Clamp, Mirror };
enum class AlphaMode : std::uint8_t { Opaque, Mask, Blend };

struct TextureUse {
    int image = -1;               // into Model::images; -1: none
    int uvSet = 0;                // 0 or 1
    glm::vec2 offset{0};          // KHR_texture_transform: uv' = offset + R(rotation) * (scale * uv)
    glm::vec2 scale{1};
    float rotation = 0;           // radians, counter-clockwise
    Wrap wrapU = Wrap::Repeat;
    Wrap wrapV = Wrap::Repeat;
};

// glTF 2.0 metallic-roughness.
struct Material {
    std::string name;
    glm::vec4 baseColour{1};      // linear, multiplies the texture
    float metallic = 1;
    float roughness = 1;
    glm::vec3 emissive{0};
    float normalScale = 1;
    float occlusionStrength = 1;
    AlphaMode alphaMode = AlphaMode::Opaque;
    float alphaCutoff = 0.5f;
    bool doubleSided = false;
    bool unlit = false;           // KHR_materials_unlit
    TextureUse baseColourTexture; // sRGB
    TextureUse metallicRoughnessTexture; // roughness in G, metallic in B
    TextureUse normalTexture;
    TextureUse occlusionTexture;  // R
    TextureUse emissiveTexture;   // sRGB
};

// Triangles that share one material.
struct Part {
    std::uint32_t firstIndex = 0;
    std::uint32_t indexCount = 0; // a multiple of 3
    int material = 0;             // into Model::materials
};

// A coarser stand-in for the whole model, for when it is small in the picture.
struct Level {
    float error = 0;                    // m, model space: how far its surface strays from the full model's
    std::vector<std::uint32_t> indices; // into Model::vertices, as Model::indices
    std::vector<Part> parts;            // ranges of this level's indices
};

struct Model {
    std::string name;
    std::vector<Vertex> vertices;       // those that only levels use stand after the full model's
    std::vector<std::uint32_t> indices; // counter-clockwise is the front
    std::vector<Part> parts;
    std::vector<Level> levels;          // coarser and coarser, errors rising; none: drawn in full at any distance
    std::vector<Material> materials;    // at least one
    std::vector<std::shared_ptr<const Image>> images; // null: could not be read, drawn as a checkerboard
    Box bounds;
    std::size_t untrimmed = 0;          // triangles before its cards were cut to what is opaque of them; 0: as many as now

    std::size_t triangles() const { return untrimmed ? untrimmed : indices.size() / 3; } // as its author made it
};

// A box from -size/2 to size/2 on x and z and from 0 to size.y: what a marker or a missing model is drawn as.
Model boxModel(const glm::vec3& size, const glm::vec4& colour);

} // namespace io
