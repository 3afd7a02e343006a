#include "editor/ray_tile.h"

#include "io/base/contract.h"

#include <algorithm>

namespace editor {

struct RayTile::Context : RTCIntersectContext {
    const RayQuery* query = nullptr;
    const RayInstance* instances = nullptr;
    const Built* built = nullptr;
    glm::vec3 direction{0};
    float start = 0; // m along the ray, where Embree's begins
};

void RayTile::lose()
{
    if (++m_lost * 2 > m_built.size()) m_stale = true;
}

void RayTile::build(RTCDevice device, std::span<const RayInstance> instances, const MeshOf& meshOf, bool often)
{
    m_box = {};
    for (const std::uint32_t place : members)
        m_box.add(instances[place].bounds);
    m_anchor = members.empty() ? glm::dvec3{0} : m_box.centre();
    m_scene.reset(rtcNewScene(device));
    rtcSetSceneFlags(m_scene.get(), RTCSceneFlags(RTC_SCENE_FLAG_ROBUST | RTC_SCENE_FLAG_CONTEXT_FILTER_FUNCTION |
                                                  (often ? RTC_SCENE_FLAG_DYNAMIC : RTC_SCENE_FLAG_NONE)));
    m_built.clear();
    m_built.reserve(members.size());
    std::vector<std::shared_ptr<RayMesh>> meshes;
    for (const std::uint32_t place : members) {
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
    m_stale = false;
}

// Rejects hits that nobody sees: back faces, holes in leaves, what is gone, and what the caller skips.
void RayTile::filter(const RTCFilterFunctionNArguments* arguments)
{
    EXPECTS(arguments->N == 1);
    if (arguments->valid[0] != -1) return;
    const auto& context = *static_cast<const Context*>(arguments->context);
    const RayQuery& query = *context.query;
    const Built& built = context.built[context.instID[0]];
    const RayInstance& instance = context.instances[built.place];
    const auto& part = *static_cast<const PartOfModel*>(arguments->geometryUserPtr);
    const std::size_t triangle = RTCHitN_primID(arguments->hit, 1, 0);
    const std::size_t first = part.firstIndex + 3 * triangle;

    bool seen = instance.version == built.version && !std::ranges::binary_search(query.skip, instance.id);
    if (seen && !part.material->doubleSided) {
        // Inside an instance Embree holds the ray in the model's own space.
        const glm::vec3 direction{RTCRayN_dir_x(arguments->ray, 1, 0), RTCRayN_dir_y(arguments->ray, 1, 0),
                                  RTCRayN_dir_z(arguments->ray, 1, 0)};
        const glm::vec3 a = corner(*part.model, first);
        const glm::vec3 normal = glm::cross(corner(*part.model, first + 1) - a, corner(*part.model, first + 2) - a);
        seen = glm::dot(normal, direction) < 0;
    }
    if (seen && part.material->alphaMode != io::AlphaMode::Opaque) {
        PixelSteps steps{};
        if (query.pixelWidth > 0 && part.mips) {
            const glm::vec3 a = corner(*part.model, first);
            const float distance = context.start + RTCRayN_tfar(arguments->ray, 1, 0);
            steps = pixelSteps(built.linear * (corner(*part.model, first + 1) - a),
                               built.linear * (corner(*part.model, first + 2) - a), context.direction,
                               query.pixelWidth * distance);
        }
        seen = seenAt(part, triangle, {RTCHitN_u(arguments->hit, 1, 0), RTCHitN_v(arguments->hit, 1, 0)}, steps);
    }
    if (!seen) arguments->valid[0] = 0;
}

bool RayTile::hit(const RayQuery& query, std::span<const RayInstance> instances, double entry, double reach,
                  RayTileHit& found) const
{
    // Embree's ray begins just outside of the tile, so that its floats are small wherever in the world it is.
    constexpr double kBefore = 1; // m
    const double start = std::max(0.0, entry - kBefore);
    const glm::vec3 origin{query.ray.origin + query.ray.direction * start - m_anchor};
    Context context;
    rtcInitIntersectContext(&context);
    context.filter = filter;
    context.query = &query;
    context.instances = instances.data();
    context.built = m_built.data();
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
    rtcIntersect1(m_scene.get(), &context, &asked);
    if (asked.hit.geomID == RTC_INVALID_GEOMETRY_ID) return false;
    const Built& built = m_built[asked.hit.instID[0]];
    found = {.distance = start + double(asked.ray.tfar),
             .place = built.place,
             .part = &built.mesh->part(asked.hit.geomID),
             .triangle = asked.hit.primID};
    return true;
}

} // namespace editor
