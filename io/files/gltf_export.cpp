// The ground, or a whole world, as one glTF file.
#include "io/files/atomic_file.h"
#include "io/files/file_names.h"
#include "io/files/gltf_document.h"
#include "io/files/height_export.h"
#include "io/files/json.h"
#include "io/files/world_export.h"
#include "io/scene/instance_walk.h"

#include <algorithm>
#include <fmt/format.h>
#include <map>

namespace io {
namespace fs = std::filesystem;
namespace {

constexpr std::uint64_t kLargestFile = 0xF0000000; // bytes; the lengths in a .glb have 32 bits

// A file name as part of a URI (RFC 3986).
std::string uriOf(const std::string& name)
{
    std::string uri;
    for (const char c : name) {
        const bool letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
        const bool plain = letter || c == '-' || c == '_' || c == '.' || c == '~';
        uri += plain ? std::string{c} : fmt::format("%{:02X}", static_cast<unsigned char>(c));
    }
    return uri;
}

// .glb, or .gltf with a .bin beside it. Answers what was written.
Result<std::vector<fs::path>> write(const fs::path& file, GltfDocument& document, const std::vector<int>& roots)
{
    if (document.buffer.bytes.size() > kLargestFile)
        return Error{file.string(), "more than 4 GiB do not fit in one glTF file; ask for a larger step of the ground"};
    if (lowerExtension(file) == ".glb") {
        const Value text = document.text(roots);
        if (const Status written = writeFile(file, glbOf(text, std::move(document.buffer.bytes))); !written) return written.error();
        return std::vector{file};
    }
    fs::path beside = file;
    beside.replace_extension(".bin");
    const Value text = document.text(roots, uriOf(beside.filename().string()));
    if (const Status written = writeFile(beside, document.buffer.bytes); !written) return written.error();
    if (const Status written = writeFile(file, writeJson(text) + "\n"); !written) return written.error();
    return std::vector{file, beside};
}

std::uint64_t squares(int texels, int step)
{
    return std::uint64_t(texels - 2) / std::uint64_t(step) + 1;
}

Status checkGround(const fs::path& file, glm::ivec2 size, int step)
{
    if (meshTriangles(size, step) <= kMostTriangles) return {};
    return Error{file.string(), fmt::format("{} triangles of the ground are too many for one file; ask for a step of {} texels or more",
                                            meshTriangles(size, step), meshStep(size, kMostTriangles))};
}

template <class T> int addValues(GltfBuffer& buffer, const std::vector<T>& values, const char* type)
{
    const int view = buffer.addView(values.data(), values.size() * sizeof(T), 0);
    return buffer.addAccessor(view, kFloat, 0, values.size(), type);
}

// All copies of one mesh as one node, around their middle so that floats are exact enough.
Value nodeOf(GltfDocument& document, const std::string& name, int mesh, const std::vector<Transform>& copies)
{
    glm::dvec3 middle{0};
    for (const Transform& copy : copies)
        middle += copy.position / double(copies.size());
    std::vector<glm::vec3> places, scales;
    std::vector<glm::vec4> turns;
    for (const Transform& copy : copies) {
        const glm::dquat turn = glm::normalize(orientation(copy.rotation));
        places.emplace_back(copy.position - middle);
        turns.emplace_back(turn.x, turn.y, turn.z, turn.w);
        scales.push_back(copy.scale);
    }
    document.usesInstances = true;
    const int place = addValues(document.buffer, places, "VEC3"), turn = addValues(document.buffer, turns, "VEC4");
    const int scale = addValues(document.buffer, scales, "VEC3");
    const Value attributes = Value::Object{{"TRANSLATION", place}, {"ROTATION", turn}, {"SCALE", scale}};
    return Value::Object{{"name", name},
                         {"mesh", mesh},
                         {"translation", Value::Array{middle.x, middle.y, middle.z}},
                         {"extensions", Value::Object{{"EXT_mesh_gpu_instancing", Value::Object{{"attributes", attributes}}}}}};
}

} // namespace

std::uint64_t meshTriangles(glm::ivec2 size, int step)
{
    return squares(size.x, step) * squares(size.y, step) * 2;
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
    if (const Status possible = checkGround(file, heights.size, step); !possible) return possible.error();
    GltfDocument document;
    const GroundNodes ground = addGround(document, heights, cover, terrain, step);
    if (ground.root < 0) return Error{file.string(), "all of the ground is a hole; there is nothing to write"};
    Result<std::vector<fs::path>> written = write(file, document, {ground.root});
    if (!written) return written.error();
    return MeshExport{.written = *std::move(written), .step = step, .tiles = ground.tiles, .triangles = ground.triangles};
}

Result<WorldExport> exportWorld(const fs::path& file, const Scene& scene, const Assets& assets, int step)
{
    if (!exportsMesh(file)) return Error{file.string(), "a world is written as .glb or .gltf"};
    WorldExport done;
    GltfDocument document;
    std::vector<int> roots;
    if (scene.heights()) {
        done.step = step > 0 ? step : meshStep(scene.heights()->size);
        if (const Status possible = checkGround(file, scene.heights()->size, done.step); !possible) return possible.error();
        const GroundNodes ground = addGround(document, *scene.heights(), scene.cover().get(), scene.terrain(), done.step);
        if (ground.root >= 0) roots.push_back(ground.root);
        done.groundTriangles = ground.triangles;
    }
    std::map<TemplateId, std::vector<Transform>> copies;
    const auto add = [&](TemplateId id, const Transform& transform) {
        const Template* shown = scene.find(id);
        if (shown && !shown->model.empty() && assets.model(id)) copies[id].push_back(transform);
        else done.leftOut += id != TemplateId::None;
    };
    for (const ObjectId id : scene.sortedIds()) // the same world is the same file
        add(scene.at(id).templateId, scene.at(id).transform);
    eachTile(scene, [&](const LayerTile& at) {
        eachInstance(scene, at, [&](ObjectId, TemplateId id, const Transform& transform) { add(id, transform); });
    });
    for (const auto& [id, transforms] : copies) {
        const Model& model = *assets.model(id);
        const Result<int> mesh = document.addMesh(model);
        if (!mesh) return Error{file.string(), scene.find(id)->model + ": " + mesh.error().what};
        roots.push_back(int(document.nodes.size()));
        document.nodes.push_back(nodeOf(document, std::string{scene.templateName(id)}, *mesh, transforms));
        done.instances += transforms.size();
    }
    if (roots.empty()) return Error{file.string(), "this scene has neither ground nor models; there is nothing to write"};
    Result<std::vector<fs::path>> written = write(file, document, roots);
    if (!written) return written.error();
    done.written = *std::move(written);
    done.models = copies.size();
    return done;
}

} // namespace io
