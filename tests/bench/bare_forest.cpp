#include "tests/bench/bare_forest.h"

#include "io/base/contract.h"
#include "io/scene/environment.h"
#include "renderer/renderer.h"
#include "tests/bench/bare_shaders.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>

namespace bench {
namespace {

constexpr double kCell = 128;     // m
constexpr int kGroundSide = 257;  // vertices
constexpr int kShadowSide = 2048; // texels
constexpr float kGroundRepeat = 4; // m

enum Uniform { kClipFromWorld, kShadowFromWorld, kUvScaleOffset, kFactor, kTowardSun, kCutoff };

renderer::gl::Program program(const char* label, const char* vertex, std::string fragment, bool masked)
{
    if (masked) fragment.insert(fragment.find('\n') + 1, "#define MASKED\n");
    const std::array<renderer::gl::StageText, 2> stages{
        {{GL_VERTEX_SHADER, vertex}, {GL_FRAGMENT_SHADER, std::move(fragment)}}};
    renderer::gl::BuildLog log;
    renderer::gl::Program result = renderer::gl::link(label, stages, log);
    if (!result) std::fprintf(stderr, "%s: %s\n", label, log.text.c_str());
    EXPECTS(result);
    return result;
}

std::vector<std::uint8_t> rgba(const io::Image& image)
{
    std::vector<std::uint8_t> pixels(std::size_t(image.size.x) * image.size.y * 4, 255);
    const auto value = [&](std::size_t i) {
        if (image.type == io::PixelType::U8) return reinterpret_cast<const std::uint8_t*>(image.bytes.data())[i];
        return std::uint8_t(reinterpret_cast<const std::uint16_t*>(image.bytes.data())[i] >> 8);
    };
    for (std::size_t p = 0; p * 4 < pixels.size(); ++p)
        for (int c = 0; c < 4; ++c)
            if (c < image.channels || (image.channels == 1 && c < 3))
                pixels[p * 4 + c] = value(p * image.channels + (image.channels == 1 ? 0 : c));
    return pixels;
}

glm::mat3x4 rowsOf(const glm::dmat4& worldFromModel)
{
    return glm::mat3x4{glm::transpose(worldFromModel)};
}

glm::mat4 shadowMatrix(const io::WorldBox& bounds, const glm::vec3& towardSun)
{
    const glm::vec3 centre{bounds.centre()};
    const glm::vec3 up = std::abs(towardSun.y) > 0.99f ? glm::vec3{0, 0, -1} : glm::vec3{0, 1, 0};
    const glm::mat4 lightFromWorld = glm::lookAt(centre + towardSun, centre, up);
    const io::WorldBox box = io::transformed({glm::vec3{bounds.min}, glm::vec3{bounds.max}}, glm::dmat4{lightFromWorld});
    const glm::vec3 low{box.min}, high{box.max};
    return glm::orthoRH_ZO(low.x, high.x, low.y, high.y, -high.z, -low.z) * lightFromWorld;
}

// False when all of the box is outside of one plane of the frustum.
bool seen(const io::WorldBox& box, const glm::dmat4& clipFromWorld)
{
    const glm::dmat4 rows = glm::transpose(clipFromWorld);
    for (const glm::dvec4& plane : {rows[3] + rows[0], rows[3] - rows[0], rows[3] + rows[1], rows[3] - rows[1], rows[3]}) {
        const glm::dvec3 far{plane.x > 0 ? box.max.x : box.min.x, plane.y > 0 ? box.max.y : box.min.y,
                             plane.z > 0 ? box.max.z : box.min.z};
        if (glm::dot(glm::dvec3{plane}, far) + plane.w < 0) return false;
    }
    return true;
}

} // namespace

BareForest::BareForest(const io::Scene& scene, const io::Assets& assets, glm::ivec2 size)
    : m_size{size}, m_towardSun{io::towardSun(scene.environment())}
{
    m_objectPrograms = {program("objects", kObjectVertex, kObjectFragment, false),
                        program("masked objects", kObjectVertex, kObjectFragment, true)};
    m_casterPrograms = {program("casters", kCasterVertex, kCasterFragment, false),
                        program("masked casters", kCasterVertex, kCasterFragment, true)};
    for (std::size_t slot = 0; slot < assets.models.size(); ++slot)
        addModel(*assets.models[slot], slot);
    placeCopies(scene, assets);
    m_shadowFromWorld = shadowMatrix(m_bounds, m_towardSun);
    if (scene.heights()) addGround(*scene.heights(), assets);
    makeTargets();
}

std::size_t BareForest::addTexture(const io::Image* image)
{
    if (const auto known = m_textureOf.find(image); known != m_textureOf.end()) return known->second;
    static constexpr std::uint8_t kWhite[4] = {255, 255, 255, 255};
    const glm::ivec2 size = image ? image->size : glm::ivec2{1};
    const int mips = renderer::gl::fullMipCount(size);
    m_textures.emplace_back(renderer::gl::TextureDesc{
        .label = "base colour", .size = size, .format = GL_RGBA8, .mips = mips, .wrap = GL_REPEAT});
    m_textures.back().upload(image ? rgba(*image).data() : kWhite, GL_RGBA, GL_UNSIGNED_BYTE);
    glGenerateTextureMipmap(m_textures.back().id());
    return m_textureOf[image] = m_textures.size() - 1;
}

void BareForest::addModel(const io::Model& model, std::size_t slot)
{
    const auto baseVertex = std::int32_t(m_vertices.size());
    for (const io::Vertex& v : model.vertices)
        m_vertices.push_back({v.position, v.normal, v.uv0, v.colour});
    for (const io::Part& part : model.parts) {
        const io::Material& material = model.materials[std::size_t(part.material)];
        const io::TextureUse& use = material.baseColourTexture;
        const io::Image* image = use.image < 0 ? nullptr : model.images[std::size_t(use.image)].get();
        m_parts.push_back({.firstIndex = std::uint32_t(m_indices.size()) + part.firstIndex,
                           .indexCount = part.indexCount,
                           .baseVertex = baseVertex,
                           .model = slot,
                           .texture = addTexture(image),
                           .factor = material.baseColour,
                           .uvScaleOffset = {use.scale, use.offset},
                           .masked = material.alphaMode != io::AlphaMode::Opaque,
                           .twoSided = material.doubleSided,
                           .cutoff = material.alphaCutoff});
    }
    m_indices.insert(m_indices.end(), model.indices.begin(), model.indices.end());
}

void BareForest::placeCopies(const io::Scene& scene, const io::Assets& assets)
{
    m_copies.resize(assets.models.size());
    std::map<std::array<int, 3>, std::vector<const io::Object*>> cells; // by model, x, z
    for (const io::Object& object : scene.objects()) {
        const io::Template* of = scene.find(object.templateId);
        if (!of || of->model.empty()) continue; // a group or a marker
        const glm::ivec2 cell{glm::floor(glm::dvec2{object.transform.position.x, object.transform.position.z} / kCell)};
        cells[{int(io::number(object.templateId)) - 1, cell.x, cell.y}].push_back(&object);
    }
    for (const auto& [key, objects] : cells) {
        Copies copies{.first = std::uint32_t(m_instances.size()), .count = std::uint32_t(objects.size())};
        for (const io::Object* object : objects) {
            m_instances.push_back(rowsOf(io::worldFromModel(object->transform)));
            copies.bounds.add(io::worldBounds(assets, *object));
        }
        m_bounds.add(copies.bounds);
        m_copies[std::size_t(key[0])].push_back(copies);
    }
}

void BareForest::addGround(const io::HeightMap& heights, const io::Assets& assets)
{
    const auto baseVertex = std::int32_t(m_vertices.size());
    const glm::dvec2 step = glm::dvec2{heights.size - 1} * heights.metresPerTexel / double(kGroundSide - 1);
    for (int z = 0; z < kGroundSide; ++z)
        for (int x = 0; x < kGroundSide; ++x) {
            const glm::dvec2 at = heights.origin + step * glm::dvec2{x, z};
            m_vertices.push_back({.position = {at.x, heights.height(at.x, at.y).value_or(0), at.y},
                                  .normal = glm::vec3{heights.normal(at.x, at.y).value_or(glm::dvec3{0, 1, 0})},
                                  .uv = glm::vec2{at} / kGroundRepeat,
                                  .colour = glm::u8vec4{255}});
        }
    const auto first = std::uint32_t(m_indices.size());
    for (std::uint32_t z = 0; z + 1 < kGroundSide; ++z)
        for (std::uint32_t x = 0; x + 1 < kGroundSide; ++x) {
            const std::uint32_t i = z * kGroundSide + x;
            for (const std::uint32_t corner : {i, i + kGroundSide, i + 1, i + 1, i + kGroundSide, i + kGroundSide + 1})
                m_indices.push_back(corner);
        }
    m_parts.push_back({.firstIndex = first,
                       .indexCount = std::uint32_t(m_indices.size()) - first,
                       .baseVertex = baseVertex,
                       .model = m_copies.size(),
                       .texture = addTexture(assets.layers.empty() ? nullptr : assets.layers[0].colour.get())});
    io::WorldBox bounds = m_bounds;
    bounds.add({{heights.origin.x, heights.min, heights.origin.y},
                {heights.origin.x + step.x * kGroundSide, heights.max, heights.origin.y + step.y * kGroundSide}});
    m_copies.push_back({{.first = std::uint32_t(m_instances.size()), .count = 1, .bounds = bounds}});
    m_instances.push_back(rowsOf(glm::dmat4{1}));
}

void BareForest::makeTargets()
{
    const auto filled = [](const char* label, const auto& values) {
        const auto bytes = std::as_bytes(std::span{values});
        renderer::gl::Buffer buffer{label, bytes.size()};
        buffer.write(0, bytes);
        return buffer;
    };
    m_vertexBuffer = filled("vertices", m_vertices);
    m_indexBuffer = filled("indices", m_indices);
    m_instanceBuffer = filled("instances", m_instances);
    m_vertices = {};
    m_indices = {};

    m_array = renderer::gl::VertexArray{"objects"};
    m_array.attribute(0, 0, 3, GL_FLOAT, offsetof(Vertex, position));
    m_array.attribute(1, 0, 3, GL_FLOAT, offsetof(Vertex, normal));
    m_array.attribute(2, 0, 2, GL_FLOAT, offsetof(Vertex, uv));
    m_array.attribute(3, 0, 4, GL_UNSIGNED_BYTE, offsetof(Vertex, colour), true);
    for (int row = 0; row < 3; ++row)
        m_array.attribute(4 + row, 1, 4, GL_FLOAT, std::size_t(row) * sizeof(glm::vec4));
    m_array.perInstance(1);
    m_array.source(0, m_vertexBuffer.id(), 0, sizeof(Vertex));
    m_array.source(1, m_instanceBuffer.id(), 0, sizeof(Instance));
    m_array.indices(m_indexBuffer.id());

    m_colour = renderer::gl::Texture{{.label = "colour", .size = m_size, .format = GL_RGBA8}};
    m_depth = renderer::gl::Texture{{.label = "depth", .size = m_size, .format = GL_DEPTH_COMPONENT32F, .filter = GL_NEAREST}};
    m_shadowMap = renderer::gl::Texture{
        {.label = "shadow map", .size = glm::ivec2{kShadowSide}, .format = GL_DEPTH_COMPONENT32F, .compare = true}};
    m_picture = renderer::gl::Framebuffer{{.label = "picture", .colours = {&m_colour}, .depth = &m_depth}};
    m_shadow = renderer::gl::Framebuffer{{.label = "shadow", .depth = &m_shadowMap}};
}

BareCounts BareForest::draw(const io::Camera& camera)
{
    glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
    glEnable(GL_DEPTH_TEST);
    glDisable(GL_FRAMEBUFFER_SRGB);
    glBindVertexArray(m_array.id());
    drawShadows();
    return drawPicture(camera);
}

void BareForest::prepare(const Programs& programs, const Part& part) const
{
    glUseProgram((part.masked ? programs.masked : programs.opaque).id());
    (part.twoSided ? glDisable : glEnable)(GL_CULL_FACE);
    glBindTextureUnit(0, m_textures[part.texture].id());
    glUniformMatrix4fv(kShadowFromWorld, 1, GL_FALSE, glm::value_ptr(m_shadowFromWorld));
    glUniform4fv(kUvScaleOffset, 1, glm::value_ptr(part.uvScaleOffset));
    if (part.masked) glUniform1f(kCutoff, part.cutoff);
}

void BareForest::drawCopies(const Part& part, const Copies& copies) const
{
    glDrawElementsInstancedBaseVertexBaseInstance(
        GL_TRIANGLES, GLsizei(part.indexCount), GL_UNSIGNED_INT,
        reinterpret_cast<const void*>(std::size_t(part.firstIndex) * sizeof(std::uint32_t)), GLsizei(copies.count),
        part.baseVertex, copies.first);
}

// All of the forest, whatever the camera sees: its shadows may.
void BareForest::drawShadows()
{
    m_shadow.bind();
    glDepthFunc(GL_LESS);
    m_shadow.clearDepth(1);
    glEnable(GL_POLYGON_OFFSET_FILL);
    glPolygonOffset(2, 4);
    for (const Part& part : m_parts) {
        prepare(m_casterPrograms, part);
        for (const Copies& copies : m_copies[part.model])
            drawCopies(part, copies);
    }
    glDisable(GL_POLYGON_OFFSET_FILL);
}

BareCounts BareForest::drawPicture(const io::Camera& camera)
{
    const glm::dmat4 clipFromWorld = renderer::clipFromView(camera, double(m_size.x) / m_size.y) *
                                     renderer::viewFromRelative(camera) * glm::translate(glm::dmat4{1}, -camera.eye);
    const glm::mat4 matrix{clipFromWorld};
    m_picture.bind();
    m_picture.clearColour(0, {0.35f, 0.55f, 0.85f, 1});
    glDepthFunc(GL_GREATER);
    m_picture.clearDepth(0); // reversed
    glBindTextureUnit(1, m_shadowMap.id());
    BareCounts counts;
    for (const Part& part : m_parts) {
        prepare(m_objectPrograms, part);
        glUniformMatrix4fv(kClipFromWorld, 1, GL_FALSE, glm::value_ptr(matrix));
        glUniform4fv(kFactor, 1, glm::value_ptr(part.factor));
        glUniform3fv(kTowardSun, 1, glm::value_ptr(m_towardSun));
        for (const Copies& copies : m_copies[part.model]) {
            if (!seen(copies.bounds, clipFromWorld)) continue;
            drawCopies(part, copies);
            ++counts.drawCalls;
            counts.triangles += std::size_t(part.indexCount) / 3 * copies.count;
        }
    }
    return counts;
}

io::Image BareForest::readPicture() const
{
    io::Image image{.size = m_size, .channels = 3};
    std::vector<std::byte> rows(image.rowBytes() * std::size_t(m_size.y));
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glGetTextureImage(m_colour.id(), 0, GL_RGB, GL_UNSIGNED_BYTE, GLsizei(rows.size()), rows.data());
    for (int y = m_size.y - 1; y >= 0; --y) {
        const auto row = rows.begin() + std::ptrdiff_t(image.rowBytes()) * y;
        image.bytes.insert(image.bytes.end(), row, row + std::ptrdiff_t(image.rowBytes()));
    }
    return image;
}

} // namespace bench
