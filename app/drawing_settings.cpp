#include "app/drawing_settings.h"

#include "io/scene/field_value.h"

#include <array>
#include <fmt/format.h>

namespace app {
namespace {

// Software drawing pays for each triangle and each texel of the shadow maps, so that is what is spared.
struct Tier {
    Quality quality;
    int cascades, shadowMap;
    float shadowDistance; // m
    float lodPixels, meshLeeway;
    renderer::AntiAliasing antiAliasing;
    bool wind;
    int skyPixels;
    bool halfOcclusion, froxels;
    renderer::CloudKind clouds;
    int mostBlades;
    float grassDistance, grassDensity; // m; share
};
constexpr std::array<Tier, 4> kTiers{{{Quality::Low, 2, 512, 120, 3.5f, 1.5f, renderer::AntiAliasing::Off, false, 4, true, false, renderer::CloudKind::Layer, 8000, 35, 0.6f},
                                      {Quality::Medium, 4, 1024, 350, 3.0f, 1.5f, renderer::AntiAliasing::Scene, false, 4, true, false, renderer::CloudKind::Layer, 20'000, 60, 1},
                                      {Quality::High, 6, 2048, 1000, 1, 1, renderer::AntiAliasing::Scene, true, 1, false, true, renderer::CloudKind::Volume, 200'000, 150, 1},
                                      {Quality::Ultra, 6, 8192, 1e6f, 0.6f, 1, renderer::AntiAliasing::Scene, true, 1, false, true, renderer::CloudKind::Volume, 500'000, 250, 1}}};

// What a tier needs, a second. A frame of 1280x720 draws half a million triangles for the camera and each cascade.
struct Need {
    Quality quality;
    double triangles, arithmetic, taps;
};
constexpr std::array<Need, 3> kNeeds{{{Quality::Ultra, 1e9, 3e12, 2e10},
                                      {Quality::High, 1e8, 2e11, 1e9},
                                      {Quality::Medium, 1e6, 1e9, 1e7}}};

} // namespace

io::Status setDrawing(renderer::Settings& settings, std::string_view key, const io::Value& value)
{
    const io::Status set = io::setField(settings, key, value);
    if (!set) return io::Error{"render." + set.error().where, set.error().what};
    return {};
}

io::Result<io::Value> getDrawing(const renderer::Settings& settings, std::string_view key)
{
    return io::getField(settings, key);
}

Quality qualityFor(const renderer::DeviceSpeed& speed)
{
    for (const Need& need : kNeeds)
        if (speed.triangles >= need.triangles && speed.arithmetic >= need.arithmetic && speed.taps >= need.taps)
            return need.quality;
    return Quality::Low;
}

bool drawsInSoftware(std::string_view device)
{
    return device.find("llvmpipe") != device.npos || device.find("softpipe") != device.npos ||
           device.find("SwiftShader") != device.npos;
}

Quality applyQuality(Quality quality, std::string_view device, renderer::Settings& settings)
{
    if (quality == Quality::Auto) quality = drawsInSoftware(device) ? Quality::Medium : Quality::High;
    for (const Tier& tier : kTiers) {
        if (tier.quality != quality) continue;
        settings.mostCascades = tier.cascades;
        settings.largestShadowMap = tier.shadowMap;
        settings.farthestShadow = tier.shadowDistance;
        settings.lodPixels = tier.lodPixels;
        settings.meshLeeway = tier.meshLeeway;
        settings.antiAliasing = tier.antiAliasing;
        settings.wind = tier.wind;
        settings.skyPixels = tier.skyPixels;
        settings.halfOcclusion = tier.halfOcclusion;
        settings.groundDetail = quality >= Quality::High;
        settings.mostBlades = tier.mostBlades;
        settings.grassDistance = tier.grassDistance;
        settings.grassDensity = tier.grassDensity;
        settings.froxels = tier.froxels && !drawsInSoftware(device);
        settings.cloudKind = drawsInSoftware(device) ? renderer::CloudKind::Layer : tier.clouds;
        // Cheap where a card cuts triangles, dear where a processor does; what shows is the same.
        const bool cuts = quality >= Quality::High && !drawsInSoftware(device);
        settings.terrain = cuts ? renderer::GroundStages::Tessellation : renderer::GroundStages::Grid;
    }
    return quality;
}

} // namespace app
