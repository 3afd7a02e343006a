// The ground as a glTF mesh.
#include "io/files/atomic_file.h"
#include "io/files/file_names.h"
#include "io/files/gltf_buffer.h"
#include "io/files/height_export.h"
#include "io/files/json.h"
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
    MeshWriter(const HeightMap& heights, const CoverMap* cover, int step)
        : m_heights{heights}, m_cover{cover && cover->size() == heights.size ? cover : nullptr}, m_step{step}
    {
    }

    GltfBuffer buffer;
    Value::Array meshes, nodes; // one of each a tile
    std::uint64_t triangles = 0;

    void add(const Tile& tile)
    {
        const int indices = indicesOf(tile);
        if (indices < 0) return; // all of it is a hole
        Value::Object attributes;
        Box bounds;
        const int position = add<glm::vec3>(tile, "VEC3", [&](int x, int z) {
            const glm::vec3 at{float((x - tile.columns[0]) * m_heights.metresPerTexel), m_heights.at(x, z), float((z - tile.rows[0]) * m_heights.metresPerTexel)};
            bounds.add(at);
            return at;
        });
        buffer.accessors.back()["min"] = numbers(bounds.min);
        buffer.accessors.back()["max"] = numbers(bounds.max);
        attributes.emplace_back("POSITION", position);
        attributes.emplace_back("NORMAL", add<glm::vec3>(tile, "VEC3", [&](int x, int z) { return normalAt(x, z); }));
        attributes.emplace_back("TEXCOORD_0", add<glm::vec2>(tile, "VEC2", [&](int x, int z) {
                                    return glm::vec2{x, z} / glm::vec2{m_heights.size - 1};
                                }));
        const std::string name = fmt::format("ground {} {}", tile.columns[0], tile.rows[0]);
        meshes.push_back(Value::Object{{"name", name},
                                       {"primitives", Value::Array{Value::Object{{"attributes", std::move(attributes)}, {"indices", indices}, {"material", 0}}}}});
        const glm::dvec2 corner = m_heights.origin + glm::dvec2{tile.columns[0], tile.rows[0]} * m_heights.metresPerTexel;
        nodes.push_back(Value::Object{{"name", name}, {"mesh", int(meshes.size()) - 1}, {"translation", Value::Array{corner.x, 0, corner.y}}});
    }

private:
    template <class T, class At> int add(const Tile& tile, const char* type, At at)
    {
        std::vector<T> values;
        values.reserve(tile.columns.size() * tile.rows.size());
        for (const int z : tile.rows)
            for (const int x : tile.columns)
                values.push_back(at(x, z));
        const int view = buffer.addView(values.data(), values.size() * sizeof(T), kVertexData);
        return buffer.addAccessor(view, kFloat, 0, values.size(), type);
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
        const int view = buffer.addView(indices.data(), indices.size() * sizeof indices[0], kIndexData);
        const int accessor = buffer.addAccessor(view, kUnsignedInt, 0, indices.size(), "SCALAR");
        if (!holes) m_indices[key] = accessor;
        return accessor;
    }

    const HeightMap& m_heights;
    const CoverMap* m_cover;
    int m_step;
    std::map<std::pair<std::size_t, std::size_t>, int> m_indices;
};

Value materialOf(const Terrain& terrain)
{
    const glm::vec3 colour = terrain.layers.empty() ? glm::vec3{0.5f} : glm::clamp(terrain.layers.front().colour, 0.0f, 1.0f);
    return Value::Object{{"name", "Ground"},
                         {"pbrMetallicRoughness", Value::Object{{"baseColorFactor", numbers(glm::vec4{colour, 1})}, {"metallicFactor", 0}, {"roughnessFactor", 0.95}}}};
}

Value gltfOf(MeshWriter& writer, const Terrain& terrain, Value buffer)
{
    Value::Array children;
    for (std::size_t i = 0; i < writer.nodes.size(); ++i)
        children.push_back(int(i));
    const int root = int(writer.nodes.size());
    writer.nodes.push_back(Value::Object{{"name", "terrain"}, {"children", std::move(children)}});
    return Value::Object{{"asset", Value::Object{{"version", "2.0"}, {"generator", "Wold"}}},
                         {"scene", 0},
                         {"scenes", Value::Array{Value::Object{{"nodes", Value::Array{root}}}}},
                         {"nodes", std::move(writer.nodes)},
                         {"meshes", std::move(writer.meshes)},
                         {"materials", Value::Array{materialOf(terrain)}},
                         {"accessors", std::move(writer.buffer.accessors)},
                         {"bufferViews", std::move(writer.buffer.views)},
                         {"buffers", Value::Array{std::move(buffer)}}};
}

// A file name as part of a URI (RFC 3986).
std::string uriOf(const std::string& name)
{
    std::string uri;
    for (const char c : name) {
        const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' || c == '_' || c == '.' || c == '~';
        uri += plain ? std::string{c} : fmt::format("%{:02X}", static_cast<unsigned char>(c));
    }
    return uri;
}

} // namespace

std::uint64_t meshTriangles(glm::ivec2 size, int step)
{
    const auto squares = [&](int texels) { return std::uint64_t(texels - 2) / std::uint64_t(step) + 1; };
    return squares(size.x) * squares(size.y) * 2;
}

int meshStep(glm::ivec2 size, std::uint64_t triangles)
{
    int step = 1;
    while (meshTriangles(size, step) > triangles)
        step *= 2;
    return step;
}

Result<MeshExport> exportTerrainMesh(const fs::path& file, const HeightMap& heights, const CoverMap* cover, const Terrain& terrain, int step)
{
    if (!exportsMesh(file)) return Error{file.string(), "the ground's mesh is written as .glb or .gltf"};
    if (meshTriangles(heights.size, step) > kMostTriangles)
        return Error{file.string(), fmt::format("{} triangles are too many for one file; ask for a step of {} texels or more", meshTriangles(heights.size, step),
                                                meshStep(heights.size, kMostTriangles))};
    const std::vector<int> columns = lines(heights.size.x, step), rows = lines(heights.size.y, step);
    MeshWriter writer{heights, cover, step};
    const auto part = [](const std::vector<int>& all, std::size_t first) {
        return std::span{all}.subspan(first, std::min<std::size_t>(kTileSquares + 1, all.size() - first));
    };
    for (std::size_t z = 0; z + 1 < rows.size(); z += kTileSquares)
        for (std::size_t x = 0; x + 1 < columns.size(); x += kTileSquares)
            writer.add({part(columns, x), part(rows, z)});
    if (writer.meshes.empty()) return Error{file.string(), "all of the ground is a hole; there is nothing to write"};

    MeshExport done{.written = {file}, .step = step, .tiles = int(writer.meshes.size()), .triangles = writer.triangles};
    std::string bytes = std::move(writer.buffer.bytes);
    Value buffer = Value::Object{{"byteLength", std::uint64_t(bytes.size())}};
    if (lowerExtension(file) == ".glb") {
        const Status written = writeFile(file, glbOf(gltfOf(writer, terrain, std::move(buffer)), std::move(bytes)));
        return written ? Result<MeshExport>{std::move(done)} : Result<MeshExport>{written.error()};
    }
    fs::path beside = file;
    beside.replace_extension(".bin");
    buffer["uri"] = uriOf(beside.filename().string());
    if (const Status written = writeFile(beside, bytes); !written) return written.error();
    if (const Status written = writeFile(file, writeJson(gltfOf(writer, terrain, std::move(buffer))) + "\n"); !written) return written.error();
    done.written.push_back(beside);
    return done;
}

} // namespace io
