// A starter: gentle hills, grass and rock, a handful of things to place.
#include "projects/make/noise.h"
#include "projects/make/stage.h"
#include "projects/make/terrain_forms.h"
#include "projects/make/worlds.h"

namespace make {

io::Status makeEmpty(const std::filesystem::path& folder, Textures& textures)
{
    io::HeightGrid land = blankHeights(513, 1);
    fill(land, [](glm::vec2 p) {
        const float away = glm::smoothstep(15.0f, 200.0f, glm::length(p)); // level where one starts
        return 8 + away * (11 + 26 * fbm(p / 170.0f, 11, {.count = 5}));
    });
    Stage stage{folder, "Empty", land, textures};
    for (const char* name : {"oak", "fir", "rock_mossy", "bush"})
        stage.addModels({&entryOf(name), 1});
    stage.addMarker("spawn_point", {0.6f, 1.8f, 0.6f});
    const std::vector<io::TerrainLayer> layers{
        {.name = "Grass", .texture = "ground_grass", .metres = 3.2f},
        {.name = "Dry grass", .texture = "ground_dry", .metres = 3.4f, .slope = {9, 90}, .blend = 0.5f},
        {.name = "Scree", .texture = "ground_scree", .metres = 4, .slope = {22, 90}},
        {.name = "Rock", .texture = "ground_rock", .metres = 8, .slope = {36, 90}}};
    if (io::Status ground = stage.addGround(layers, 512, -20, 60); !ground) return ground;
    io::Environment environment;
    environment.time = 9.5f;
    environment.exposure = 3.3f;
    environment.clouds.coverage = 0.4f;
    environment.fog.density = 0.0004f;
    stage.setEnvironment(environment);
    stage.setViews({cameraAt(stage, "start", {0, 9, 46}, {0, 4, 0}, 60)}, {});
    return stage.save();
}

} // namespace make
