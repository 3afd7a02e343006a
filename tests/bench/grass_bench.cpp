// What grass costs: the valley's camp with and without it, against as many bare strips of seven vertices in the same run. Times are of
// all of the process' threads.
// usage: grass_bench [PROJECT] [FRAMES]
#include "app/drawing_settings.h"
#include "app/headless.h"
#include "io/base/paths.h"
#include "io/files/json.h"
#include "io/files/project.h"
#include "renderer/device.h"
#include "renderer/eye.h"
#include "renderer/gl/buffer.h"
#include "renderer/gl/framebuffer.h"
#include "renderer/gl/program.h"
#include "renderer/gl/state.h"
#include "renderer/renderer.h"
#include "tests/bench/clock.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <string>

namespace {

constexpr glm::ivec2 kSize{1280, 720};
constexpr double kReach = 35; // m, as far as medium grows grass

constexpr const char* kVertex = R"(#version 450 core
layout(location = 0) in vec4 root; // from the eye, m; the height
layout(location = 0) uniform mat4 clip;
out vec3 colour;
void main()
{
    float t = float(gl_VertexID >> 1) / 3.0;
    float side = gl_VertexID == 6 ? 0.0 : float(gl_VertexID & 1) - 0.5;
    colour = vec3(0.1, 0.2, 0.05) * (0.5 + t);
    gl_Position = clip * vec4(root.xyz + vec3(side * 0.024 * (1.0 - t), t * root.w, 0.0), 1.0);
}
)";
constexpr const char* kFragment = R"(#version 450 core
in vec3 colour;
layout(location = 0) out vec4 outColour;
void main() { outColour = vec4(colour, 1.0); }
)";

GLuint compile(GLuint program, GLenum stage, const char* text)
{
    const GLuint shader = glCreateShader(stage);
    glShaderSource(shader, 1, &text, nullptr);
    glCompileShader(shader);
    glAttachShader(program, shader);
    return shader;
}

// Strips that stand in the sector that the camera sees, on level ground below it.
std::vector<glm::vec4> roots(std::size_t count, const renderer::Eye& eye)
{
    std::mt19937 random{1};
    std::uniform_real_distribution<double> unit{0, 1};
    std::vector<glm::vec4> made;
    while (made.size() < count) {
        const double away = kReach * std::sqrt(unit(random)), angle = unit(random) * 6.2831853;
        const glm::dvec3 at{away * std::cos(angle), -1.7, away * std::sin(angle)};
        const glm::dvec4 clip = eye.clipFromRelative * glm::dvec4{at, 1};
        if (clip.w > 0 && std::abs(clip.x) < clip.w && std::abs(clip.y) < clip.w) made.emplace_back(glm::vec3{at}, 0.2f + 0.26f * float(unit(random)));
    }
    return made;
}

double bareMs(std::size_t count, const renderer::Eye& eye, int frames)
{
    namespace gl = renderer::gl;
    const GLuint program = glCreateProgram();
    compile(program, GL_VERTEX_SHADER, kVertex);
    compile(program, GL_FRAGMENT_SHADER, kFragment);
    glLinkProgram(program);
    const gl::Texture colour{{.label = "bare colour", .size = kSize, .format = GL_RGBA8, .target = true}};
    const gl::Texture depth{{.label = "bare depth", .size = kSize, .format = GL_DEPTH_COMPONENT32F, .filter = GL_NEAREST, .target = true}};
    const gl::Framebuffer target{{.label = "bare", .colours = {&colour}, .depth = &depth}};
    const std::vector<glm::vec4> at = roots(count, eye);
    gl::Buffer buffer{"bare roots", at.size() * sizeof(at[0])};
    buffer.write(0, std::as_bytes(std::span{at}));
    gl::VertexArray array{"bare strips"};
    array.attribute(0, 0, 4, GL_FLOAT, 0);
    array.perInstance(0);
    array.source(0, buffer.id(), 0, sizeof(glm::vec4));
    const glm::mat4 clip{eye.clipFromRelative};
    std::vector<double> times;
    for (int i = 0; i < frames + 3; ++i) {
        target.clearDepth(0);
        target.clearColour(0, glm::vec4{0});
        renderer::waitForDevice();
        const double start = bench::processMs();
        target.bind();
        gl::apply({.depthTest = GL_GREATER, .depthWrite = true});
        glUseProgram(program);
        glProgramUniformMatrix4fv(program, 0, 1, GL_FALSE, &clip[0][0]);
        glBindVertexArray(array.id());
        glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 7, GLsizei(at.size()));
        renderer::waitForDevice();
        if (i >= 3) times.push_back(bench::processMs() - start);
    }
    glDeleteProgram(program);
    return bench::share(times, 0.5);
}

int fault(const io::Error& error)
{
    std::fprintf(stderr, "grass_bench: %s\n", error.text().c_str());
    return 1;
}

} // namespace

int main(int count, char** arguments)
{
    const std::string project = count > 1 ? arguments[1] : "projects/valley";
    const int frames = count > 2 ? std::atoi(arguments[2]) : 15;
    io::Complaints complaints;
    auto world = io::openWorld(project, {}, complaints);
    if (!world) return fault(world.error());
    auto assets = io::readAssets(*world, complaints);
    if (!assets) return fault(assets.error());
    const auto context = app::makeHeadless();
    if (!context) return fault(context.error());
    auto made = renderer::Renderer::create({.shaders = io::resource("renderer/shaders")});
    if (!made) return fault(made.error());
    renderer::Renderer& drawn = **made;
    drawn.update(world->scene, *assets, {.everything = true});

    renderer::FrameInput in;
    in.size = kSize;
    if (const io::Camera* camp = world->scene.findCamera("camp")) in.camera = *camp;
    app::applyQuality(app::Quality::Medium, renderer::describeDevice().name, in.settings);
    const int most = in.settings.mostBlades;
    enum { kWith, kPlaced, kWithout, kWays };
    std::uint64_t blades = 0;
    // Medians of a picture of this kind with grass, less that with it placed only, and less that without; all by turns, so that they see
    // the same machine.
    struct Cost {
        double frame = 0, drawing = 0, all = 0; // ms
    };
    const auto costOf = [&](renderer::Show show) {
        in.show = show;
        std::vector<double> frame, drawing, all;
        for (int i = 0; i < frames + 3; ++i) {
            double took[kWays];
            for (int way = 0; way < kWays; ++way) {
                in.settings.grass = way != kWithout;
                in.settings.mostBlades = way == kPlaced ? 0 : most; // placed, but none has room
                const double start = bench::processMs();
                drawn.render(in);
                renderer::waitForDevice();
                took[way] = bench::processMs() - start;
                if (way == kWith) blades = std::max(blades, std::uint64_t(drawn.stats().grassDrawn));
            }
            if (i < 3) continue;
            frame.push_back(took[kWith]);
            drawing.push_back(took[kWith] - took[kPlaced]);
            all.push_back(took[kWith] - took[kWithout]);
        }
        return Cost{bench::share(frame, 0.5), bench::share(drawing, 0.5), bench::share(all, 0.5)};
    };
    const Cost lit = costOf(renderer::Show::Final), unlit = costOf(renderer::Show::Albedo);
    const double bare = bareMs(blades, renderer::eyeOf(in.camera, kSize), frames);
    const double each = 1e3 / double(blades); // us of a ms
    std::puts(io::writeJson(io::Value::Object{{"blades", double(blades)},
                                              {"frame_ms", lit.frame},
                                              {"grass_ms", lit.all},
                                              {"grass_share", lit.all / lit.frame},
                                              {"us_a_blade", unlit.all * each},
                                              {"us_a_blade_drawn", unlit.drawing * each},
                                              {"us_a_bare_strip", bare * each},
                                              {"gl_renderer", renderer::describeDevice().name}})
                  .c_str());
    return 0;
}
