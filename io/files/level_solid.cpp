#include "io/files/level_solid.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <meshoptimizer.h>

namespace io::levels {
namespace {

constexpr std::uint32_t kNone = ~0u;
constexpr std::size_t kSamples = 4000;      // of each surface whose distance is measured
constexpr std::size_t kLargeModel = 50'000; // triangles; from here on time matters more than the last of quality
constexpr float kStuck = 1.3f;              // so many times the wanted triangles: the topology holds more back
constexpr float kSloppyError = 0.06f;       // of the model's size: beyond it, no level is better than a sloppy one
constexpr float kThickestDropped = 0.04f;   // of the model's size
constexpr float kSeenInCrown = 0.3f;        // what leaves leave to see of an error among them
constexpr float kUnsampled = 1.1f;          // what may lie between the samples

// Points spread over a surface: a grid of barycentric coordinates in each triangle, finer in few triangles.
template <class Use> void samplePoints(std::span<const SurfaceDistance::Triangle> triangles, Use use)
{
    if (triangles.empty()) return;
    const std::size_t stride = (triangles.size() + kSamples - 1) / kSamples;
    int n = 1; // intervals along an edge
    while (n < 12 && std::size_t((n + 2) * (n + 3) / 2) * triangles.size() <= kSamples)
        ++n;
    for (std::size_t i = 0; i < triangles.size(); i += stride) {
        const SurfaceDistance::Triangle& t = triangles[i];
        for (int a = 0; a <= n; ++a)
            for (int b = 0; a + b <= n; ++b)
                use(i, t[0] + ((t[1] - t[0]) * float(a) + (t[2] - t[0]) * float(b)) / float(n));
        use(i, (t[0] + t[1] + t[2]) * (1.0f / 3));
    }
}

std::vector<SurfaceDistance::Triangle> surfaceOf(const Model& model, std::span<const Corners> triangles)
{
    std::vector<SurfaceDistance::Triangle> result;
    result.reserve(triangles.size());
    for (const Corners& corners : triangles)
        result.push_back(positionsOf(model, corners));
    return result;
}

bool holds(const Box& box, const glm::vec3& point)
{
    return glm::all(glm::greaterThanEqual(point, box.min)) && glm::all(glm::lessThanEqual(point, box.max));
}

struct Component {
    glm::vec3 min{std::numeric_limits<float>::max()};
    glm::vec3 max{std::numeric_limits<float>::lowest()};
    float area = 0;
    // Area over length: the width of a sheet, three times that of a rod or a ball.
    float thickness() const { return area / std::max(glm::length(max - min), 1e-9f); }
};

// By triangle, in m.
std::vector<float> thicknesses(const Model& model, std::span<const Corners> triangles,
                               std::span<const std::uint32_t> places, const Box& crown)
{
    const std::vector<std::uint32_t> component = componentsOf(triangles, places, Joined::AtVertices);
    std::vector<Component> components(component.empty() ? 0 : *std::max_element(component.begin(), component.end()) + 1);
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        const SurfaceDistance::Triangle t = positionsOf(model, triangles[i]);
        Component& own = components[component[i]];
        own.area += areaOf(t);
        for (const glm::vec3& corner : t) {
            own.min = glm::min(own.min, corner);
            own.max = glm::max(own.max, corner);
        }
    }
    std::vector<float> result;
    result.reserve(triangles.size());
    for (const std::uint32_t number : component) {
        const Component& own = components[number];
        result.push_back(own.thickness() * (holds(crown, own.min) && holds(crown, own.max) ? kSeenInCrown : 1.0f));
    }
    return result;
}

void sortByPart(std::vector<Corners>& triangles)
{
    std::stable_sort(triangles.begin(), triangles.end(),
                     [](const Corners& a, const Corners& b) { return a.part < b.part; });
}

} // namespace

Solid::Solid(const Model& model, std::span<const std::uint32_t> places, const Foliage& foliage)
    : m_places{places.begin(), places.end()}, m_crown{foliage.crown()}
{
    for (std::uint32_t part = 0; part < model.parts.size(); ++part) {
        if (foliage.holds(part)) continue;
        const std::vector<Corners> triangles = drawnTriangles(model, part);
        m_full.insert(m_full.end(), triangles.begin(), triangles.end());
    }
    if (m_full.empty()) return;
    m_thickness.assign(places.size(), 0);
    const std::vector<float> thickness = thicknesses(model, m_full, places, m_crown);
    glm::vec3 low{std::numeric_limits<float>::max()}, high{std::numeric_limits<float>::lowest()};
    for (std::size_t i = 0; i < m_full.size(); ++i)
        for (const std::uint32_t vertex : m_full[i].vertex) {
            m_thickness[places[vertex]] = thickness[i];
            low = glm::min(low, model.vertices[vertex].position);
            high = glm::max(high, model.vertices[vertex].position);
        }
    m_sorted = thickness;
    std::sort(m_sorted.begin(), m_sorted.end());
    m_size = std::max({high.x - low.x, high.y - low.y, high.z - low.z});
    std::vector<SurfaceDistance::Triangle> surface = surfaceOf(model, m_full);
    samplePoints(surface, [&](std::size_t triangle, const glm::vec3& point) {
        m_samples.push_back(point);
        m_sampleThickness.push_back(thickness[triangle]);
    });
    m_surface.emplace(std::move(surface));
    m_equal = welded(model, Weld::Equal);
}

// Corners of two parts stay two vertices at one place: a seam, which meshoptimizer collapses on both sides alike.
Solid::Mesh Solid::welded(const Model& model, Weld weld) const
{
    struct Key {
        Vertex vertex;
        std::uint32_t part;
    };
    static_assert(sizeof(Key) == 64, "hashed as bytes: no padding");
    std::vector<Key> corners;
    corners.reserve(m_full.size() * 3);
    for (const Corners& triangle : m_full)
        for (const std::uint32_t vertex : triangle.vertex) {
            Key key{model.vertices[vertex], triangle.part};
            key.vertex.position = key.vertex.position + 0.0f; // -0 becomes 0
            if (weld != Weld::Equal) {
                key.vertex.normal = {};
                key.vertex.tangent = {};
            }
            if (weld == Weld::Positions) key.vertex = {.position = key.vertex.position};
            corners.push_back(key);
        }
    Mesh mesh;
    mesh.indices.resize(corners.size());
    const std::size_t count = meshopt_generateVertexRemap(mesh.indices.data(), nullptr, corners.size(), corners.data(),
                                                          corners.size(), sizeof(Key));
    mesh.positions.resize(count);
    mesh.vertexOf.resize(count);
    mesh.partOf.resize(count);
    for (std::size_t i = corners.size(); i-- > 0;) { // the first of the equal ones has the last word
        const std::uint32_t own = mesh.indices[i];
        mesh.positions[own] = corners[i].vertex.position;
        mesh.vertexOf[own] = m_full[i / 3].vertex[i % 3];
        mesh.partOf[own] = corners[i].part;
    }
    return mesh;
}

Piece Solid::simplified(Model& model, float share, float freeError)
{
    Piece best;
    if (m_full.empty()) return best;
    const auto wanted = std::size_t(std::ceil(share * float(m_full.size())));
    best = leastError(model, m_equal, wanted, freeError, false);
    if (float(best.triangles.size()) <= kStuck * float(wanted)) return best;

    if (!m_normals) {
        m_normals = welded(model, Weld::Normals);
        m_meanVertices.assign(m_normals->vertexOf.size(), kNone);
        m_meanNormals.assign(m_normals->vertexOf.size(), glm::vec3{0});
        for (std::size_t i = 0; i < m_normals->indices.size(); ++i)
            m_meanNormals[m_normals->indices[i]] += model.vertices[m_full[i / 3].vertex[i % 3]].normal;
    }
    if (m_normals->vertexOf.size() < m_equal.vertexOf.size()) {
        Piece merged = leastError(model, *m_normals, wanted, freeError, true);
        if (float(merged.triangles.size()) < 0.8f * float(best.triangles.size())) best = std::move(merged);
    }
    if (float(best.triangles.size()) <= kStuck * float(wanted)) return best;

    Piece rough = sloppy(model, m_equal, share);
    if (!rough.triangles.empty() && float(rough.triangles.size()) < 0.6f * float(best.triangles.size()) &&
        rough.error <= kSloppyError * m_size)
        best = std::move(rough);
    return best;
}

// Fewer triangles come from coarser components or from fewer of them: tries how many to drop beforehand.
Piece Solid::leastError(Model& model, const Mesh& mesh, std::size_t wanted, float freeError, bool mergedNormals)
{
    std::vector<float> limits{freeError};
    if (m_full.size() <= kLargeModel && m_sorted.front() < m_sorted.back())
        for (const float share : {0.25f, 0.5f, 0.75f, 0.9f}) {
            const float limit = m_sorted[std::size_t(share * float(m_sorted.size()))];
            if (limit > limits.back() && limit < std::min(kThickestDropped * m_size, m_sorted.back()))
                limits.push_back(limit);
        }
    Piece best;
    for (const float limit : limits) {
        Piece piece = reduced(model, mesh, wanted, limit, mergedNormals);
        dropThin(model, piece, limit, wanted);
        const bool enough = float(piece.triangles.size()) <= kStuck * float(wanted);
        const bool bestEnough = float(best.triangles.size()) <= kStuck * float(wanted);
        if (best.triangles.empty() || (enough && !bestEnough) || (enough == bestEnough && piece.error < best.error))
            best = std::move(piece);
    }
    return best;
}

Piece Solid::reduced(Model& model, const Mesh& mesh, std::size_t triangles, float droppedTo, bool mergedNormals)
{
    std::vector<std::uint32_t> source, indices(mesh.indices.size());
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3)
        if (thicknessAt(mesh.vertexOf[mesh.indices[i]]) > std::min(droppedTo, m_sorted.back() * 0.999f))
            source.insert(source.end(), mesh.indices.begin() + std::ptrdiff_t(i), mesh.indices.begin() + std::ptrdiff_t(i) + 3);
    const std::size_t count =
        meshopt_simplify(indices.data(), source.data(), source.size(), &mesh.positions[0].x,
                         mesh.positions.size(), sizeof(glm::vec3), std::min(triangles * 3, source.size()), 1.0f, 0, nullptr);
    Piece piece;
    for (std::size_t i = 0; i + 2 < count; i += 3) {
        Corners corners{.vertex = {}, .part = mesh.partOf[indices[i]]};
        for (std::size_t c = 0; c < 3; ++c)
            corners.vertex[c] =
                mergedNormals ? withMeanNormal(model, mesh, indices[i + c]) : mesh.vertexOf[indices[i + c]];
        piece.triangles.push_back(corners);
    }
    sortByPart(piece.triangles);
    return piece;
}

std::uint32_t Solid::withMeanNormal(Model& model, const Mesh& mesh, std::uint32_t index)
{
    std::uint32_t& made = m_meanVertices[index];
    if (made != kNone) return made;
    Vertex vertex = model.vertices[mesh.vertexOf[index]];
    const float length = glm::length(m_meanNormals[index]);
    if (length > 1e-3f) {
        vertex.normal = m_meanNormals[index] / length;
        const glm::vec3 along = glm::vec3{vertex.tangent} - vertex.normal * glm::dot(vertex.normal, glm::vec3{vertex.tangent});
        if (glm::length(along) > 1e-3f) vertex.tangent = {glm::normalize(along), vertex.tangent.w};
    }
    made = std::uint32_t(model.vertices.size());
    model.vertices.push_back(vertex);
    m_places.resize(model.vertices.size(), 0); // foliage adds vertices too
    m_places.back() = m_places[mesh.vertexOf[index]];
    return made;
}

// Each part for itself, on one grid: what the topology of the parts forbids.
Piece Solid::sloppy(const Model& model, const Mesh& mesh, float share) const
{
    Piece piece;
    std::vector<std::uint32_t> own, made;
    std::vector<std::uint32_t> parts = mesh.partOf;
    std::sort(parts.begin(), parts.end());
    parts.erase(std::unique(parts.begin(), parts.end()), parts.end());
    for (const std::uint32_t part : parts) {
        own.clear();
        for (std::size_t i = 0; i < mesh.indices.size(); i += 3)
            if (mesh.partOf[mesh.indices[i]] == part)
                own.insert(own.end(), mesh.indices.begin() + std::ptrdiff_t(i), mesh.indices.begin() + std::ptrdiff_t(i) + 3);
        made.resize(own.size());
        const auto wanted = std::size_t(share * float(own.size() / 3)) * 3;
        const std::size_t count =
            meshopt_simplifySloppy(made.data(), own.data(), own.size(), &mesh.positions[0].x, mesh.positions.size(),
                                   sizeof(glm::vec3), wanted, kSloppyError, nullptr);
        for (std::size_t i = 0; i + 2 < count; i += 3)
            piece.triangles.push_back(
                {{mesh.vertexOf[made[i]], mesh.vertexOf[made[i + 1]], mesh.vertexOf[made[i + 2]]}, part});
    }
    piece.error = piece.triangles.empty() ? 0 : measured(model, piece, 0);
    return piece;
}

// Drops components thinner than `thickness`, or than the error that is there anyway; and thicker ones, thinnest first,
// while more than so many triangles are left.
void Solid::dropThin(const Model& model, Piece& piece, float thickness, std::size_t triangles) const
{
    const auto thicknessOf = [&](const Corners& corners) { return thicknessAt(corners.vertex[0]); };
    std::vector<float> thin;
    for (const Corners& corners : piece.triangles)
        thin.push_back(thicknessOf(corners));
    std::sort(thin.begin(), thin.end());
    float limit = thickness;
    if (thin.size() > triangles)
        limit = std::max(limit, std::min(thin[thin.size() - triangles - 1], kThickestDropped * m_size));
    limit = std::min(limit, m_sorted.back() * 0.999f); // the thickest stays
    std::erase_if(piece.triangles, [&](const Corners& corners) { return thicknessOf(corners) <= limit; });
    piece.error = measured(model, piece, limit);
    const auto dropped = std::upper_bound(m_sorted.begin(), m_sorted.end(), limit);
    if (dropped != m_sorted.begin()) piece.error = std::max(piece.error, *(dropped - 1));
}

// The largest distance found from either surface to the other, but for components that were dropped.
float Solid::measured(const Model& model, const Piece& piece, float droppedBelow) const
{
    if (piece.triangles.empty()) return m_size;
    std::vector<SurfaceDistance::Triangle> own = surfaceOf(model, piece.triangles);
    float farthest = 0;
    const auto add = [&](const glm::vec3& point, const SurfaceDistance& other) {
        const float seen = holds(m_crown, point) ? kSeenInCrown : 1.0f;
        farthest = std::max(farthest, other.to(point, farthest / seen) * seen);
    };
    samplePoints(own, [&](std::size_t, const glm::vec3& point) { add(point, *m_surface); });
    const SurfaceDistance surface{std::move(own)};
    for (std::size_t i = 0; i < m_samples.size(); ++i)
        if (droppedBelow <= 0 || m_sampleThickness[i] > droppedBelow)
            add(m_samples[i], surface);
    return farthest * kUnsampled;
}

} // namespace io::levels
