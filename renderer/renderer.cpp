#include "renderer/renderer.h"

#include "io/base/contract.h"
#include "renderer/state.h"

#include <algorithm>
#include <fmt/format.h>

namespace renderer {
namespace {

io::Result<void> checkContext()
{
    if (epoxy_gl_version() < 45)
        return io::Error{"OpenGL", fmt::format("version 4.5 is needed, this context has {}.{}; update the graphics driver",
                                               epoxy_gl_version() / 10, epoxy_gl_version() % 10)};
    return {};
}

std::string glText(GLenum name)
{
    const GLubyte* text = glGetString(name);
    return text ? reinterpret_cast<const char*>(text) : "unknown";
}

// GL counts rows from the bottom.
template <class T>
void flipRows(std::vector<T>& rows, std::size_t rowLength)
{
    const std::size_t count = rows.size() / std::max<std::size_t>(rowLength, 1);
    for (std::size_t y = 0; y < count / 2; ++y)
        std::swap_ranges(rows.begin() + std::ptrdiff_t(y * rowLength), rows.begin() + std::ptrdiff_t((y + 1) * rowLength),
                         rows.begin() + std::ptrdiff_t((count - 1 - y) * rowLength));
}

io::Image readTexture(const gl::Texture& texture, int channels, io::PixelType type, GLenum format, GLenum glType)
{
    io::Image image{.size = texture.size(), .channels = channels, .type = type};
    image.bytes.resize(image.rowBytes() * std::size_t(image.size.y));
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glGetTextureImage(texture.id(), 0, format, glType, GLsizei(image.bytes.size()), image.bytes.data());
    glPixelStorei(GL_PACK_ALIGNMENT, 4);
    flipRows(image.bytes, image.rowBytes());
    return image;
}

} // namespace

Renderer::State::State(const Options& options)
    : debug{options.debug}, shaders{options.shaders}, impostors{shaders, options.kept}, chooser{shaders}, pyramid{shaders}, clouds{shaders}, skyTables{shaders}, shadow{shaders}, geometry{shaders}, grass{shaders},
      lamps{shaders}, occlusion{shaders}, lighting{shaders}, sky{shaders}, shafts{shaders}, water{shaders}, transparent{shaders}, particles{shaders},
      precipitation{shaders}, temporal{shaders}, exposure{shaders}, bloom{shaders}, toneMap{shaders}, smoothing{shaders}, show{shaders},
      overlay{shaders}, thumbnails{shaders}
{
}

Renderer::Renderer(std::unique_ptr<State> state) : m_state{std::move(state)} {}
Renderer::~Renderer() = default;

io::Result<std::unique_ptr<Renderer>> Renderer::create(Options options)
{
    if (io::Status status = checkContext(); !status) return status.error();
    auto state = std::make_unique<State>(options);
    if (!state->shaders.faults().empty()) {
        const ShaderFault& fault = state->shaders.faults().front();
        return io::Error{fault.where, fault.what};
    }
    return std::unique_ptr<Renderer>{new Renderer{std::move(state)}};
}

void Renderer::update(const io::Scene& scene, const io::Assets& assets, const io::Changes& changes)
{
    Scenery& scenery = m_state->scenery;
    if (changes.environment || changes.everything) scenery.environment = scene.environment();
    scenery.terrain.update(scene, assets, changes);
    scenery.world.update(scene, assets, changes);
    scenery.lamps.update(scene, changes);
    scenery.grass.update(scene, changes);
    scenery.particles.update(scene, changes);
    if (changes.everything) {
        m_state->thumbnails.forgetAll();
        m_state->frozen.reset(); // of another world: the next frame is kept instead
        m_state->last.reset();
    }
    for (const io::TemplateId id : changes.templates)
        m_state->thumbnails.forget(id);
}

void Renderer::move(std::span<const io::Moved> things)
{
    for (const io::Moved& thing : things)
        m_state->scenery.world.move(thing.id, thing.transform);
}

Picture Renderer::render(const FrameInput& input)
{
    FrameInput in = input;
    in.settings = forScene(in.settings, in.environment ? *in.environment : m_state->scenery.environment);
    return m_state->render(in);
}

io::Image Renderer::readPicture()
{
    if (!m_state->canvas.texture) return {};
    io::Image image = readTexture(m_state->canvas.texture, 4, io::PixelType::U8, GL_RGBA, GL_UNSIGNED_BYTE);
    for (std::size_t i = 3; i < image.bytes.size(); i += 4) // held brightness until here
        image.bytes[i] = std::byte{255};
    return image;
}

io::Image Renderer::readRadiance()
{
    if (!m_state->radiance) return {};
    return readTexture(m_state->radiance->texture, 3, io::PixelType::F32, GL_RGB, GL_FLOAT);
}

std::vector<std::uint32_t> Renderer::readIds(glm::ivec2 topLeft, glm::ivec2 size)
{
    const gl::Texture& ids = m_state->geometry.targets().id;
    std::vector<std::uint32_t> result(std::size_t(std::max(size.x, 0)) * std::size_t(std::max(size.y, 0)), 0);
    if (!ids || result.empty()) return result;
    EXPECTS(m_state->geometry.keepsIds());
    const glm::ivec2 low = glm::max(topLeft, glm::ivec2{0});
    const glm::ivec2 high = glm::min(topLeft + size, ids.size());
    const glm::ivec2 part = high - low;
    if (part.x <= 0 || part.y <= 0) return result;
    std::vector<std::uint32_t> read(std::size_t(part.x) * part.y);
    glGetTextureSubImage(ids.id(), 0, low.x, ids.size().y - high.y, 0, part.x, part.y, 1, GL_RED_INTEGER, GL_UNSIGNED_INT,
                         GLsizei(read.size() * sizeof(std::uint32_t)), read.data());
    flipRows(read, std::size_t(part.x));
    for (int y = 0; y < part.y; ++y)
        std::copy_n(read.begin() + std::ptrdiff_t(y) * part.x, part.x,
                    result.begin() + std::ptrdiff_t(low.y - topLeft.y + y) * size.x + (low.x - topLeft.x));
    return result;
}

double Renderer::readExposure()
{
    if (m_state->exposure.chosen()) return m_state->exposure.read();
    return m_state->exposureByHand;
}

Picture Renderer::thumbnail(io::TemplateId id, int pixels)
{
    const int side = std::clamp(pixels, 8, 1024);
    if (const Picture kept = m_state->thumbnails.kept(id, side); kept.texture) return kept;
    const FrameStats shown = m_state->stats; // stay those of the picture
    Picture made;
    {
        GpuFrame gpu{m_state->stream, m_state->timers, m_state->stats, m_state->empty};
        made = m_state->thumbnails.make(gpu, m_state->scenery.world, id, side);
    }
    m_state->stats = shown;
    return made;
}

const FrameStats& Renderer::stats() const
{
    return m_state->stats;
}

std::span<const ShaderFault> Renderer::shaderFaults() const
{
    return m_state->shaders.faults();
}

void Renderer::reloadShaders()
{
    m_state->shaders.reload();
}

std::string Renderer::deviceName() const
{
    return glText(GL_RENDERER) + ", OpenGL " + glText(GL_VERSION);
}

std::uint64_t Renderer::glErrors() const
{
    return m_state->debug.errors();
}

} // namespace renderer
