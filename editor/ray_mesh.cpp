#include "editor/ray_mesh.h"

#include <cstddef>

namespace editor {
namespace {

const io::Material kPlain;

} // namespace

RayMesh::RayMesh(RTCDevice device, std::shared_ptr<const io::Model> model)
    : m_model{std::move(model)}, m_scene{rtcNewScene(device)}
{
    const io::Model& source = *m_model;
    rtcSetSceneFlags(m_scene.get(), RTCSceneFlags(RTC_SCENE_FLAG_ROBUST | RTC_SCENE_FLAG_CONTEXT_FILTER_FUNCTION));
    m_parts.reserve(source.parts.size()); // Embree keeps pointers to them
    for (const io::Part& part : source.parts) {
        if (part.indexCount < 3) continue;
        const bool known = part.material >= 0 && std::size_t(part.material) < source.materials.size();
        const io::Material& material = known ? source.materials[std::size_t(part.material)] : kPlain;
        m_parts.push_back({&source, &material, part.firstIndex, mipsOf(material)});
        const EmbreeGeometry geometry{rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE)};
        // Embree reads 16 bytes at each position; a Vertex is longer, so the last one is safe too.
        static_assert(sizeof(io::Vertex) >= 16 && offsetof(io::Vertex, position) == 0);
        rtcSetSharedGeometryBuffer(geometry.get(), RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, source.vertices.data(),
                                   0, sizeof(io::Vertex), source.vertices.size());
        rtcSetSharedGeometryBuffer(geometry.get(), RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, source.indices.data(),
                                   part.firstIndex * sizeof(std::uint32_t), 3 * sizeof(std::uint32_t),
                                   part.indexCount / 3);
        if (material.alphaMode != io::AlphaMode::Opaque)
            rtcSetGeometryIntersectFilterFunction(geometry.get(), filterHit);
        rtcSetGeometryUserData(geometry.get(), &m_parts.back());
        rtcCommitGeometry(geometry.get());
        rtcAttachGeometryByID(m_scene.get(), geometry.get(), unsigned(m_parts.size() - 1));
    }
    rtcCommitScene(m_scene.get());
}

// Null where no texture's alpha counts.
AlphaMips* RayMesh::mipsOf(const io::Material& material)
{
    const int number = material.baseColourTexture.image;
    if (material.alphaMode == io::AlphaMode::Opaque || number < 0 || std::size_t(number) >= m_model->images.size())
        return nullptr;
    const auto& image = m_model->images[std::size_t(number)];
    if (!image) return nullptr;
    return &m_mips.try_emplace({image.get(), material.alphaCutoff}, image, material.alphaCutoff).first->second;
}

std::shared_ptr<const io::Model> boxAround(const io::Box& bounds)
{
    auto box = std::make_shared<io::Model>(io::boxModel(bounds.size(), glm::vec4{1}));
    for (io::Vertex& vertex : box->vertices)
        vertex.position += glm::vec3{bounds.centre().x, bounds.min.y, bounds.centre().z};
    box->bounds = bounds;
    return box;
}

} // namespace editor
