#include "io/files/gltf_mesh.h"

#include "io/files/shading_frames.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace io::gltf {
namespace {

constexpr float kFarthest = 1e9f; // m
constexpr std::uint64_t kMostBytes = std::uint64_t(2) << 30;
constexpr std::size_t kMostPrimitives = 200'000;

using Triangles = std::vector<std::uint32_t>; // three indices each, into a primitive's own vertices

// Strips and fans as single triangles (glTF 2.0, 3.7.2.1).
Triangles unrolled(std::vector<std::uint32_t> indices, int mode)
{
    if (mode == TINYGLTF_MODE_TRIANGLES) return indices;
    Triangles result;
    for (std::size_t i = 2; i < indices.size(); ++i) {
        if (mode == TINYGLTF_MODE_TRIANGLE_FAN)
            result.insert(result.end(), {indices[i - 1], indices[i], indices[0]});
        else if (i % 2 == 0)
            result.insert(result.end(), {indices[i - 2], indices[i - 1], indices[i]});
        else
            result.insert(result.end(), {indices[i - 1], indices[i - 2], indices[i]});
    }
    return result;
}

bool finite(const glm::vec4& row)
{
    return std::isfinite(row.x) && std::isfinite(row.y) && std::isfinite(row.z) && std::isfinite(row.w);
}

bool near(const glm::vec3& position)
{
    return std::abs(position.x) <= kFarthest && std::abs(position.y) <= kFarthest && std::abs(position.z) <= kFarthest;
}

// A primitive's vertices in its own space. Read once, whatever number of times its mesh stands somewhere.
struct Shape {
    std::vector<Vertex> vertices;
    std::vector<bool> bad; // no place to be drawn at
    bool normals = false;
    bool tangents = false;
};

struct Primitive {
    int shape = -1; // into the shapes; those with the same accessors share one
    Triangles triangles;
    int material = 0;
};

class Reader {
public:
    Reader(const tinygltf::Model& model, Accessors& accessors, Materials& materials, Notes& notes)
        : m_model{model}, m_accessors{accessors}, m_materials{materials}, m_notes{notes},
          m_quantized{std::find(model.extensionsUsed.begin(), model.extensionsUsed.end(), "KHR_mesh_quantization") !=
                      model.extensionsUsed.end()}
    {
    }

    std::vector<Shape> shapes;

    std::vector<Primitive> mesh(int number)
    {
        std::vector<Primitive> result;
        const auto& primitives = m_model.meshes[std::size_t(number)].primitives;
        for (std::size_t i = 0; i < primitives.size(); ++i) {
            const std::string place = "meshes[" + std::to_string(number) + "].primitives[" + std::to_string(i) + "]";
            if (++m_count > kMostPrimitives) throw Refused{"over 200000 primitives"};
            if (auto primitive = read(primitives[i], place)) result.push_back(std::move(*primitive));
        }
        return result;
    }

private:
    std::optional<Primitive> read(const tinygltf::Primitive& source, const std::string& place)
    {
        const int mode = source.mode;
        if (mode < 0 || mode > TINYGLTF_MODE_TRIANGLE_FAN)
            throw Refused{place + ".mode: " + std::to_string(mode) + " is unknown"};
        if (!source.attributes.contains("POSITION")) {
            m_notes.warn(place + ": has no positions; left out");
            return std::nullopt;
        }
        Primitive result;
        result.shape = shapeOf(source, place);
        if (mode < TINYGLTF_MODE_TRIANGLES) {
            m_notes.warn(place + ": points and lines are not drawn; left out");
            return std::nullopt;
        }
        if (!source.targets.empty()) m_notes.warn(place + ": its morph targets are left out");
        result.triangles = triangles(source, mode, shapes[std::size_t(result.shape)], place);
        if (result.triangles.empty()) return std::nullopt;
        result.material = m_materials.use(source.material);
        return result;
    }
    Triangles triangles(const tinygltf::Primitive& source, int mode, const Shape& shape, const std::string& place)
    {
        std::vector<std::uint32_t> indices;
        if (source.indices >= 0)
            indices = m_accessors.indices(source.indices);
        else
            for (std::uint32_t i = 0; i < shape.vertices.size(); ++i)
                indices.push_back(i);
        if (std::any_of(indices.begin(), indices.end(), [&](std::uint32_t i) { return i >= shape.vertices.size(); }))
            throw Refused{place + ": an index is past the last vertex"};
        Triangles all = unrolled(std::move(indices), mode);
        if (all.size() < 3) m_notes.warn(place + ": holds no triangles; left out");
        if (all.size() % 3 != 0) m_notes.warn(place + ": ends inside a triangle; that one is left out");
        Triangles kept;
        kept.reserve(all.size());
        for (std::size_t i = 0; i + 2 < all.size(); i += 3)
            if (!shape.bad[all[i]] && !shape.bad[all[i + 1]] && !shape.bad[all[i + 2]])
                kept.insert(kept.end(), all.begin() + std::ptrdiff_t(i), all.begin() + std::ptrdiff_t(i) + 3);
        if (kept.size() < all.size() / 3 * 3)
            m_notes.warn(place + ": triangles with infinite or far-off corners are left out");
        return kept;
    }
    int shapeOf(const tinygltf::Primitive& source, const std::string& place)
    {
        const auto [found, isNew] = m_shapeOf.try_emplace(source.attributes, int(shapes.size()));
        if (isNew) shapes.push_back(readShape(source.attributes, place));
        return found->second;
    }
    Shape readShape(const std::map<std::string, int>& attributes, const std::string& place)
    {
        Shape shape;
        const int position = attributes.at("POSITION");
        const Rows& positions = m_accessors.rows(position, {.types = {TINYGLTF_TYPE_VEC3}, .onlyFloat = !m_quantized});
        m_bytes += positions.size() * sizeof(Vertex);
        if (m_bytes > kMostBytes / 2) throw Refused{"its vertices take over 1 GiB; make it simpler"};
        shape.vertices.resize(positions.size());
        shape.bad.resize(positions.size());
        for (std::size_t i = 0; i < positions.size(); ++i) {
            shape.bad[i] = !near(glm::vec3{positions[i]});
            if (!shape.bad[i]) shape.vertices[i].position = glm::vec3{positions[i]};
        }
        const auto each = [&](const char* name, std::vector<int> types, auto set) {
            const auto found = attributes.find(name);
            if (found == attributes.end()) return false;
            const Rows& rows = m_accessors.rows(found->second, {.types = types});
            if (rows.size() != positions.size())
                throw Refused{place + "." + name + ": differs from POSITION in its count"};
            const bool opaque = m_model.accessors[std::size_t(found->second)].type == TINYGLTF_TYPE_VEC3;
            for (std::size_t i = 0; i < rows.size(); ++i)
                set(shape.vertices[i], opaque ? glm::vec4{glm::vec3{rows[i]}, 1} : rows[i]);
            return true;
        };
        shape.normals =
            each("NORMAL", {TINYGLTF_TYPE_VEC3}, [](Vertex& v, const glm::vec4& row) { v.normal = glm::vec3{row}; });
        shape.tangents =
            each("TANGENT", {TINYGLTF_TYPE_VEC4}, [](Vertex& v, const glm::vec4& row) { v.tangent = row; });
        each("TEXCOORD_0", {TINYGLTF_TYPE_VEC2},
             [](Vertex& v, const glm::vec4& row) { v.uv0 = finite(row) ? glm::vec2{row} : glm::vec2{0}; });
        each("TEXCOORD_1", {TINYGLTF_TYPE_VEC2},
             [](Vertex& v, const glm::vec4& row) { v.uv1 = finite(row) ? glm::vec2{row} : glm::vec2{0}; });
        each("COLOR_0", {TINYGLTF_TYPE_VEC3, TINYGLTF_TYPE_VEC4}, [](Vertex& v, const glm::vec4& row) {
            if (finite(row)) v.colour = glm::u8vec4{glm::round(glm::clamp(row, 0.0f, 1.0f) * 255.0f)};
        });
        return shape;
    }

    const tinygltf::Model& m_model;
    Accessors& m_accessors;
    Materials& m_materials;
    Notes& m_notes;
    bool m_quantized;
    std::map<std::map<std::string, int>, int> m_shapeOf;
    std::size_t m_count = 0;
    std::uint64_t m_bytes = 0;
};

// Adds copies of shapes to the model, turned into its space.
class Baker {
public:
    Baker(const std::vector<Shape>& shapes, Model& model) : m_shapes{shapes}, m_model{model} {}

    std::vector<Triangles> byMaterial;
    ShadingFrames frames; // which vertices still need a normal or a tangent

    void add(const std::vector<Primitive>& primitives, const glm::dmat4& modelFromMesh)
    {
        std::map<int, std::uint32_t> firstOf; // of the shapes that this copy of the mesh has added already
        const bool mirrored = glm::determinant(glm::dmat3{modelFromMesh}) < 0;
        for (const Primitive& primitive : primitives) {
            const Shape& shape = m_shapes[std::size_t(primitive.shape)];
            if (byMaterial.size() <= std::size_t(primitive.material))
                byMaterial.resize(std::size_t(primitive.material) + 1);
            Triangles& out = byMaterial[std::size_t(primitive.material)];
            if (shape.normals) {
                const auto [first, isNew] =
                    firstOf.try_emplace(primitive.shape, std::uint32_t(m_model.vertices.size()));
                if (isNew) addVertices(shape, modelFromMesh);
                append(out, primitive.triangles, first->second, mirrored);
            } else { // flat: no two triangles share a corner
                const auto first = std::uint32_t(m_model.vertices.size());
                addCorners(shape, primitive.triangles, modelFromMesh);
                Triangles own(primitive.triangles.size());
                for (std::uint32_t i = 0; i < own.size(); ++i)
                    own[i] = i;
                append(out, own, first, mirrored);
            }
        }
    }

private:
    static void append(Triangles& out, const Triangles& triangles, std::uint32_t first, bool mirrored)
    {
        for (std::size_t i = 0; i + 2 < triangles.size(); i += 3)
            for (const std::size_t corner : {0, mirrored ? 2 : 1, mirrored ? 1 : 2})
                out.push_back(first + triangles[i + corner]);
    }
    void addVertices(const Shape& shape, const glm::dmat4& matrix)
    {
        for (const Vertex& vertex : shape.vertices)
            addVertex(vertex, matrix, shape.normals, shape.tangents);
    }
    void addCorners(const Shape& shape, const Triangles& corners, const glm::dmat4& matrix)
    {
        for (const std::uint32_t corner : corners)
            addVertex(shape.vertices[corner], matrix, false, false); // a given tangent needs a given normal
    }
    void addVertex(Vertex vertex, const glm::dmat4& matrix, bool normal, bool tangent)
    {
        const glm::dmat3 linear{matrix};
        const double side = glm::determinant(linear) < 0 ? -1 : 1;
        // Normals turn with the matrix of cofactors, which unlike the inverse exists for flat shapes too.
        const glm::dmat3 cofactors{glm::cross(linear[1], linear[2]), glm::cross(linear[2], linear[0]),
                                   glm::cross(linear[0], linear[1])};
        vertex.position = glm::vec3{glm::dvec3{matrix * glm::dvec4{vertex.position, 1}}};
        const glm::vec3 turned{side * (cofactors * glm::dvec3{vertex.normal})};
        const glm::vec3 along{linear * glm::dvec3{vertex.tangent}};
        const float hand = float(side) * (vertex.tangent.w < 0 ? -1.0f : 1.0f);
        const bool normalKept = normal && setUnit(vertex.normal, turned);
        glm::vec3 unitTangent{0};
        const bool tangentKept = normalKept && tangent && setUnit(unitTangent, along);
        if (tangentKept) vertex.tangent = {unitTangent, hand};
        m_model.vertices.push_back(vertex);
        frames.needsNormal.push_back(!normalKept);
        frames.needsTangent.push_back(!tangentKept);
    }

    const std::vector<Shape>& m_shapes;
    Model& m_model;
};

// What the baked model will take, counted before any of it is made.
std::uint64_t bytesOf(const std::vector<Primitive>& primitives, const std::vector<Shape>& shapes)
{
    std::set<int> counted;
    std::uint64_t bytes = 0;
    for (const Primitive& primitive : primitives) {
        const Shape& shape = shapes[std::size_t(primitive.shape)];
        bytes += primitive.triangles.size() * sizeof(std::uint32_t);
        if (!shape.normals)
            bytes += primitive.triangles.size() * sizeof(Vertex);
        else if (counted.insert(primitive.shape).second)
            bytes += shape.vertices.size() * sizeof(Vertex);
    }
    return bytes;
}

// Matrices may carry corners away that were near in their own mesh.
void leaveOutFar(const Model& model, Triangles& triangles, Notes& notes)
{
    const auto drawable = [&](std::uint32_t index) { return near(model.vertices[index].position); };
    std::size_t kept = 0;
    for (std::size_t i = 0; i + 2 < triangles.size(); i += 3) {
        if (!drawable(triangles[i]) || !drawable(triangles[i + 1]) || !drawable(triangles[i + 2])) continue;
        std::copy_n(triangles.begin() + std::ptrdiff_t(i), 3, triangles.begin() + std::ptrdiff_t(kept));
        kept += 3;
    }
    if (kept < triangles.size()) notes.warn("nodes: triangles that their matrices carry over 1e9 m away are left out");
    triangles.resize(kept);
}

void addParts(Model& model, std::vector<Triangles> byMaterial, Notes& notes)
{
    for (std::size_t material = 0; material < byMaterial.size(); ++material) {
        Triangles& triangles = byMaterial[material];
        leaveOutFar(model, triangles, notes);
        if (triangles.empty()) continue;
        model.parts.push_back({std::uint32_t(model.indices.size()), std::uint32_t(triangles.size()), int(material)});
        model.indices.insert(model.indices.end(), triangles.begin(), triangles.end());
    }
    for (const std::uint32_t index : model.indices)
        model.bounds.add(model.vertices[index].position);
}

} // namespace

void bake(const tinygltf::Model& source, const std::vector<PlacedMesh>& placed, Accessors& accessors,
          Materials& materials, Notes& notes, Model& result)
{
    Reader reader{source, accessors, materials, notes};
    std::map<int, std::vector<Primitive>> meshes;
    std::uint64_t bytes = 0;
    for (const PlacedMesh& one : placed) {
        auto [mesh, isNew] = meshes.try_emplace(one.mesh);
        if (isNew) mesh->second = reader.mesh(one.mesh);
        bytes += bytesOf(mesh->second, reader.shapes);
        if (bytes > kMostBytes) throw Refused{"its triangles take over 2 GiB; make it simpler"};
    }
    Baker baker{reader.shapes, result};
    for (const PlacedMesh& one : placed)
        baker.add(meshes.at(one.mesh), one.modelFromMesh);
    result.materials = std::move(materials.list);
    result.images = std::move(materials.images);
    addParts(result, std::move(baker.byMaterial), notes);
    complete(result, baker.frames);
}

} // namespace io::gltf
