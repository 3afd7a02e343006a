#include "renderer/terrain_texels.h"

#include "renderer/shaders/shared/bindings.h"

#include <algorithm>
#include <cmath>

namespace renderer {
namespace {

std::int16_t nearest(float v) // std::lround() takes longer than all the rest of a normal
{
    return std::int16_t(int(v + 32768.5f) - 32768);
}

// Of the texels of `rect`, row by row.
Normals normalsOf(const io::HeightMap& map, const io::TexelRect& rect)
{
    const glm::ivec2 low{rect.low}, high{rect.high};
    const io::TexelRect around{glm::max(rect.low - io::Texel{1}, io::Texel{0}), glm::min(rect.high + io::Texel{1}, io::Texel{map.size})};
    const io::HeightGrid heights = map.read(around);
    const glm::ivec2 first{around.low}, last = heights.size - 1;
    Normals normals;
    normals.reserve(std::size_t(high.x - low.x) * (high.y - low.y));
    const auto step = float(map.metresPerTexel);
    for (int z = low.y - first.y; z < high.y - first.y; ++z)
        for (int x = low.x - first.x; x < high.x - first.x; ++x) {
            const int x0 = std::max(x - 1, 0), x1 = std::min(x + 1, last.x);
            const int z0 = std::max(z - 1, 0), z1 = std::min(z + 1, last.y);
            normals.push_back(normalBetween({heights.at(x0, z), heights.at(x1, z)}, step * float(x1 - x0),
                                            {heights.at(x, z0), heights.at(x, z1)}, step * float(z1 - z0)));
        }
    return normals;
}

// The mean of four texels of a mip that is `size` large. Of an odd side the last row or column is left out, as of any mip.
glm::i16vec2 halved(const Normals& from, glm::ivec2 size, int x, int z)
{
    const std::size_t right = size.x > 1, below = size.y > 1 ? std::size_t(size.x) : 0;
    const glm::i16vec2* texel = &from[std::size_t(2 * z) * size.x + 2 * x];
    return glm::i16vec2{(glm::ivec2{texel[0]} + glm::ivec2{texel[right]} + glm::ivec2{texel[below]} + glm::ivec2{texel[right + below]}) / 4};
}

class WholeTexels : public TerrainTexels {
public:
    void load(std::shared_ptr<const io::HeightMap> map) override
    {
        m_heights = gl::Texture{{.label = "ground heights", .size = map->size, .format = GL_R32F, .filter = GL_NEAREST}};
        m_heights.upload(map->read(map->texels()).metres.data(), GL_RED, GL_FLOAT);
        m_normals = gl::Texture{{.label = "ground normals",
                                 .size = map->size,
                                 .format = GL_RG16_SNORM,
                                 .mips = gl::fullMipCount(map->size)}};
        m_normalMips.clear();
        for (int mip = 0; mip < m_normals.mips(); ++mip)
            m_normalMips.emplace_back(std::size_t(m_normals.size(mip).x) * m_normals.size(mip).y);
        uploadNormals(*map, map->texels());
    }

    void change(std::shared_ptr<const io::HeightMap> map, const io::TexelRect& changed) override
    {
        const io::HeightGrid part = map->read(changed);
        m_heights.uploadPart(glm::ivec2{changed.low}, part.size, part.metres.data(), GL_RED, GL_FLOAT);
        uploadNormals(*map, changed);
    }

    void loadCover(std::shared_ptr<const io::CoverMap> cover) override
    {
        m_cover = {};
        if (!cover) return;
        m_cover = gl::Texture{{.label = "ground cover", .size = cover->size(), .filter = GL_NEAREST}};
        m_cover.upload(cover->read(cover->rect()).data(), GL_RGBA, GL_UNSIGNED_BYTE);
    }

    void changeCover(std::shared_ptr<const io::CoverMap> cover, const io::TexelRect& changed) override
    {
        m_cover.uploadPart(changed.low, changed.high - changed.low, cover->read(changed).data(), GL_RGBA, GL_UNSIGNED_BYTE);
    }

    void follow(const glm::dvec2&, glsl::Terrain& block) override { block.windows = 0; }
    double reach(int) const override { return INFINITY; }

    void bind(GpuFrame& gpu) const override
    {
        bindForShadows(gpu);
        gpu.bind({{GROUND_NORMALS_UNIT, &m_normals}});
    }

    void bindForShadows(GpuFrame& gpu) const override
    {
        gpu.bind({{HEIGHTS_UNIT, &m_heights}});
        if (m_cover) gpu.bind({{COVER_UNIT, &m_cover}});
    }

private:
    // A normal looks at its neighbours, so those around what changed change too.
    void uploadNormals(const io::HeightMap& map, const io::TexelRect& changed)
    {
        glm::ivec2 low = glm::max(glm::ivec2{changed.low} - 1, glm::ivec2{0}), high = glm::min(glm::ivec2{changed.high} + 1, map.size);
        const Normals normals = normalsOf(map, {low, high});
        for (int mip = 0; mip < m_normals.mips(); ++mip) {
            Normals& own = m_normalMips[std::size_t(mip)];
            const glm::ivec2 size = m_normals.size(mip);
            Normals part;
            for (int z = low.y; z < high.y; ++z)
                for (int x = low.x; x < high.x; ++x) {
                    const glm::i16vec2 normal = mip == 0 ? normals[part.size()] : halved(m_normalMips[std::size_t(mip) - 1], m_normals.size(mip - 1), x, z);
                    own[std::size_t(z) * size.x + x] = normal;
                    part.push_back(normal);
                }
            m_normals.uploadPart(low, high - low, part.data(), GL_RG, GL_SHORT, mip);
            const glm::ivec2 above = m_normals.size(mip + 1);
            low = glm::min(low / 2, above - 1);
            high = glm::min((high + 1) / 2, above);
        }
    }

    gl::Texture m_heights; // m
    gl::Texture m_normals;
    std::vector<Normals> m_normalMips; // as uploaded: a change makes those above it anew
    gl::Texture m_cover;               // as io::packed()
};

} // namespace

glm::i16vec2 normalBetween(glm::vec2 alongX, float metresX, glm::vec2 alongZ, float metresZ)
{
    const float dx = (alongX.x - alongX.y) / metresX, dz = (alongZ.x - alongZ.y) / metresZ;
    const float scale = 32767 / std::sqrt(dx * dx + dz * dz + 1);
    return {nearest(dx * scale), nearest(dz * scale)};
}

std::unique_ptr<TerrainTexels> wholeTexels()
{
    return std::make_unique<WholeTexels>();
}

} // namespace renderer
