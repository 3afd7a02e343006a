#include "renderer/passes/lamps.h"

#include "renderer/shaders/shared/bindings.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace renderer {
namespace {

static_assert(sizeof(glsl::LampRecord) == LAMP_TEXELS * sizeof(glm::vec4) && sizeof(glsl::LampFace) == sizeof(glsl::LampRecord));

glsl::LampRecord recordOf(const Lamp& lamp, const glm::dvec3& eye)
{
    glsl::LampRecord record{};
    record.place = glm::vec3{lamp.place - eye};
    record.range = lamp.range;
    record.intensity = lamp.intensity;
    record.coneOffset = 1;
    record.direction = lamp.direction;
    if (lamp.isSpot()) { // as KHR_lights_punctual
        record.coneScale = 1 / std::max(std::cos(lamp.inner) - std::cos(lamp.outer), 0.001f);
        record.coneOffset = -std::cos(lamp.outer) * record.coneScale;
    }
    return record;
}

// Faces of their shadows follow behind the lamps.
std::vector<glsl::LampRecord> recordsOf(std::span<const Lamp> lamps, std::span<const LampShadow> shadows, const glm::dvec3& eye)
{
    std::vector<glsl::LampRecord> records;
    std::vector<glsl::LampFace> faces;
    for (std::size_t i = 0; i < lamps.size(); ++i) {
        glsl::LampRecord& record = records.emplace_back(recordOf(lamps[i], eye));
        record.firstFace = float((lamps.size() + faces.size()) * LAMP_TEXELS);
        record.faces = float(shadows[i].atlasFromLamp.size());
        record.texelAngle = shadows[i].texelAngle;
        for (const glm::mat4& face : shadows[i].atlasFromLamp)
            faces.push_back({face});
    }
    for (const glsl::LampFace& face : faces)
        records.push_back(std::bit_cast<glsl::LampRecord>(face));
    return records;
}

} // namespace

void LampPass::render(GpuFrame& gpu, Scenery& scenery, const Viewpoint& viewpoint, const Settings& settings)
{
    const std::span<const Lamp> lamps = viewpoint.lamps;
    const std::vector<LampShadow> shadows = m_shadows.render(gpu, scenery, viewpoint, lamps, settings);
    if (lamps.empty()) return;
    const auto scope = gpu.scope("lamps");
    const LampClusters clusters = clustersOf(lamps, viewpoint.eye);
    const std::vector<glsl::LampRecord> records = recordsOf(lamps, shadows, viewpoint.eye.position);

    const GpuStream::Piece lists = gpu.stream().put(std::span<const std::uint32_t>{clusters.lists});
    m_lists.source(lists.buffer, lists.offset, lists.bytes.size());
    const GpuStream::Piece texels = gpu.stream().put(std::span<const glsl::LampRecord>{records});
    m_records.source(texels.buffer, texels.offset, texels.bytes.size());
    glBindTextureUnit(LAMPS_UNIT, m_records.id());
    glBindTextureUnit(LAMP_LISTS_UNIT, m_lists.id());
    m_shadows.bind(gpu);
    gpu.constants(LAMPS_BINDING, glsl::LampGrid{.sliceScale = clusters.sliceScale,
                                                .sliceBias = clusters.sliceBias,
                                                .shadowTexel = m_shadows.texel()});
}

} // namespace renderer
