// The benchmark scenes: so many triangles of so many things, spread over one square kilometre, denser in the middle.
#include "projects/make/noise.h"
#include "projects/make/stage.h"
#include "projects/make/terrain_forms.h"
#include "projects/make/worlds.h"

#include <algorithm>
#include <cmath>

namespace make {
namespace {

struct Share {
    std::string_view what;
    int count;
    float room; // m
};

const Share kSets[] = {{"Rock2", 65, 1.6f},      {"Campfire", 3, 3},         {"Axe", 2, 0.6f},
                       {"Tree1", 657, 2.6f},     {"Tree2", 629, 2.6f},       {"AutumnTree1", 635, 2.0f},
                       {"Tree3", 651, 2.0f},     {"AutumnTree2", 676, 2.8f}, {"FirTree", 166, 2.0f},
                       {"DeadBranch", 65, 1.2f}, {"DeadTree", 172, 1.8f},    {"Stump", 1, 1.2f},
                       {"Stump2", 1, 1.5f}};
constexpr int kThings[] = {4, 6, 13}; // of kSets in set 1, 2, 3

io::HeightGrid hills()
{
    io::HeightGrid land = blankHeights(513, 2);
    fill(land, [](glm::vec2 p) {
        const glm::vec2 warp = 60.0f * glm::vec2{fbm(p / 300.0f, 3, {.count = 3}), fbm(p / 300.0f, 4, {.count = 3})};
        const float rim = glm::smoothstep(180.0f, 560.0f, glm::length(p));
        return 24 + 15 * fbm((p + warp) / 240.0f, 5, {.count = 5}) +
               rim * (10 + 46 * ridged((p + warp) / 330.0f, 6, {.count = 4}));
    });
    rainOn(land, {.drops = 120000, .steps = 44, .seed = 7});
    settle(land, 48, 4);
    land = doubled(land);
    rainOn(land, {.drops = 40000, .steps = 30, .strength = 0.6f, .seed = 8});
    return land;
}

// Most chances lie near the middle; the rest thins out to the borders.
glm::vec2 placeFor(Random& random)
{
    const float angle = random.range(0, 6.2831853f);
    const float away = 490 * std::pow(random.unit(), 0.85f);
    return away * glm::vec2{std::cos(angle), std::sin(angle)};
}

void spread(Stage& stage, const Share& share)
{
    Random random{hash(share.what)};
    int placed = 0;
    if (share.what == "Campfire" || share.what == "Axe") { // the first of each in the clearing
        stage.put({.what = share.what, .at = share.what == "Axe" ? glm::vec2{-1.5f, 2} : glm::vec2{-4, -3}}, random);
        ++placed;
    }
    for (int attempt = 0; placed < share.count; ++attempt) {
        const glm::vec2 at = placeFor(random);
        const float ease = attempt > 200000 ? 0.6f : 1.0f; // the middle is full: stand closer
        const bool clearing = glm::length(at) < 16 && share.what != "Campfire" && share.what != "Axe";
        if (clearing || slopeAt(stage.heights(), at) > 34 || !stage.isFree(at, share.room * ease)) continue;
        stage.put({.what = share.what, .at = at}, random);
        stage.take(at, share.room);
        ++placed;
    }
}

void setViews(Stage& stage)
{
    std::vector<io::Camera> cameras{
        cameraAt(stage, "start", {4, 1.7f, 5}, {-14, 4, -16}, 60),
        cameraAt(stage, "above", {-230, 70, 300}, {10, 0, -20}, 55),
        cameraAt(stage, "inside", {60, 2, -40}, {0, 4, 0}, 65),
    };
    io::CameraPath fly{.name = "fly"};
    for (int i = 0; i <= 8; ++i) { // one turn about the middle, sinking towards the trees and out again
        const float angle = 6.2831853f * float(i) / 8 + 0.9f;
        const float away = i % 2 == 0 ? 250.0f : 170.0f;
        const float height = i % 2 == 0 ? 52.0f : 30.0f;
        fly.keys.push_back(keyAt(stage, 3.0 * i, {away * std::cos(angle), height, away * std::sin(angle)},
                                 {60 * std::cos(angle + 2.4f), 4, 60 * std::sin(angle + 2.4f)}));
    }
    stage.setViews(std::move(cameras), {std::move(fly)});
}

std::vector<io::TerrainLayer> layers()
{
    return {{.name = "Forest floor", .texture = "ground_forest", .metres = 3.6f},
            {.name = "Grass",
             .texture = "ground_grass",
             .metres = 3.2f,
             .slope = {0, 13},
             .altitude = {-1e5f, 34},
             .blend = 0.5f},
            {.name = "Scree", .texture = "ground_scree", .metres = 4, .slope = {27, 90}, .blend = 0.35f},
            {.name = "Rock", .texture = "ground_rock", .metres = 8, .slope = {36, 90}}};
}

} // namespace

io::Status makeForest(const std::filesystem::path& folder, int set, Textures& textures)
{
    static const io::HeightGrid land = hills();
    Stage stage{folder, "Forest " + std::to_string(set), land, textures};
    const auto things = std::span{kSets}.first(std::size_t(kThings[set - 1]));
    stage.addModels(forestEntries().first(things.size()));
    if (io::Status ground = stage.addGround(layers(), 512, 0, 400); !ground) return ground;
    io::Environment environment;
    environment.time = 10;
    environment.dayOfYear = 264;
    environment.exposure = 3.6f;
    environment.sky.ambient = 1.3f;
    environment.fog.density = 0.0005f;
    environment.fog.height = 120;
    stage.setEnvironment(environment);
    for (const Share& share : things)
        spread(stage, share);
    setViews(stage);
    return stage.save();
}

} // namespace make
