#include "renderer/terrain_texels.h"

#include "renderer/shaders/shared/bindings.h"

#include <algorithm>
#include <cmath>

namespace renderer {
namespace {

// A part of a map with a texel more on each side, as far as there are some.
struct Around {
    io::HeightGrid heights;
    glm::ivec2 first; // texel

    Around(const io::HeightMap& map, const io::TexelRect& part)
        : heights{map.read({glm::max(part.low - io::Texel{1}, io::Texel{0}), glm::min(part.high + io::Texel{1}, io::Texel{map.size})})},
          first{glm::max(part.low - io::Texel{1}, io::Texel{0})}
    {
    }
    const float* at(int x, int z) const { return &heights.metres[std::size_t(z - first.y) * heights.size.x + (x - first.x)]; }
};

// Of the texels [low, high) of a row of a map that is `width` wide; the three rows begin at `low`.
void normalRow(const float* north, const float* here, const float* south, float metresZ, float metres, int low, int high, int width, glm::i16vec2* out)
{
    const auto at = [&](int i, int left, int right) {
        return normalBetween({here[i - left], here[i + right]}, metres * float(left + right), {north[i], south[i]}, metresZ);
    };
    int i = 0;
    const int last = width - 1 - low, end = high - low;
    if (low == 0) *out++ = at(i, 0, std::min(1, last)), ++i;
    for (const int inner = std::min(end, last); i < inner; ++i)
        *out++ = at(i, 1, 1);
    if (i < end) *out = at(i, 1, 0);
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
        const Around all{*map, map->texels()};
        m_heights.upload(all.heights.metres.data(), GL_RED, GL_FLOAT);
        m_normals = gl::Texture{{.label = "ground normals",
                                 .size = map->size,
                                 .format = GL_RG16_SNORM,
                                 .mips = gl::fullMipCount(map->size)}};
        m_normalMips.clear();
        for (int mip = 0; mip < m_normals.mips(); ++mip)
            m_normalMips.emplace_back(std::size_t(m_normals.size(mip).x) * m_normals.size(mip).y);
        uploadNormals(*map, map->texels(), all);
    }

    void change(std::shared_ptr<const io::HeightMap> map, const io::TexelRect& changed) override
    {
        // A normal looks at its neighbours, so those around what changed change too.
        const io::TexelRect touched{glm::max(changed.low - io::Texel{1}, io::Texel{0}), glm::min(changed.high + io::Texel{1}, io::Texel{map->size})};
        const Around part{*map, touched};
        m_heights.uploadPart(changed.low, changed.high - changed.low, part.at(int(changed.low.x), int(changed.low.y)), GL_RED, GL_FLOAT, 0, 0, part.heights.size.x);
        uploadNormals(*map, touched, part);
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

private:
    void uploadNormals(const io::HeightMap& map, const io::TexelRect& part, const Around& around)
    {
        glm::ivec2 low{part.low}, high{part.high};
        const auto metres = float(map.metresPerTexel);
        for (int mip = 0; mip < m_normals.mips(); ++mip) {
            Normals& own = m_normalMips[std::size_t(mip)];
            const glm::ivec2 size = m_normals.size(mip);
            for (int z = low.y; z < high.y; ++z) {
                glm::i16vec2* out = &own[std::size_t(z) * size.x + low.x];
                if (mip > 0) {
                    for (int x = low.x; x < high.x; ++x)
                        *out++ = halved(m_normalMips[std::size_t(mip) - 1], m_normals.size(mip - 1), x, z);
                } else {
                    const int north = std::max(z - 1, 0), south = std::min(z + 1, size.y - 1);
                    normalRow(around.at(low.x, north), around.at(low.x, z), around.at(low.x, south), metres * float(south - north), metres, low.x, high.x, size.x, out);
                }
            }
            m_normals.uploadPart(low, high - low, &own[std::size_t(low.y) * size.x + low.x], GL_RG, GL_SHORT, mip, 0, size.x);
            const glm::ivec2 above = m_normals.size(mip + 1);
            low = glm::min(low / 2, above - 1);
            high = glm::min((high + 1) / 2, above);
        }
    }

    std::vector<Normals> m_normalMips; // as uploaded: a change makes those above it anew
};

} // namespace

void TerrainTexels::bind(GpuFrame& gpu) const
{
    bindForShadows(gpu);
    gpu.bind({{GROUND_NORMALS_UNIT, &m_normals}});
}

void TerrainTexels::bindForShadows(GpuFrame& gpu) const
{
    gpu.bind({{HEIGHTS_UNIT, &m_heights}});
    if (m_cover) gpu.bind({{COVER_UNIT, &m_cover}});
}

std::unique_ptr<TerrainTexels> wholeTexels()
{
    return std::make_unique<WholeTexels>();
}

} // namespace renderer
