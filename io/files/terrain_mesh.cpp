// The ground as nodes of a glTF document.
#include "io/files/gltf_document.h"
#include "io/files/height_export.h"
#include "io/scene/bounds.h"

#include <algorithm>
#include <fmt/format.h>
#include <map>

namespace io {
namespace fs = std::filesystem;
namespace {

constexpr int kTileSquares = 256; // along a side

// Texels that become vertices: every `step`-th, and the last.
std::vector<int> lines(int texels, int step)
{
    std::vector<int> at;
    for (int i = 0; i < texels - 1; i += step)
        at.push_back(i);
    at.push_back(texels - 1);
    return at;
}

// A tile's lines, columns and rows, out of those of the whole ground.
struct Tile {
    std::span<const int> columns, rows; // texels
};

class MeshWriter {
public:
    MeshWriter(GltfDocument& document, const HeightMap& heights, const CoverMap* cover, int step)
        : m_document{document}, m_heights{heights}, m_cover{cover && cover->size() == heights.size ? cover : nullptr}, m_step{step}
    {
    }

    Value::Array nodes; // numbers, one a tile
    std::uint64_t triangles = 0;

    void add(const Tile& tile)
    {
        const int indices = indicesOf(tile);
        if (indices < 0) return; // all of it is a hole
        Value::Object attributes;
        Box bounds;
        const int position = add<glm::vec3>(tile, "VEC3", [&](int x, int z) {
            const glm::dvec2 away = glm::dvec2{x - tile.columns[0], z - tile.rows[0]} * m_heights.metresPerTexel;
            const glm::vec3 at{float(away.x), m_heights.at(x, z), float(away.y)};
            bounds.add(at);
            return at;
        });
        m_document.buffer.accessors.back()["min"] = numbers(bounds.min);
        m_document.buffer.accessors.back()["max"] = numbers(bounds.max);
        attributes.emplace_back("POSITION", position);
        attributes.emplace_back("NORMAL", add<glm::vec3>(tile, "VEC3", [&](int x, int z) { return normalAt(x, z); }));
        attributes.emplace_back("TEXCOORD_0", add<glm::vec2>(tile, "VEC2", [&](int x, int z) {
                                    return glm::vec2{x, z} / glm::vec2{m_heights.size - 1};
                                }));
        const std::string name = fmt::format("ground {} {}", tile.columns[0], tile.rows[0]);
        const int material = int(m_document.materials.size()); // the next one, made when all tiles are
        Value primitive = Value::Object{{"attributes", std::move(attributes)}, {"indices", indices}, {"material", material}};
        m_document.meshes.push_back(Value::Object{{"name", name}, {"primitives", Value::Array{std::move(primitive)}}});
        const glm::dvec2 corner = m_heights.origin + glm::dvec2{tile.columns[0], tile.rows[0]} * m_heights.metresPerTexel;
        nodes.push_back(int(m_document.nodes.size()));
        m_document.nodes.push_back(Value::Object{{"name", name},
                                                 {"mesh", int(m_document.meshes.size()) - 1},
                                                 {"translation", Value::Array{corner.x, 0, corner.y}}});
    }

private:
    template <class T, class At> int add(const Tile& tile, const char* type, At at)
    {
        std::vector<T> values;
        values.reserve(tile.columns.size() * tile.rows.size());
        for (const int z : tile.rows)
            for (const int x : tile.columns)
                values.push_back(at(x, z));
        const int view = m_document.buffer.addView(values.data(), values.size() * sizeof(T), kVertexData);
        return m_document.buffer.addAccessor(view, kFloat, 0, values.size(), type);
    }

    glm::vec3 normalAt(int x, int z) const
    {
        const glm::ivec2 low = glm::max(glm::ivec2{x, z} - m_step, 0), high = glm::min(glm::ivec2{x, z} + m_step, m_heights.size - 1);
        const glm::dvec2 apart = glm::dvec2{high - low} * m_heights.metresPerTexel;
        return glm::vec3{glm::normalize(glm::dvec3{(m_heights.at(low.x, z) - m_heights.at(high.x, z)) / apart.x, 1,
                                                   (m_heights.at(x, low.y) - m_heights.at(x, high.y)) / apart.y})};
    }

    // Most of the ground between two lines is missing.
    bool hole(glm::ivec2 low, glm::ivec2 high) const
    {
        int missing = 0;
        for (int z = low.y; z < high.y; ++z)
            for (int x = low.x; x < high.x; ++x)
                missing += (m_cover->at(x, z) & kHoleBit) != 0;
        return missing * 2 > (high.x - low.x) * (high.y - low.y);
    }

    // Counter-clockwise seen from above, with the diagonal that the editor draws. Tiles of one size without holes share them.
    int indicesOf(const Tile& tile)
    {
        const auto width = std::uint32_t(tile.columns.size());
        std::vector<std::uint32_t> indices;
        bool holes = false;
        for (std::size_t row = 0; row + 1 < tile.rows.size(); ++row)
            for (std::size_t column = 0; column + 1 < tile.columns.size(); ++column) {
                if (m_cover && hole({tile.columns[column], tile.rows[row]}, {tile.columns[column + 1], tile.rows[row + 1]})) {
                    holes = true;
                    continue;
                }
                const auto first = std::uint32_t(row) * width + std::uint32_t(column);
                for (const std::uint32_t offset : {0u, width, 1u, 1u, width, width + 1})
                    indices.push_back(first + offset);
            }
        triangles += indices.size() / 3;
        if (indices.empty()) return -1;
        const std::pair key{tile.columns.size(), tile.rows.size()};
        if (const auto known = m_indices.find(key); !holes && known != m_indices.end()) return known->second;
        const int view = m_document.buffer.addView(indices.data(), indices.size() * sizeof indices[0], kIndexData);
        const int accessor = m_document.buffer.addAccessor(view, kUnsignedInt, 0, indices.size(), "SCALAR");
        if (!holes) m_indices[key] = accessor;
        return accessor;
    }

    GltfDocument& m_document;
    const HeightMap& m_heights;
    const CoverMap* m_cover;
    int m_step;
    std::map<std::pair<std::size_t, std::size_t>, int> m_indices;
};

Value materialOf(const Terrain& terrain)
{
    const glm::vec3 colour = terrain.layers.empty() ? glm::vec3{0.5f} : glm::clamp(terrain.layers.front().colour, 0.0f, 1.0f);
    Value surface = Value::Object{{"baseColorFactor", numbers(glm::vec4{colour, 1})}, {"metallicFactor", 0}, {"roughnessFactor", 0.95}};
    return Value::Object{{"name", "Ground"}, {"pbrMetallicRoughness", std::move(surface)}};
}

} // namespace

GroundNodes addGround(GltfDocument& document, const HeightMap& heights, const CoverMap* cover, const Terrain& terrain, int step)
{
    const std::vector<int> columns = lines(heights.size.x, step), rows = lines(heights.size.y, step);
    MeshWriter writer{document, heights, cover, step};
    const auto part = [](const std::vector<int>& all, std::size_t first) {
        return std::span{all}.subspan(first, std::min<std::size_t>(kTileSquares + 1, all.size() - first));
    };
    for (std::size_t z = 0; z + 1 < rows.size(); z += kTileSquares)
        for (std::size_t x = 0; x + 1 < columns.size(); x += kTileSquares)
            writer.add({part(columns, x), part(rows, z)});
    if (writer.nodes.empty()) return {};
    document.materials.push_back(materialOf(terrain));
    const GroundNodes made{.root = int(document.nodes.size()), .tiles = int(writer.nodes.size()), .triangles = writer.triangles};
    document.nodes.push_back(Value::Object{{"name", "terrain"}, {"children", std::move(writer.nodes)}});
    return made;
}

} // namespace io
