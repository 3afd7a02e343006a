// A map's heights, normals and cover as textures: of the map's own size while that can be borne, else as windows around the eye.
#pragma once

#include "io/scene/cover_map.h"
#include "io/scene/height_map.h"
#include "renderer/gpu_frame.h"
#include "renderer/shaders/shared/terrain.h"

#include <cmath>
#include <memory>

namespace renderer {

using Normals = std::vector<glm::i16vec2>; // x and z of unit normals, as GL_RG16_SNORM

// From the heights at both sides along x and along z, which lie so many metres apart.
inline glm::i16vec2 normalBetween(glm::vec2 alongX, float metresX, glm::vec2 alongZ, float metresZ)
{
    const auto nearest = [](float v) { return std::int16_t(int(v + 32768.5f) - 32768); }; // std::lround() takes longer than all the rest
    const float dx = (alongX.x - alongX.y) / metresX, dz = (alongZ.x - alongZ.y) / metresZ;
    const float scale = 32767 / std::sqrt(dx * dx + dz * dz + 1);
    return {nearest(dx * scale), nearest(dz * scale)};
}

class TerrainTexels {
public:
    virtual ~TerrainTexels() = default;
    virtual void load(std::shared_ptr<const io::HeightMap> map) = 0;
    // Another map that differs from the one before within `changed` only.
    virtual void change(std::shared_ptr<const io::HeightMap> map, const io::TexelRect& changed) = 0;
    virtual void loadCover(std::shared_ptr<const io::CoverMap> cover) = 0; // null: none
    virtual void changeCover(std::shared_ptr<const io::CoverMap> cover, const io::TexelRect& changed) = 0;

    // What an eye over that texel needs is there until the next call.
    virtual void follow(const glm::dvec2& texel, glsl::Terrain& block) = 0;
    // Texels from there on that a level is there for, of vertices `1 << level` apart; infinite where it is everywhere.
    virtual double reach(int level) const = 0;

    void bind(GpuFrame& gpu) const; // to be shaded
    void bindForShadows(GpuFrame& gpu) const;

protected:
    gl::Texture m_heights; // m
    gl::Texture m_normals;
    gl::Texture m_cover;   // as io::packed(); empty: none
};

// Everything at once, with mips of the normals.
std::unique_ptr<TerrainTexels> wholeTexels();

// Levels of every, every second, every fourth ... texel, each `side` texels wide around the eye, the last one of the whole map;
// wrapped around, so that only what came in is written (Losasso and Hoppe, "Geometry clipmaps", 2004).
std::unique_ptr<TerrainTexels> windowedTexels(int side);

} // namespace renderer
