#include "editor/ray_scene.h"

#include "editor/alpha_test.h"
#include "io/base/contract.h"
#include "io/base/log.h"

#include <algorithm>
#include <cmath>
#include <embree3/rtcore.h>
#include <map>
#include <unordered_map>

namespace editor {
namespace {

struct ReleaseScene {
    void operator()(RTCScene scene) const { rtcReleaseScene(scene); }
};
struct ReleaseGeometry {
    void operator()(RTCGeometry geometry) const { rtcReleaseGeometry(geometry); }
};
struct ReleaseDevice {
    void operator()(RTCDevice device) const { rtcReleaseDevice(device); }
};
using Device = std::unique_ptr<std::remove_pointer_t<RTCDevice>, ReleaseDevice>;
using Tree = std::unique_ptr<std::remove_pointer_t<RTCScene>, ReleaseScene>;
using Geometry = std::unique_ptr<std::remove_pointer_t<RTCGeometry>, ReleaseGeometry>;

// The triangles of one model, shared by all its instances. The buffers of the model are used in place.
struct Mesh {
    std::shared_ptr<const io::Model> model;
    std::vector<PartOfModel> parts;
    std::map<std::pair<const io::Image*, float>, AlphaMips> mips; // by image and cutoff; stay where they are
    Tree tree;
};

const io::Material kPlain;

// Null where no texture's alpha counts.
AlphaMips* mipsOf(Mesh& mesh, const io::Material& material)
{
    const int number = material.baseColourTexture.image;
    if (material.alphaMode == io::AlphaMode::Opaque || number < 0 || std::size_t(number) >= mesh.model->images.size())
        return nullptr;
    const auto& image = mesh.model->images[std::size_t(number)];
    if (!image) return nullptr;
    return &mesh.mips.try_emplace({image.get(), material.alphaCutoff}, image, material.alphaCutoff).first->second;
}

std::shared_ptr<Mesh> makeMesh(RTCDevice device, std::shared_ptr<const io::Model> model)
{
    auto mesh = std::make_shared<Mesh>();
    mesh->model = std::move(model);
    const io::Model& source = *mesh->model;
    mesh->tree.reset(rtcNewScene(device));
    rtcSetSceneFlags(mesh->tree.get(), RTCSceneFlags(RTC_SCENE_FLAG_ROBUST | RTC_SCENE_FLAG_CONTEXT_FILTER_FUNCTION));
    mesh->parts.reserve(source.parts.size()); // Embree keeps pointers to them
    for (const io::Part& part : source.parts) {
        if (part.indexCount < 3) continue;
        const bool known = part.material >= 0 && std::size_t(part.material) < source.materials.size();
        const io::Material& material = known ? source.materials[std::size_t(part.material)] : kPlain;
        mesh->parts.push_back({&source, &material, part.firstIndex, mipsOf(*mesh, material)});
        const Geometry geometry{rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE)};
        // Embree reads 16 bytes at each position; a Vertex is longer, so the last one is safe too.
        static_assert(sizeof(io::Vertex) >= 16 && offsetof(io::Vertex, position) == 0);
        rtcSetSharedGeometryBuffer(geometry.get(), RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, source.vertices.data(),
                                   0, sizeof(io::Vertex), source.vertices.size());
        rtcSetSharedGeometryBuffer(geometry.get(), RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, source.indices.data(),
                                   part.firstIndex * sizeof(std::uint32_t), 3 * sizeof(std::uint32_t),
                                   part.indexCount / 3);
        rtcSetGeometryUserData(geometry.get(), &mesh->parts.back());
        rtcCommitGeometry(geometry.get());
        rtcAttachGeometryByID(mesh->tree.get(), geometry.get(), unsigned(mesh->parts.size() - 1));
    }
    rtcCommitScene(mesh->tree.get());
    return mesh;
}

std::shared_ptr<const io::Model> boxAround(const io::Box& bounds)
{
    auto box = std::make_shared<io::Model>(io::boxModel(bounds.size(), glm::vec4{1}));
    for (io::Vertex& vertex : box->vertices)
        vertex.position += glm::vec3{bounds.centre().x, bounds.min.y, bounds.centre().z};
    box->bounds = bounds;
    return box;
}

// An object in the tree. Its place in the list is its number in Embree.
struct Instance {
    io::ObjectId id = io::ObjectId::None; // None: a free place
    io::TemplateId templateId = io::TemplateId::None;
    io::Transform transform;
    glm::mat3 linear{1}; // of the transform
    io::WorldBox bounds;
    Geometry geometry;
};

struct Query : RTCIntersectContext {
    const std::vector<Instance>* instances = nullptr;
    std::span<const io::ObjectId> skip;
    glm::vec3 direction{0};
    float pixelWidth = 0; // m, at 1 m
};

glm::vec3 corner(const io::Model& model, std::size_t index)
{
    return model.vertices[model.indices[index]].position;
}

// How far a pixel reaches on the triangle that was met.
PixelSteps stepsOf(const Query& query, const Instance& instance, const PartOfModel& part, std::size_t first,
                   float distance)
{
    if (query.pixelWidth <= 0 || !part.mips) return {};
    const glm::vec3 a = corner(*part.model, first);
    return pixelSteps(instance.linear * (corner(*part.model, first + 1) - a),
                      instance.linear * (corner(*part.model, first + 2) - a), query.direction,
                      query.pixelWidth * distance);
}

// Rejects hits that nobody sees: back faces, holes in leaves, and what the caller skips.
void filter(const RTCFilterFunctionNArguments* arguments)
{
    EXPECTS(arguments->N == 1);
    if (arguments->valid[0] != -1) return;
    const auto& query = *static_cast<const Query*>(arguments->context);
    const auto& part = *static_cast<const PartOfModel*>(arguments->geometryUserPtr);
    const Instance& instance = (*query.instances)[query.instID[0]];
    const std::size_t triangle = RTCHitN_primID(arguments->hit, 1, 0);
    const std::size_t first = part.firstIndex + 3 * triangle;

    bool seen = !std::ranges::binary_search(query.skip, instance.id);
    if (seen && !part.material->doubleSided) {
        // Inside an instance Embree holds the ray in the model's own space.
        const glm::vec3 direction{RTCRayN_dir_x(arguments->ray, 1, 0), RTCRayN_dir_y(arguments->ray, 1, 0),
                                  RTCRayN_dir_z(arguments->ray, 1, 0)};
        const glm::vec3 a = corner(*part.model, first);
        const glm::vec3 normal = glm::cross(corner(*part.model, first + 1) - a, corner(*part.model, first + 2) - a);
        seen = glm::dot(normal, direction) < 0;
    }
    if (seen)
        seen = seenAt(part, triangle, {RTCHitN_u(arguments->hit, 1, 0), RTCHitN_v(arguments->hit, 1, 0)},
                      stepsOf(query, instance, part, first, RTCRayN_tfar(arguments->ray, 1, 0)));
    if (!seen) arguments->valid[0] = 0;
}

void report(void*, RTCError code, const char* text)
{
    io::log::error("Embree: {} (error {})", text ? text : "unknown", int(code));
}

} // namespace

struct RayScene::State {
    Device device{rtcNewDevice(nullptr)};
    Tree tree;
    std::unordered_map<const io::Model*, std::weak_ptr<Mesh>> meshes;
    std::unordered_map<const io::Model*, std::weak_ptr<Mesh>> boxes;
    struct Slot {
        std::shared_ptr<Mesh> mesh; // null: nothing to hit
        std::shared_ptr<Mesh> box;  // made when first needed
    };
    std::vector<Slot> templates;
    std::vector<Instance> instances;
    std::vector<std::uint32_t> freePlaces;
    std::unordered_map<std::uint32_t, std::uint32_t> placeOf; // object id -> place
    glm::dvec3 anchor{0};                                     // m; Embree's floats are relative to it
    bool boxesOnly = false;
    bool stale = false;

    State()
    {
        EXPECTS(device != nullptr);
        rtcSetDeviceErrorFunction(device.get(), report, nullptr);
        newTree();
    }

    void newTree()
    {
        tree.reset(rtcNewScene(device.get()));
        rtcSetSceneFlags(tree.get(), RTCSceneFlags(RTC_SCENE_FLAG_ROBUST | RTC_SCENE_FLAG_DYNAMIC |
                                                   RTC_SCENE_FLAG_CONTEXT_FILTER_FUNCTION));
        stale = true;
    }

    std::shared_ptr<Mesh> shared(std::unordered_map<const io::Model*, std::weak_ptr<Mesh>>& known,
                                 const std::shared_ptr<const io::Model>& model, bool box)
    {
        if (!model || model->indices.empty()) return nullptr;
        std::weak_ptr<Mesh>& entry = known[model.get()];
        if (auto mesh = entry.lock(); mesh && (box || mesh->model == model)) return mesh;
        auto mesh = makeMesh(device.get(), box ? boxAround(model->bounds) : model);
        entry = mesh;
        return mesh;
    }

    // The mesh that instances of a template stand for now.
    Mesh* meshOf(const io::Assets& assets, io::TemplateId id)
    {
        const std::uint32_t n = io::number(id);
        if (n == 0 || n > assets.models.size()) return nullptr;
        if (templates.size() < n) templates.resize(n);
        Slot& slot = templates[n - 1];
        const auto& model = assets.models[n - 1];
        if (!slot.mesh || slot.mesh->model != model) slot = {.mesh = shared(meshes, model, false)};
        return shownMesh(slot);
    }

    Mesh* shownMesh(Slot& slot)
    {
        if (!boxesOnly || !slot.mesh) return slot.mesh.get();
        if (!slot.box) slot.box = shared(boxes, slot.mesh->model, true);
        return slot.box.get();
    }

    void place(Instance& instance)
    {
        const io::Transform& t = instance.transform;
        const glm::mat3& linear = instance.linear = io::linearPart(t);
        const glm::vec3 position{t.position - anchor};
        float matrix[12];
        for (int column = 0; column < 3; ++column)
            for (int row = 0; row < 3; ++row)
                matrix[column * 3 + row] = linear[column][row];
        for (int row = 0; row < 3; ++row)
            matrix[9 + row] = position[row];
        rtcSetGeometryTransform(instance.geometry.get(), 0, RTC_FORMAT_FLOAT3X4_COLUMN_MAJOR, matrix);
        rtcCommitGeometry(instance.geometry.get());
        stale = true;
    }

    void remove(io::ObjectId id)
    {
        const auto found = placeOf.find(io::number(id));
        if (found == placeOf.end()) return;
        Instance& instance = instances[found->second];
        if (instance.geometry) rtcDetachGeometry(tree.get(), found->second);
        instance = {};
        freePlaces.push_back(found->second);
        placeOf.erase(found);
        stale = true;
    }

    void set(const io::Object& object, const io::Assets& assets)
    {
        Mesh* mesh = meshOf(assets, object.templateId);
        const io::WorldBox bounds = mesh ? io::worldBounds(assets, object) : io::WorldBox{};
        const bool finite = std::isfinite(glm::dot(bounds.min, bounds.max));
        if (!mesh || !finite) return remove(object.id);

        const auto found = placeOf.find(io::number(object.id));
        if (found != placeOf.end() && instances[found->second].templateId == object.templateId) {
            Instance& instance = instances[found->second];
            const bool moved = instance.transform != object.transform;
            instance.transform = object.transform;
            instance.bounds = bounds;
            if (moved) place(instance);
            return;
        }
        remove(object.id);
        if (freePlaces.empty()) {
            freePlaces.push_back(std::uint32_t(instances.size()));
            instances.emplace_back();
        }
        const std::uint32_t at = freePlaces.back();
        freePlaces.pop_back();
        placeOf[io::number(object.id)] = at;
        instances[at] = {.id = object.id,
                         .templateId = object.templateId,
                         .transform = object.transform,
                         .bounds = bounds,
                         .geometry = Geometry{rtcNewGeometry(device.get(), RTC_GEOMETRY_TYPE_INSTANCE)}};
        rtcSetGeometryInstancedScene(instances[at].geometry.get(), mesh->tree.get());
        rtcSetGeometryTimeStepCount(instances[at].geometry.get(), 1);
        place(instances[at]);
        rtcAttachGeometryByID(tree.get(), instances[at].geometry.get(), at);
    }

    void clear()
    {
        instances.clear();
        freePlaces.clear();
        placeOf.clear();
        newTree();
        templates.clear();
        meshes.clear();
        boxes.clear();
    }
};

RayScene::RayScene() : m_state{std::make_unique<State>()} {}
RayScene::~RayScene() = default;

void RayScene::update(const io::Scene& scene, const io::Assets& assets, const io::Changes& changes)
{
    State& s = *m_state;
    if (changes.everything) {
        s.clear();
        io::WorldBox all;
        for (const io::Object& object : scene.objects())
            all.add(object.transform.position);
        s.anchor = all.empty() ? glm::dvec3{0} : all.centre();
        s.instances.reserve(scene.objects().size());
        for (const io::Object& object : scene.objects())
            s.set(object, assets);
        return;
    }
    std::vector<io::TemplateId> newModels;
    for (const io::TemplateId id : changes.templates) {
        const std::size_t slot = io::number(id) - 1;
        const auto now = slot < assets.models.size() ? assets.models[slot] : nullptr;
        const auto before =
            slot < s.templates.size() && s.templates[slot].mesh ? s.templates[slot].mesh->model : nullptr;
        if (now != before) newModels.push_back(id);
    }
    if (!newModels.empty()) {
        for (const io::Object& object : scene.objects()) {
            if (std::ranges::find(newModels, object.templateId) == newModels.end()) continue;
            s.remove(object.id);
            s.set(object, assets);
        }
    }
    for (const io::ObjectId id : changes.objects) {
        if (const io::Object* object = scene.find(id))
            s.set(*object, assets);
        else
            s.remove(id);
    }
}

void RayScene::setBoxesOnly(bool boxesOnly)
{
    State& s = *m_state;
    if (s.boxesOnly == boxesOnly) return;
    s.boxesOnly = boxesOnly;
    for (Instance& instance : s.instances) {
        if (instance.id == io::ObjectId::None) continue;
        Mesh* mesh = s.shownMesh(s.templates[io::number(instance.templateId) - 1]);
        rtcSetGeometryInstancedScene(instance.geometry.get(), mesh->tree.get());
        s.place(instance);
    }
}

bool RayScene::boxesOnly() const
{
    return m_state->boxesOnly;
}

PickHit RayScene::hit(const io::Ray& ray, double maxDistance, std::span<const io::ObjectId> skip, double pixelWidth)
{
    State& s = *m_state;
    if (s.placeOf.empty()) return {};
    if (std::exchange(s.stale, false)) rtcCommitScene(s.tree.get());

    Query query;
    rtcInitIntersectContext(&query);
    query.filter = filter;
    query.instances = &s.instances;
    query.skip = skip;
    query.direction = glm::vec3{ray.direction};
    query.pixelWidth = float(pixelWidth);
    const glm::vec3 origin{ray.origin - s.anchor};
    const glm::vec3 direction{ray.direction};
    if (!std::isfinite(glm::dot(origin, origin)) || !std::isfinite(glm::dot(direction, direction))) return {};
    RTCRayHit found{};
    found.ray = {.org_x = origin.x,
                 .org_y = origin.y,
                 .org_z = origin.z,
                 .tnear = 0,
                 .dir_x = direction.x,
                 .dir_y = direction.y,
                 .dir_z = direction.z,
                 .time = 0,
                 .tfar = float(maxDistance),
                 .mask = ~0u,
                 .id = 0,
                 .flags = 0};
    found.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    found.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
    rtcIntersect1(s.tree.get(), &query, &found);
    if (found.hit.geomID == RTC_INVALID_GEOMETRY_ID) return {};

    const Instance& instance = s.instances[found.hit.instID[0]];
    const Mesh& mesh = *s.shownMesh(s.templates[io::number(instance.templateId) - 1]);
    const PartOfModel& part = mesh.parts[found.hit.geomID];
    const std::size_t first = part.firstIndex + std::size_t(3) * found.hit.primID;
    PickHit hit{
        .surface = Surface::Object, .id = instance.id, .templateId = instance.templateId, .distance = found.ray.tfar};

    // Embree found the triangle in floats; where the ray meets its plane is worked out again in doubles.
    const glm::dmat4 worldFromModel = io::worldFromModel(instance.transform);
    const auto world = [&](std::size_t i) {
        return glm::dvec3{worldFromModel * glm::dvec4{corner(*part.model, i), 1}};
    };
    const glm::dvec3 a = world(first);
    const glm::dvec3 normal = glm::cross(world(first + 1) - a, world(first + 2) - a);
    const double fall = glm::dot(normal, ray.direction);
    const double length = glm::length(normal);
    if (length > 0) {
        hit.normal = fall > 0 ? -normal / length : normal / length;
        const double exact = glm::dot(normal, a - ray.origin) / fall;
        // A plane seen edge-on says little about where; the float answer is the better one then.
        if (std::abs(fall) > 1e-6 * length && exact >= 0) hit.distance = exact;
    } else {
        hit.normal = -ray.direction;
    }
    hit.position = ray.origin + ray.direction * hit.distance;
    return hit;
}

bool RayScene::holds(io::ObjectId id) const
{
    return m_state->placeOf.contains(io::number(id));
}

io::WorldBox RayScene::bounds(io::ObjectId id) const
{
    const auto found = m_state->placeOf.find(io::number(id));
    return found == m_state->placeOf.end() ? io::WorldBox{} : m_state->instances[found->second].bounds;
}

void RayScene::forEachBounds(const std::function<void(io::ObjectId, const io::WorldBox&)>& visit) const
{
    for (const Instance& instance : m_state->instances)
        if (instance.id != io::ObjectId::None) visit(instance.id, instance.bounds);
}

} // namespace editor
