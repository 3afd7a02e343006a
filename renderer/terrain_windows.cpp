#include "io/base/in_parallel.h"
#include "renderer/terrain_texels.h"

#include <algorithm>
#include <cmath>

namespace renderer {
namespace {

constexpr int kBlock = 32; // samples by which a window moves
constexpr int kRowsAtOnce = 256, kRowsWorthAThread = 64;

// Samples of a level: every `1 << level`-th texel, and for the one beyond the map's edge, the edge.
struct Samples {
    std::vector<float> heights; // m
    Normals normals;
};

class Sampler {
public:
    Sampler(const io::HeightMap& map, int level, const io::TexelRect& rect)
        : m_map{map}, m_level{level}, m_low{rect.low}, m_size{rect.high - rect.low}
    {
        for (int i = -1; i <= m_size.x; ++i)
            m_columns.push_back(texel(m_low.x + i, map.size.x));
    }

    void take(int from, int to, Samples& samples) const // rows of the rectangle
    {
        const std::size_t count = std::size_t(m_size.x) * std::size_t(to - from);
        samples.heights.resize(count);
        samples.normals.resize(count);
        io::inParallel(to - from, kRowsWorthAThread, [&](int first, int last) {
            const std::size_t skipped = std::size_t(m_size.x) * std::size_t(first);
            takeRows(from + first, from + last, samples.heights.data() + skipped, samples.normals.data() + skipped);
        });
    }

private:
    void takeRows(int from, int to, float* heights, glm::i16vec2* normals) const
    {
        std::vector<float> north = row(from - 1), here = row(from), south;
        const auto metres = float(m_map.metresPerTexel);
        for (int z = from; z < to; ++z) {
            south = row(z + 1);
            const int spanZ = std::max(texel(m_low.y + z + 1, m_map.size.y) - texel(m_low.y + z - 1, m_map.size.y), 1);
            for (std::size_t x = 1; x + 1 < m_columns.size(); ++x) {
                const int spanX = std::max(m_columns[x + 1] - m_columns[x - 1], 1);
                *heights++ = here[x];
                *normals++ = normalBetween({here[x - 1], here[x + 1]}, metres * float(spanX), {north[x], south[x]}, metres * float(spanZ));
            }
            north.swap(here);
            here.swap(south);
        }
    }

    int texel(int sample, int size) const { return std::clamp(sample * (1 << m_level), 0, size - 1); }

    std::vector<float> row(int z) const
    {
        const int at = texel(m_low.y + z, m_map.size.y);
        std::vector<float> heights;
        heights.reserve(m_columns.size());
        for (const int column : m_columns)
            heights.push_back(m_map.at(column, at));
        return heights;
    }

    const io::HeightMap& m_map;
    int m_level;
    glm::ivec2 m_low, m_size;
    std::vector<int> m_columns; // texels, one more at each side
};

class WindowedTexels : public TerrainTexels {
public:
    explicit WindowedTexels(int side) : m_side{side} {}

    void load(std::shared_ptr<const io::HeightMap> map) override
    {
        m_map = std::move(map);
        const int last = std::max(m_map->size.x, m_map->size.y) - 1;
        int levels = 1;
        while ((last >> (levels - 1)) + 2 > m_side)
            ++levels;
        const auto array = [&](std::string_view label, GLenum format, GLenum filter) {
            return gl::Texture{{.label = label, .size = glm::ivec2{m_side}, .layers = levels, .format = format, .filter = filter, .wrap = GL_REPEAT}};
        };
        if (m_heights.layers() != levels) {
            m_heights = array("ground heights in windows", GL_R32F, GL_NEAREST);
            m_normals = array("ground normals in windows", GL_RG16_SNORM, GL_LINEAR);
        }
        m_held.assign(std::size_t(levels), {});
        if (m_coverMap) loadCover(m_coverMap);
    }

    void change(std::shared_ptr<const io::HeightMap> map, const io::TexelRect& changed) override
    {
        m_map = std::move(map);
        for (int level = 0; level < levels(); ++level)
            write(level, common(samplesUnder(changed, level, 1), m_held[std::size_t(level)]));
    }

    void loadCover(std::shared_ptr<const io::CoverMap> cover) override
    {
        m_coverMap = std::move(cover);
        m_cover = {};
        if (!m_coverMap || !m_map) return;
        m_cover = gl::Texture{{.label = "ground cover in windows", .size = glm::ivec2{m_side}, .layers = levels(), .filter = GL_NEAREST, .wrap = GL_REPEAT}};
        for (int level = 0; level < levels(); ++level)
            writeCover(level, m_held[std::size_t(level)]);
    }

    void changeCover(std::shared_ptr<const io::CoverMap> cover, const io::TexelRect& changed) override
    {
        m_coverMap = std::move(cover);
        for (int level = 0; level < levels(); ++level)
            writeCover(level, common(samplesUnder(changed, level, 0), m_held[std::size_t(level)]));
    }

    void follow(const glm::dvec2& texel, glsl::Terrain& block) override
    {
        const glm::dvec2 from = glm::clamp(texel, glm::dvec2{0}, glm::dvec2{m_map->size - 1});
        for (int level = 0; level < levels(); ++level) {
            io::TexelRect& held = m_held[std::size_t(level)];
            io::Texel low{0};
            if (level + 1 < levels()) low = io::Texel{glm::floor((from / std::exp2(level) - m_side * 0.5) / double(kBlock))} * std::int64_t(kBlock);
            const io::TexelRect wanted{low, low + io::Texel{m_side}};
            for (const io::TexelRect& part : io::without(wanted, held)) {
                write(level, part);
                writeCover(level, part);
            }
            held = wanted;
        }
        block.windows = levels();
        block.windowSide = m_side;
        block.windowsFrom = from;
        block.windowReach = float(reach(0));
    }

    double reach(int level) const override
    {
        return level + 1 >= levels() ? INFINITY : (m_side / 2 - kBlock - 2) * std::exp2(level);
    }

private:
    int levels() const { return m_heights.layers(); }

    // Those that stand for texels of a rectangle, and so many more around; the last may stand for the map's edge.
    io::TexelRect samplesUnder(const io::TexelRect& texels, int level, int around) const
    {
        const std::int64_t step = std::int64_t(1) << level;
        return {texels.low / step - io::Texel{around}, (texels.high - io::Texel{1} + io::Texel{step - 1}) / step + io::Texel{1 + around}};
    }

    void write(int level, const io::TexelRect& rect)
    {
        for (const io::TexelRect& piece : io::cutAtMultiples(rect, m_side)) {
            const Sampler sampler{*m_map, level, piece};
            const glm::ivec2 at = inTexture(piece.low), size = piece.high - piece.low;
            for (int row = 0; row < size.y; row += kRowsAtOnce) {
                const int rows = std::min(kRowsAtOnce, size.y - row);
                sampler.take(row, row + rows, m_samples);
                m_heights.uploadPart({at.x, at.y + row}, {size.x, rows}, m_samples.heights.data(), GL_RED, GL_FLOAT, 0, level);
                m_normals.uploadPart({at.x, at.y + row}, {size.x, rows}, m_samples.normals.data(), GL_RG, GL_SHORT, 0, level);
            }
        }
    }

    void writeCover(int level, const io::TexelRect& rect)
    {
        if (!m_cover) return;
        const glm::ivec2 last = m_coverMap->size() - 1;
        for (const io::TexelRect& piece : io::cutAtMultiples(rect, m_side)) {
            std::vector<std::uint32_t> texels;
            for (auto z = piece.low.y; z < piece.high.y; ++z)
                for (auto x = piece.low.x; x < piece.high.x; ++x)
                    texels.push_back(m_coverMap->at(std::clamp(int(x << level), 0, last.x), std::clamp(int(z << level), 0, last.y)));
            m_cover.uploadPart(inTexture(piece.low), piece.high - piece.low, texels.data(), GL_RGBA, GL_UNSIGNED_BYTE, 0, level);
        }
    }

    glm::ivec2 inTexture(const io::Texel& sample) const
    {
        const auto wrapped = [this](std::int64_t v) { return int((v % m_side + m_side) % m_side); };
        return {wrapped(sample.x), wrapped(sample.y)};
    }

    int m_side;
    std::shared_ptr<const io::HeightMap> m_map;
    std::shared_ptr<const io::CoverMap> m_coverMap;
    Samples m_samples; // those on their way, kept as memory is dear to get
    std::vector<io::TexelRect> m_held; // samples of each level that its layer of the textures holds
};

} // namespace

std::unique_ptr<TerrainTexels> windowedTexels(int side)
{
    return std::make_unique<WindowedTexels>(side);
}

} // namespace renderer
