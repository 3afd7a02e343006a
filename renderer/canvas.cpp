#include "renderer/canvas.h"

#include "io/base/contract.h"
#include "renderer/gl/framebuffer.h"

#include <cstring>
#include <epoxy/gl.h>

namespace renderer {

struct Canvas::State {
    gl::Texture colour;
    gl::Framebuffer framebuffer;
};

Canvas::Canvas(glm::ivec2 size) : m_state{std::make_unique<State>()}
{
    EXPECTS(size.x > 0 && size.y > 0);
    m_state->colour = gl::Texture{{.label = "canvas", .size = size, .format = GL_RGBA8, .target = true}};
    m_state->framebuffer = gl::Framebuffer{{.label = "canvas", .colours = {&m_state->colour}}};
}

Canvas::~Canvas() = default;

glm::ivec2 Canvas::size() const
{
    return m_state->colour.size();
}

void Canvas::begin()
{
    glDisable(GL_SCISSOR_TEST);
    m_state->framebuffer.bind();
    m_state->framebuffer.clearColour(0, {0, 0, 0, 1});
}

io::Image Canvas::read()
{
    io::Image image{.size = size(), .channels = 3, .type = io::PixelType::U8};
    const std::size_t row = image.rowBytes(), rows = std::size_t(image.size.y);
    std::vector<std::byte> upward(row * rows);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, m_state->framebuffer.id());
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadnPixels(0, 0, image.size.x, image.size.y, GL_RGB, GL_UNSIGNED_BYTE, GLsizei(upward.size()), upward.data());
    image.bytes.resize(upward.size());
    for (std::size_t y = 0; y < rows; ++y)
        std::memcpy(image.bytes.data() + y * row, upward.data() + (rows - 1 - y) * row, row);
    return image;
}

void beginWindow(glm::ivec2 size)
{
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glDisable(GL_SCISSOR_TEST);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glViewport(0, 0, size.x, size.y);
    glClearColor(0, 0, 0, 1);
    glClear(GL_COLOR_BUFFER_BIT);
}

} // namespace renderer
