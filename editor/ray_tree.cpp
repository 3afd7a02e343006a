#include "editor/ray_tree.h"

#include "io/base/contract.h"

#include <algorithm>

namespace editor {

// A hit that Embree offers.
struct RayTree::Candidate {
    std::uint32_t instance = 0; // as Embree numbers it
    const PartOfModel* part = nullptr;
    std::size_t triangle = 0;
    glm::vec2 at{0};        // barycentric
    glm::vec3 direction{0}; // of the ray, in the model's own space
    float distance = 0;     // m, from where Embree's ray begins
};

struct RayTree::Context : RTCIntersectContext {
    const RayQuery* query = nullptr;
    const RayInstance* instances = nullptr;
    const Built* built = nullptr;
    bool lost = false; // something that was built is gone
    glm::vec3 direction{0};
    float start = 0; // m along the ray, where Embree's begins
};

void RayTree::build(RTCDevice device, Places places, std::span<const RayInstance> instances, const MeshOf& meshOf,
                    bool often)
{
    io::WorldBox box;
    for (const std::uint32_t place : places)
        box.add(instances[place].bounds);
    m_anchor = places.empty() ? glm::dvec3{0} : box.centre();
    m_scene.reset(rtcNewScene(device));
    rtcSetSceneFlags(m_scene.get(), RTCSceneFlags(RTC_SCENE_FLAG_ROBUST | RTC_SCENE_FLAG_CONTEXT_FILTER_FUNCTION |
                                                  (often ? RTC_SCENE_FLAG_DYNAMIC : RTC_SCENE_FLAG_NONE)));
    m_built.clear();
    m_built.reserve(places.size());
    std::vector<std::shared_ptr<RayMesh>> meshes;
    for (const std::uint32_t place : places) {
        const RayInstance& instance = instances[place];
        auto mesh = meshOf(instance.templateId);
        const glm::mat3 linear = io::linearPart(instance.transform);
        const glm::vec3 position{instance.transform.position - m_anchor};
        const float columns[12] = {linear[0].x, linear[0].y, linear[0].z, linear[1].x, linear[1].y, linear[1].z,
                                   linear[2].x, linear[2].y, linear[2].z, position.x,  position.y,  position.z};
        const EmbreeGeometry geometry{rtcNewGeometry(device, RTC_GEOMETRY_TYPE_INSTANCE)};
        rtcSetGeometryInstancedScene(geometry.get(), mesh->scene());
        rtcSetGeometryTransform(geometry.get(), 0, RTC_FORMAT_FLOAT3X4_COLUMN_MAJOR, columns);
        rtcCommitGeometry(geometry.get());
        rtcAttachGeometryByID(m_scene.get(), geometry.get(), unsigned(m_built.size()));
        m_built.push_back({place, instance.version, mesh.get(), linear});
        if (std::ranges::find(meshes, mesh) == meshes.end()) meshes.push_back(std::move(mesh));
    }
    rtcCommitScene(m_scene.get());
    m_meshes = std::move(meshes);
    m_lost = 0;
}

// Whether anybody sees a hit: back faces, holes in leaves, what is gone, and what the caller skips do not count.
bool RayTree::seen(const Context& context, const Candidate& hit)
{
    const RayQuery& query = *context.query;
    const Built& built = context.built[hit.instance];
    if (context.lost || !query.skip.empty()) {
        const RayInstance& instance = context.instances[built.place];
        if (instance.version != built.version) return false;
        if (std::ranges::binary_search(query.skip, instance.id)) return false;
    }
    const PartOfModel& part = *hit.part;
    const std::size_t first = part.firstIndex + 3 * hit.triangle;
    if (!part.material->doubleSided) {
        const glm::vec3 a = corner(*part.model, first);
        const glm::vec3 normal = glm::cross(corner(*part.model, first + 1) - a, corner(*part.model, first + 2) - a);
        if (!(glm::dot(normal, hit.direction) < 0)) return false;
    }
    if (part.material->alphaMode == io::AlphaMode::Opaque) return true;
    PixelSteps steps{};
    if (query.pixelWidth > 0 && part.mips) {
        const glm::vec3 a = corner(*part.model, first);
        steps = pixelSteps(built.linear * (corner(*part.model, first + 1) - a),
                           built.linear * (corner(*part.model, first + 2) - a), context.direction,
                           query.pixelWidth * (context.start + hit.distance));
    }
    return seenAt(part, hit.triangle, hit.at, steps);
}

void filterHit(const RTCFilterFunctionNArguments* arguments)
{
    EXPECTS(arguments->N == 1);
    if (arguments->valid[0] != -1) return;
    const auto& context = *static_cast<const RayTree::Context*>(arguments->context);
    RTCHitN* hit = arguments->hit;
    RTCRayN* ray = arguments->ray; // Inside an instance Embree holds the ray in the model's own space.
    const bool seen = RayTree::seen(
        context, {.instance = context.instID[0],
                  .part = static_cast<const PartOfModel*>(arguments->geometryUserPtr),
                  .triangle = RTCHitN_primID(hit, 1, 0),
                  .at = {RTCHitN_u(hit, 1, 0), RTCHitN_v(hit, 1, 0)},
                  .direction = {RTCRayN_dir_x(ray, 1, 0), RTCRayN_dir_y(ray, 1, 0), RTCRayN_dir_z(ray, 1, 0)},
                  .distance = RTCRayN_tfar(ray, 1, 0)});
    if (!seen) arguments->valid[0] = 0;
}

// The same of a hit that was answered without asking, where holes in leaves were looked at already.
bool RayTree::stands(const Context& context, const RTCRayHit& hit) const
{
    const Built& built = m_built[hit.hit.instID[0]];
    if (context.lost && context.instances[built.place].version != built.version) return false;
    if (built.mesh->part(hit.hit.geomID).material->doubleSided) return true;
    // The triangle's corners lie far apart in memory; Embree's normal does, in the model's own space.
    const glm::vec3 normal{hit.hit.Ng_x, hit.hit.Ng_y, hit.hit.Ng_z};
    return glm::dot(normal, glm::inverse(built.linear) * context.direction) < 0;
}

bool RayTree::hit(const RayQuery& query, std::span<const RayInstance> instances, double entry, double reach,
                  RayTreeHit& found) const
{
    // Embree's ray begins just outside of the tile, so that its floats are small wherever in the world it is.
    constexpr double kBefore = 1; // m
    const double start = std::max(0.0, entry - kBefore);
    const glm::vec3 origin{query.ray.origin + query.ray.direction * start - m_anchor};
    Context context;
    rtcInitIntersectContext(&context);
    context.query = &query;
    context.instances = instances.data();
    context.built = m_built.data();
    context.lost = m_lost > 0;
    context.direction = glm::vec3{query.ray.direction};
    context.start = float(start);
    RTCRayHit asked{};
    asked.ray = {.org_x = origin.x,
                 .org_y = origin.y,
                 .org_z = origin.z,
                 .tnear = 0,
                 .dir_x = context.direction.x,
                 .dir_y = context.direction.y,
                 .dir_z = context.direction.z,
                 .time = 0,
                 .tfar = float(reach - start),
                 .mask = ~0u,
                 .id = 0,
                 .flags = 0};
    asked.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    asked.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
    // Most nearest hits are seen, and Embree is far quicker when it need not ask at each; parts with holes ask anyway.
    RTCRayHit hit = asked;
    if (query.skip.empty()) {
        rtcIntersect1(m_scene.get(), &context, &hit);
        if (hit.hit.geomID == RTC_INVALID_GEOMETRY_ID) return false;
    }
    if (!query.skip.empty() || !stands(context, hit)) {
        hit = asked;
        context.filter = filterHit;
        rtcIntersect1(m_scene.get(), &context, &hit);
        if (hit.hit.geomID == RTC_INVALID_GEOMETRY_ID) return false;
    }
    const Built& built = m_built[hit.hit.instID[0]];
    found = {.distance = start + double(hit.ray.tfar),
             .place = built.place,
             .part = &built.mesh->part(hit.hit.geomID),
             .triangle = hit.hit.primID,
             .linear = &built.linear};
    return true;
}

} // namespace editor
