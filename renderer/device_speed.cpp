#include "renderer/device_speed.h"

#include "renderer/gl/framebuffer.h"
#include "renderer/gl/program.h"
#include "renderer/gl/state.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdint>
#include <functional>
#include <vector>

namespace renderer {
namespace {

constexpr int kBoxes = 10'000, kTrianglesOfBox = 12;
constexpr int kSteps = 64, kOperationsOfStep = 8; // a fused multiply-add of four numbers
constexpr int kTaps = 16;
constexpr glm::ivec2 kSize{256};
constexpr double kLongEnough = 0.002; // s; what is over sooner is drawn more often
constexpr double kTooLong = 0.15;     // s; not done again, for a person waits
constexpr int kMostOften = 256;

constexpr const char* kBoxVertices = R"(#version 450 core
void main()
{
    int corner = gl_VertexID % 6, face = gl_VertexID / 6, axis = face / 2;
    vec2 uv = vec2(corner == 1 || corner == 2 || corner == 4, corner >= 2 && corner != 3);
    vec3 p = vec3(face % 2, uv);
    p = axis == 0 ? p : axis == 1 ? p.zxy : p.yzx;
    vec2 cell = vec2(gl_InstanceID % 100, gl_InstanceID / 100);
    gl_Position = vec4((cell + p.xy * 0.8 + p.z * 0.1) / 50.0 - 1.0, p.z * 0.5, 1);
}
)";
constexpr const char* kScreenVertices = R"(#version 450 core
void main()
{
    gl_Position = vec4(gl_VertexID == 1 ? 3 : -1, gl_VertexID == 2 ? 3 : -1, 0, 1);
}
)";
constexpr const char* kPlainFragments = R"(#version 450 core
layout(location = 0) out vec4 colour;
void main() { colour = vec4(0.5); }
)";
constexpr const char* kArithmeticFragments = R"(#version 450 core
layout(location = 0) out vec4 colour;
void main()
{
    vec4 x = gl_FragCoord / 256.0, a = vec4(0.7, -0.8, 0.9, 0.6) + gl_FragCoord.x * 1e-5;
    for (int i = 0; i < 64; ++i)
        x = x * a + a.wzyx;
    colour = x;
}
)";
constexpr const char* kTapFragments = R"(#version 450 core
layout(binding = 0) uniform sampler2D image;
layout(location = 0) out vec4 colour;
void main()
{
    vec4 sum = vec4(0);
    for (int i = 0; i < 16; ++i)
        sum += texture(image, gl_FragCoord.xy / 256.0 + vec2(i * 0.37, i * i * 0.11));
    colour = sum / 16.0;
}
)";

gl::Program programOf(const char* label, const char* vertices, const char* fragments)
{
    const std::array<gl::StageText, 2> stages{
        {{.stage = GL_VERTEX_SHADER, .text = vertices}, {.stage = GL_FRAGMENT_SHADER, .text = fragments}}};
    gl::BuildLog log;
    return gl::link(label, stages, log);
}

struct DeleteVertexArray {
    void operator()(GLuint id) const { glDeleteVertexArrays(1, &id); }
};

double secondsOf(const std::function<void()>& draw, int times)
{
    using Clock = std::chrono::steady_clock;
    glFinish();
    const Clock::time_point start = Clock::now();
    for (int i = 0; i < times; ++i)
        draw();
    glFinish();
    return std::chrono::duration<double>(Clock::now() - start).count();
}

// How often a second; the median of three, after one that lets the driver compile.
double rateOf(const std::function<void()>& draw)
{
    const double first = secondsOf(draw, 1);
    if (first > kTooLong) return 1 / first;
    int times = 1;
    while (first < 10 * kLongEnough && times < kMostOften && secondsOf(draw, times) < kLongEnough)
        times *= 4;
    std::array<double, 3> seconds{};
    for (double& one : seconds)
        one = secondsOf(draw, times);
    std::ranges::sort(seconds);
    return times / std::max(seconds[1], 1e-9);
}

gl::Texture noise()
{
    gl::Texture texture{{.label = "speed", .size = kSize, .wrap = GL_REPEAT}};
    std::vector<std::uint32_t> pixels(std::size_t(kSize.x) * kSize.y);
    std::uint32_t number = 1;
    for (std::uint32_t& pixel : pixels)
        pixel = number = number * 1664525u + 1013904223u;
    texture.upload(pixels.data(), GL_RGBA, GL_UNSIGNED_BYTE);
    return texture;
}

} // namespace

DeviceSpeed measureDevice()
{
    const gl::Program boxes = programOf("speed of triangles", kBoxVertices, kPlainFragments);
    const gl::Program arithmetic = programOf("speed of arithmetic", kScreenVertices, kArithmeticFragments);
    const gl::Program taps = programOf("speed of taps", kScreenVertices, kTapFragments);
    if (!boxes || !arithmetic || !taps) return {};
    const gl::Texture colour{{.label = "speed", .size = kSize, .format = GL_RGBA8}}, image = noise();
    const gl::Framebuffer target{{.label = "speed", .colours = {&colour}}};
    GLuint made = 0;
    glCreateVertexArrays(1, &made);
    const gl::Handle<DeleteVertexArray> empty{made};

    gl::apply({});
    target.bind();
    glBindVertexArray(empty.get());
    glBindTextureUnit(0, image.id());
    const double pixels = double(kSize.x) * kSize.y;
    DeviceSpeed speed;
    glUseProgram(boxes.id());
    speed.triangles =
        rateOf([] { glDrawArraysInstanced(GL_TRIANGLES, 0, 3 * kTrianglesOfBox, kBoxes); }) * kBoxes * kTrianglesOfBox;
    glUseProgram(arithmetic.id());
    speed.arithmetic = rateOf([] { glDrawArrays(GL_TRIANGLES, 0, 3); }) * pixels * kSteps * kOperationsOfStep;
    glUseProgram(taps.id());
    speed.taps = rateOf([] { glDrawArrays(GL_TRIANGLES, 0, 3); }) * pixels * kTaps;
    glUseProgram(0);
    glBindVertexArray(0);
    glBindTextureUnit(0, 0);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    gl::restoreDefaults();
    return speed;
}

} // namespace renderer
