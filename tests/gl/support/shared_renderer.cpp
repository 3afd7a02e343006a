#include "tests/gl/support/shared_renderer.h"

#include "tests/gl/support/gl_context.h"

#include <cstdio>
#include <cstdlib>

namespace test {
namespace {

GlContext& context()
{
    static GlContext made;
    return made;
}

std::unique_ptr<renderer::Renderer> make()
{
    auto made = renderer::Renderer::create({.shaders = WOLD_SOURCE_DIR "/renderer/shaders", .debug = true});
    if (made) return std::move(*made);
    std::fprintf(stderr, "%s\n", made.error().text().c_str());
    std::abort();
}

} // namespace

bool haveContext()
{
    if (context().valid()) return true;
    static const int once = std::fprintf(stderr, "%s\n", context().fault().c_str());
    (void)once;
    return false;
}

renderer::Renderer& shared()
{
    if (!haveContext()) std::abort();
    static const std::unique_ptr<renderer::Renderer> made = make();
    return *made;
}

io::Environment plainEnvironment(float azimuth, float elevation)
{
    io::Environment environment;
    environment.exposure = 2;
    environment.sun.mode = io::SunMode::Manual;
    environment.sun.azimuth = azimuth;
    environment.sun.elevation = elevation;
    environment.clouds.coverage = 0;
    environment.fog.density = 0;
    environment.shadows.resolution = 1024;
    environment.grading.bloom = 0;
    environment.grading.vignette = 0;
    return environment;
}

void load(TestWorld& world)
{
    shared().update(world.scene, world.assets, {.everything = true});
}

renderer::FrameInput frame(glm::ivec2 size, const io::Camera& camera)
{
    renderer::FrameInput in;
    in.camera = camera;
    in.size = size;
    in.settings.antiAliasing = renderer::AntiAliasing::Off;
    in.settings.culler = renderer::Culler::Cpu; // whose counts are of this very frame; tests of the GPU's say so
    return in;
}

double brightnessAt(const io::Image& image, const io::Camera& camera, const glm::dvec3& place, int radius)
{
    const auto pixel = renderer::project(camera, image.size, place);
    if (!pixel) return -1;
    double sum = 0;
    int count = 0;
    for (int y = int(pixel->y) - radius; y <= int(pixel->y) + radius; ++y)
        for (int x = int(pixel->x) - radius; x <= int(pixel->x) + radius; ++x) {
            if (x < 0 || y < 0 || x >= image.size.x || y >= image.size.y) continue;
            const glm::u8vec4 texel = image.row<glm::u8vec4>(y)[x];
            sum += (texel.x + texel.y + texel.z) / 3.0;
            ++count;
        }
    return count ? sum / count : -1;
}

} // namespace test
