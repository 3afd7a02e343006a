#include "renderer/impostor_baker.h"

#include "renderer/shaders/shared/bindings.h"
#include "renderer/shaders/shared/instance.h"
#include "renderer/shaders/shared/view.h"

namespace renderer {
namespace {

constexpr int kSide = IMPOSTOR_FRAMES * IMPOSTOR_FRAME_TEXELS; // texels
constexpr int kFrames = IMPOSTOR_FRAMES * IMPOSTOR_FRAMES;
constexpr std::uint32_t kMostIndices = 3 * 4000; // of the level that is taken, where there is a choice
constexpr unsigned kAllFeatures = kFeatureMask | kFeatureNormalMap | kFeatureSurfaceMaps | kFeatureWrap | kFeatureUvTransform |
                                  kFeatureSmoothColours;

// The finest mesh that does not cost more than its picture shows.
int bakedLevel(const ModelEntry& model)
{
    const int meshes = int(model.levels.size()) - 1; // the last one is the impostor
    for (int level = 0; level < meshes; ++level) {
        std::uint32_t indices = 0;
        for (const ModelPart& part : model.levels[std::size_t(level)].parts)
            indices += part.indexCount;
        if (indices <= kMostIndices) return level;
    }
    return meshes - 1;
}

// Copies of the model, each turned so that its frame's direction is +Z and put into its square of side 1.
std::vector<glsl::Instance> copies(const ModelEntry& model)
{
    std::vector<glsl::Instance> instances;
    const float scale = IMPOSTOR_FILL / 2 / model.radius;
    for (int i = 0; i < kFrames; ++i) {
        const glm::vec2 grid{i % IMPOSTOR_FRAMES, i / IMPOSTOR_FRAMES};
        const glm::vec3 forward = glsl::frameDirection(grid);
        const glm::vec3 right = glsl::frameRight(forward);
        const glm::mat3 turn = glm::transpose(glm::mat3{right, glm::cross(forward, right), forward}) * scale;
        glsl::Instance& instance = instances.emplace_back();
        instance.positionHigh = glm::vec3{grid + 0.5f, 0} - turn * model.centre;
        instance.axisX = glm::vec4{turn[0], 0};
        instance.axisY = glm::vec4{turn[1], 0};
        instance.axisZ = glm::vec4{turn[2], 0};
    }
    return instances;
}

// All squares, with depth from 0 to 1 towards whoever looks.
glsl::View sheetView()
{
    glsl::View view{};
    const float s = 2.0f / IMPOSTOR_FRAMES;
    view.clipFromRelative = glm::mat4{glm::vec4{s, 0, 0, 0}, glm::vec4{0, s, 0, 0}, glm::vec4{0, 0, 1, 0},
                                      glm::vec4{-1, -1, 0.5f, 1}};
    return view;
}

} // namespace

ImpostorBaker::ImpostorBaker(ShaderLibrary& shaders, std::shared_ptr<io::KeptBytes> kept)
    : m_kept{std::move(kept), shaders}, m_programs{shaders, "impostor_bake", {}, kAllFeatures}, m_shrink{shaders.fullScreen("impostor_shrink")},
      m_objects{makeObjectVertexArray()}
{
}

ImpostorBaker::Sheet ImpostorBaker::makeSheet(int side, const gl::Texture* depth)
{
    const auto make = [&](std::string_view label) {
        return gl::Texture{{.label = label, .size = glm::ivec2{side}, .filter = GL_NEAREST, .target = true}};
    };
    Sheet sheet{.colour = make("impostor sheet colour"), .surface = make("impostor sheet surface"), .framebuffer = {}};
    sheet.framebuffer = gl::Framebuffer{
        {.label = "impostor sheet", .colours = {&sheet.colour, &sheet.surface}, .depth = depth}};
    return sheet;
}

void ImpostorBaker::makeSheets()
{
    m_depth = gl::Texture{{.label = "impostor sheet depth",
                           .size = glm::ivec2{2 * kSide},
                           .format = GL_DEPTH_COMPONENT32F,
                           .target = true}};
    for (std::size_t i = 0; i < m_sheets.size(); ++i)
        m_sheets[i] = makeSheet(2 * kSide >> i, i == 0 ? &m_depth : nullptr);
}

void ImpostorBaker::render(GpuFrame& gpu, const ModelLibrary& models, ImpostorAtlas& atlas)
{
    if (atlas.filled() == int(atlas.models().size())) return;
    const auto scope = gpu.scope("impostors");
    atlas.reserve();
    for (int layer = atlas.filled(); layer < int(atlas.models().size()); ++layer) {
        const int model = atlas.models()[std::size_t(layer)];
        if (!m_kept.fill(models, model, atlas, layer)) {
            if (!m_depth) makeSheets();
            bake(gpu, models, model);
            shrink(gpu, atlas, layer);
            m_kept.keep(models, model, atlas, layer);
        }
        atlas.filledOne();
    }
    m_sheets = {};
    m_depth = {};
}

void ImpostorBaker::bake(GpuFrame& gpu, const ModelLibrary& models, int model)
{
    const ModelEntry& entry = models.entry(model);
    const std::vector<glsl::Instance> instances = copies(entry);
    std::vector<Seen> seen;
    for (std::uint32_t i = 0; i < kFrames; ++i)
        seen.push_back({i, binIndex(entry, bakedLevel(entry), false, false)});
    const DrawList list = makeDrawList(gpu.stream(), {.models = models, .seen = seen, .instances = instances});

    const gl::Framebuffer& target = m_sheets[0].framebuffer;
    target.clearColour(0, glm::vec4{0});
    target.clearColour(1, glm::vec4{glm::vec3{128.0f / 255}, 0});
    target.clearDepth(0);
    target.bind();
    gpu.constants(VIEW_BINDING, sheetView());
    drawRanges(gpu, m_objects, list, list.opaque, [&](const DrawRange&, const Batch& batch) {
        gl::apply({.depthTest = GL_GREATER, .depthWrite = true, .cull = GLenum(batch.twoSided ? GL_NONE : GL_BACK)});
        bindArrays(gpu, models, batch);
        return gpu.use(m_programs.of(batch));
    });
}

void ImpostorBaker::shrink(GpuFrame& gpu, const ImpostorAtlas& atlas, int layer)
{
    for (std::size_t i = 1; i < m_sheets.size(); ++i) {
        const Sheet& from = m_sheets[i - 1];
        const Sheet& to = m_sheets[i];
        to.framebuffer.bind();
        gpu.fullScreen(m_shrink, {}, {{BASE_COLOUR_UNIT, &from.colour}, {NORMAL_UNIT, &from.surface}});
        const glm::ivec2 size = to.colour.size();
        const auto keep = [&](const gl::Texture& sheet, const gl::Texture& array) {
            glCopyImageSubData(sheet.id(), GL_TEXTURE_2D, 0, 0, 0, 0, array.id(), GL_TEXTURE_2D_ARRAY, int(i) - 1, 0, 0,
                               layer, size.x, size.y, 1);
        };
        keep(to.colour, atlas.colours());
        keep(to.surface, atlas.surfaces());
    }
}

} // namespace renderer
