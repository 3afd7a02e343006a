#include "io/files/gltf_nodes.h"

#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>

#include <algorithm>
#include <cmath>
#include <optional>

namespace io::gltf {
namespace {

constexpr double kFarthest = 1e9; // m
constexpr std::size_t kMostPlaced = 1'000'000;

std::string placeOf(int node)
{
    return "nodes[" + std::to_string(node) + "]";
}

bool sound(const glm::dmat4& matrix)
{
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 4; ++row)
            if (!(std::abs(matrix[column][row]) <= kFarthest)) return false; // NaN too
    return true;
}

std::optional<glm::dmat4> fromMatrix(const std::vector<double>& numbers)
{
    glm::dmat4 matrix{1};
    for (int i = 0; i < 16; ++i)
        matrix[i / 4][i % 4] = numbers[std::size_t(i)];
    for (int column = 0; column < 4; ++column)
        if (matrix[column][3] != (column == 3 ? 1 : 0)) return std::nullopt; // a perspective has no place here
    return matrix;
}

glm::dmat4 fromParts(const glm::dvec3& translation, const glm::dquat& rotation, const glm::dvec3& scale)
{
    return glm::translate(glm::dmat4{1}, translation) * glm::mat4_cast(rotation) * glm::scale(glm::dmat4{1}, scale);
}

bool has(const std::vector<double>& numbers, std::size_t count, const char* name, int node, Notes& notes)
{
    if (numbers.empty() || numbers.size() == count) return !numbers.empty();
    notes.warn(placeOf(node) + "." + name + ": must be " + std::to_string(count) + " numbers; left out");
    return false;
}

// A rotation that is no unit quaternion is made one; zero turns nothing.
std::optional<glm::dquat> unit(const glm::dvec4& xyzw)
{
    const double length = glm::length(xyzw);
    if (!std::isfinite(length) || length < 1e-6) return std::nullopt;
    return glm::dquat{xyzw.w / length, xyzw.x / length, xyzw.y / length, xyzw.z / length};
}

glm::dmat4 parentFromNode(const tinygltf::Node& node, int number, Notes& notes)
{
    std::optional<glm::dmat4> matrix;
    if (has(node.matrix, 16, "matrix", number, notes)) {
        matrix = fromMatrix(node.matrix);
    } else {
        glm::dvec3 translation{0}, scale{1};
        std::optional<glm::dquat> rotation = glm::dquat{1, 0, 0, 0};
        if (has(node.translation, 3, "translation", number, notes))
            translation = {node.translation[0], node.translation[1], node.translation[2]};
        if (has(node.scale, 3, "scale", number, notes)) scale = {node.scale[0], node.scale[1], node.scale[2]};
        if (has(node.rotation, 4, "rotation", number, notes))
            rotation = unit({node.rotation[0], node.rotation[1], node.rotation[2], node.rotation[3]});
        if (!rotation) notes.warn(placeOf(number) + ".rotation: is no rotation; left out");
        matrix = fromParts(translation, rotation.value_or(glm::dquat{1, 0, 0, 0}), scale);
    }
    if (matrix && sound(*matrix)) return *matrix;
    notes.warn(placeOf(number) + ": its place is infinite or over 1e9 m away; left out");
    return glm::dmat4{1};
}

// The parent of each node, -1 for none. Every node has at most one, and none is its own ancestor.
std::vector<int> parents(const tinygltf::Model& model)
{
    const int count = int(model.nodes.size());
    std::vector<int> parent(model.nodes.size(), -1);
    for (int node = 0; node < count; ++node) {
        for (const int child : model.nodes[std::size_t(node)].children) {
            if (child < 0 || child >= count)
                throw Refused{placeOf(node) + ": there is no node " + std::to_string(child)};
            if (parent[std::size_t(child)] >= 0) throw Refused{placeOf(child) + ": has two parents"};
            parent[std::size_t(child)] = node;
        }
    }
    std::vector<int> seenFrom(model.nodes.size(), -1);
    for (int node = 0; node < count; ++node) {
        int up = node;
        for (; up >= 0 && seenFrom[std::size_t(up)] < 0; up = parent[std::size_t(up)])
            seenFrom[std::size_t(up)] = node;
        if (up >= 0 && seenFrom[std::size_t(up)] == node) throw Refused{placeOf(up) + ": is its own ancestor"};
    }
    return parent;
}

std::vector<int> roots(const tinygltf::Model& model, const std::vector<int>& parent, Notes& notes)
{
    std::vector<int> result;
    std::vector<bool> taken(parent.size());
    if (model.scenes.empty()) {
        for (int node = 0; node < int(parent.size()); ++node)
            if (parent[std::size_t(node)] < 0) result.push_back(node);
        return result;
    }
    int scene = std::max(model.defaultScene, 0);
    if (scene >= int(model.scenes.size())) {
        notes.warn("scene: there is no scene " + std::to_string(scene) + "; the first is taken");
        scene = 0;
    }
    for (const int node : model.scenes[std::size_t(scene)].nodes) {
        if (node < 0 || node >= int(parent.size()))
            throw Refused{"scenes[" + std::to_string(scene) + "]: there is no node " + std::to_string(node)};
        if (parent[std::size_t(node)] >= 0) throw Refused{placeOf(node) + ": is a root and a child"};
        if (!taken[std::size_t(node)]) result.push_back(node);
        taken[std::size_t(node)] = true;
    }
    return result;
}

const tinygltf::Value* instancing(const tinygltf::Node& node)
{
    const auto found = node.extensions.find("EXT_mesh_gpu_instancing");
    if (found == node.extensions.end() || !found->second.IsObject() || !found->second.Has("attributes")) return nullptr;
    const tinygltf::Value& attributes = found->second.Get("attributes");
    return attributes.IsObject() ? &attributes : nullptr;
}

const Rows* instanceRows(const tinygltf::Value& attributes, const char* name, int type, Accessors& accessors)
{
    if (!attributes.Has(name) || !attributes.Get(name).IsInt()) return nullptr;
    return &accessors.rows(attributes.Get(name).GetNumberAsInt(), {.types = {type}});
}

std::vector<glm::dmat4> instances(const tinygltf::Value& attributes, int node, Accessors& accessors, Notes& notes)
{
    const Rows* translations = instanceRows(attributes, "TRANSLATION", TINYGLTF_TYPE_VEC3, accessors);
    const Rows* rotations = instanceRows(attributes, "ROTATION", TINYGLTF_TYPE_VEC4, accessors);
    const Rows* scales = instanceRows(attributes, "SCALE", TINYGLTF_TYPE_VEC3, accessors);
    std::optional<std::size_t> count;
    for (const Rows* rows : {translations, rotations, scales}) {
        if (rows && count && rows->size() != *count) throw Refused{placeOf(node) + ": its instances differ in number"};
        if (rows) count = rows->size();
    }
    if (count.value_or(0) > kMostPlaced) throw Refused{placeOf(node) + ": over a million instances"};
    std::vector<glm::dmat4> result;
    std::size_t bad = 0;
    for (std::size_t i = 0; i < count.value_or(0); ++i) {
        const auto rotation = rotations ? unit((*rotations)[i]) : glm::dquat{1, 0, 0, 0};
        const glm::dmat4 matrix =
            fromParts(translations ? glm::dvec3{(*translations)[i]} : glm::dvec3{0},
                      rotation.value_or(glm::dquat{1, 0, 0, 0}), scales ? glm::dvec3{(*scales)[i]} : glm::dvec3{1});
        if (rotation && sound(matrix))
            result.push_back(matrix);
        else
            ++bad;
    }
    if (bad > 0) notes.warn(placeOf(node) + ": " + std::to_string(bad) + " instances stand nowhere; left out");
    return result;
}

struct Visit {
    int node;
    glm::dmat4 modelFromParent;
};

} // namespace

std::vector<PlacedMesh> placedMeshes(const tinygltf::Model& model, Accessors& accessors, Notes& notes)
{
    for (std::size_t i = 0; i < model.nodes.size(); ++i)
        if (const int mesh = model.nodes[i].mesh; mesh >= int(model.meshes.size()))
            throw Refused{placeOf(int(i)) + ": there is no mesh " + std::to_string(mesh)};
    const std::vector<int> first = roots(model, parents(model), notes);
    std::vector<Visit> open;
    for (auto node = first.rbegin(); node != first.rend(); ++node)
        open.push_back({*node, glm::dmat4{1}});

    std::vector<PlacedMesh> placed;
    while (!open.empty()) {
        const Visit visit = open.back();
        open.pop_back();
        const tinygltf::Node& node = model.nodes[std::size_t(visit.node)];
        glm::dmat4 modelFromNode = visit.modelFromParent * parentFromNode(node, visit.node, notes);
        if (!sound(modelFromNode)) throw Refused{placeOf(visit.node) + ": stands over 1e9 m away"};
        if (node.mesh >= 0 && node.skin >= 0)
            notes.warn(placeOf(visit.node) + ": its skin is left out; shown as modelled");
        if (const tinygltf::Value* attributes = node.mesh >= 0 ? instancing(node) : nullptr) {
            for (const glm::dmat4& nodeFromInstance : instances(*attributes, visit.node, accessors, notes))
                placed.push_back({node.mesh, modelFromNode * nodeFromInstance});
        } else if (node.mesh >= 0) {
            placed.push_back({node.mesh, modelFromNode});
        }
        if (placed.size() > kMostPlaced) throw Refused{"over a million instances"};
        for (auto child = node.children.rbegin(); child != node.children.rend(); ++child)
            open.push_back({*child, modelFromNode});
    }
    return placed;
}

} // namespace io::gltf
