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
#include "renderer/shaders/shared/grass.h"
#include "tests/bench/clock.h"

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <span>
#include <string>

namespace {

constexpr glm::ivec2 kSize{1280, 720};
constexpr const char* kVertex = R"(#version 450 core
layout(location = 0) in vec3 root; // from the eye, m
layout(location = 1) in vec2 size; // height, width, m
layout(location = 0) uniform mat4 clip;
layout(location = 1) uniform vec3 right;
out vec3 colour;
void main()
{
    float t = float(gl_VertexID >> 1) / 3.0;
    float side = gl_VertexID == 6 ? 0.0 : float(gl_VertexID & 1) - 0.5;
    colour = vec3(0.1, 0.2, 0.05) * (0.5 + t);
    gl_Position = clip * vec4(root + right * (side * size.y * (1.0 - t * t * 0.75)) + vec3(0.0, t * size.x, 0.0), 1.0);
}
)";
constexpr const char* kFragment = R"(#version 450 core
in vec3 colour;
layout(location = 0) out vec4 outColour;
layout(location = 1) out vec2 outNormal;
layout(location = 2) out vec4 outSurface;
void main()
{
    outColour = vec4(colour, 1.0);
    outNormal = vec2(0.0);
    outSurface = vec4(0.5);
}
)";

GLuint compile(GLuint program, GLenum stage, const char* text)
{
    const GLuint shader = glCreateShader(stage);
    glShaderSource(shader, 1, &text, nullptr);
    glCompileShader(shader);
    glAttachShader(program, shader);
    return shader;
}

// The renderer's buffer of that name in debuggers.
GLuint labelled(const std::string& name)
{
    constexpr GLuint kMost = 1 << 14;
    for (GLuint id = 1; id < kMost; ++id) {
        char label[64] = "";
        if (glIsBuffer(id)) glGetObjectLabel(GL_BUFFER, id, sizeof label, nullptr, label);
        if (name == label) return id;
    }
    return 0;
}

// Those of the last frame.
std::vector<glsl::GrassBlade> drawnBlades()
{
    glsl::GrassCounts counts{};
    glGetNamedBufferSubData(labelled("grass counts"), 0, sizeof counts, &counts);
    const GLuint buffer = labelled("grass blades");
    GLint bytes = 0;
    glGetNamedBufferParameteriv(buffer, GL_BUFFER_SIZE, &bytes);
    const std::size_t room = std::size_t(bytes) / sizeof(glsl::GrassBlade) / GRASS_SHAPES;
    std::vector<glsl::GrassBlade> blades;
    for (std::size_t shape = 0; shape < GRASS_SHAPES; ++shape) {
        std::vector<glsl::GrassBlade> some(std::min<std::size_t>(counts.shape[shape], room));
        glGetNamedBufferSubData(buffer, GLintptr(shape * room * sizeof some[0]), GLsizeiptr(some.size() * sizeof some[0]), some.data());
        blades.insert(blades.end(), some.begin(), some.end());
    }
    return blades;
}

// As many strips as blades, where those stand and as large, into targets like those of the GBuffer.
double bareMs(std::span<const glsl::GrassBlade> blades, const renderer::Eye& eye, int frames)
{
    namespace gl = renderer::gl;
    const GLuint program = glCreateProgram();
    compile(program, GL_VERTEX_SHADER, kVertex);
    compile(program, GL_FRAGMENT_SHADER, kFragment);
    glLinkProgram(program);
    const gl::Texture colour{{.label = "bare colour", .size = kSize, .format = GL_RGBA8, .target = true}};
    const gl::Texture depth{{.label = "bare depth", .size = kSize, .format = GL_DEPTH_COMPONENT32F, .filter = GL_NEAREST, .target = true}};
    const gl::Texture normal{{.label = "bare normal", .size = kSize, .format = GL_RG16_SNORM, .target = true}};
    const gl::Texture surface{{.label = "bare surface", .size = kSize, .format = GL_RGBA8, .target = true}};
    const gl::Framebuffer target{{.label = "bare", .colours = {&colour, &normal, &surface}, .depth = &depth}};
    gl::Buffer buffer{"bare strips", blades.size_bytes()};
    buffer.write(0, std::as_bytes(blades));
    gl::VertexArray array{"bare strips"};
    array.attribute(0, 0, 3, GL_FLOAT, 0);
    array.attribute(1, 0, 2, GL_HALF_FLOAT, offsetof(glsl::GrassBlade, size));
    array.perInstance(0);
    array.source(0, buffer.id(), 0, sizeof(glsl::GrassBlade));
    const glm::mat4 clip{eye.clipFromRelative};
    const glm::vec3 right{glm::normalize(glm::dvec3{eye.clipFromRelative[0][0], eye.clipFromRelative[1][0], eye.clipFromRelative[2][0]})};
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
        glProgramUniform3fv(program, 1, 1, &right[0]);
        glBindVertexArray(array.id());
        glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 7, GLsizei(blades.size()));
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
    enum { kWith, kWithout, kWays };
    std::uint64_t blades = 0;
    // Medians of a picture of this kind with grass, and of what one without takes less, by turns, so that they see the same machine.
    struct Cost {
        double frame = 0, grass = 0; // ms
    };
    const auto costOf = [&](renderer::Show show) {
        in.show = show;
        std::vector<double> frame, grass;
        for (int i = 0; i < frames + 3; ++i) {
            double took[kWays];
            for (int way = 0; way < kWays; ++way) {
                in.settings.grass = way != kWithout;
                drawn.render(in); // what grass keeps out of is drawn anew after a picture without
                renderer::waitForDevice();
                const double start = bench::processMs();
                drawn.render(in);
                renderer::waitForDevice();
                took[way] = bench::processMs() - start;
                if (way == kWith) blades = std::max(blades, std::uint64_t(drawn.stats().grassDrawn));
            }
            if (i < 3) continue;
            frame.push_back(took[kWith]);
            grass.push_back(took[kWith] - took[kWithout]);
        }
        return Cost{bench::share(frame, 0.5), bench::share(grass, 0.5)};
    };
    in.ids = false; // as when somebody plays
    const Cost lit = costOf(renderer::Show::Final), unlit = costOf(renderer::Show::Albedo);
    const std::uint64_t plants = blades;
    // Kinds that grow as models are no blades: what those cost is told apart.
    io::Grass bladed = world->scene.grass();
    for (io::GrassKind& kind : bladed.kinds)
        if (!kind.plant.empty()) kind.density = 0;
    world->scene.exchange(bladed);
    drawn.update(world->scene, *assets, {.grass = true});
    blades = 0;
    const Cost alone = costOf(renderer::Show::Albedo);
    in.settings.grass = true;
    drawn.render(in);
    renderer::waitForDevice();
    const std::vector<glsl::GrassBlade> stood = drawnBlades();
    const double bare = bareMs(stood, renderer::eyeOf(in.camera, kSize), frames);
    std::puts(io::writeJson(io::Value::Object{{"plants", double(plants)},
                                              {"blades", double(stood.size())},
                                              {"frame_ms", lit.frame},
                                              {"grass_ms", lit.grass},
                                              {"grass_share", lit.grass / lit.frame},
                                              {"us_a_plant", 1e3 * unlit.grass / double(plants)},
                                              {"us_a_blade", 1e3 * alone.grass / double(stood.size())},
                                              {"us_a_bare_strip", 1e3 * bare / double(stood.size())},
                                              {"blade_to_bare", alone.grass / bare},
                                              {"gl_renderer", renderer::describeDevice().name}})
                  .c_str());
    return 0;
}
