#include "projects/make/looks.h"
#include "projects/make/valley.h"
#include "projects/make/valley_land.h"
#include "projects/make/worlds.h"

namespace make {
namespace {

std::vector<io::TerrainLayer> layers()
{
    return {{.name = "Meadow", .texture = "ground_grass", .colour = {1.06f, 1.04f, 0.92f}, .metres = 3.2f, .steps = "sounds/steps_grass.ogg"},
            {.name = "Dry meadow", // on the plain's low knolls
             .texture = "ground_dry",
             .colour = {0.92f, 0.98f, 0.78f},
             .metres = 3.4f,
             .slope = {0, 14},
             .altitude = {34.2f, 46},
             .blend = 0.10f,
             .steps = "sounds/steps_grass.ogg"},
            {.name = "Forest floor",
             .texture = "ground_forest",
             .colour = {1.2f, 1.1f, 1.0f},
             .metres = 3.6f,
             .altitude = {38, 1e5f},
             .blend = 0.22f,
             .steps = "sounds/steps_grass.ogg"},
            {.name = "Mossy slope", // where the ground holds its damp
             .texture = "ground_forest",
             .colour = {0.98f, 1.18f, 0.78f},
             .metres = 2.9f,
             .slope = {13, 26},
             .altitude = {40, 150},
             .blend = 0.5f,
             .steps = "sounds/steps_grass.ogg"},
            {.name = "Dry grass", .texture = "ground_dry", .metres = 3.4f, .altitude = {165, 1e5f}, .blend = 0.9f, .steps = "sounds/steps_grass.ogg"},
            {.name = "Scree",
             .texture = "ground_scree",
             .metres = 4,
             .slope = {33, 90},
             .altitude = {40, 1e5f},
             .blend = 0.35f,
             .steps = "sounds/steps_gravel.ogg"},
            {.name = "Rock",
             .texture = "ground_rock",
             .roughness = 0.85f,
             .metres = 9,
             .slope = {39, 90},
             .altitude = {38, 1e5f},
             .steps = "sounds/steps_gravel.ogg"},
            {.name = "Pebbles",
             .texture = "ground_pebbles",
             .roughness = 0.8f,
             .metres = 2.6f,
             .altitude = {-1e5f, 29.3f},
             .blend = 0.02f,
             .steps = "sounds/steps_gravel.ogg"}};
}

// A clear morning late in September.
io::Environment morning()
{
    io::Environment environment;
    environment.time = 8.8f;
    environment.dayOfYear = 264;
    environment.latitude = 49;
    environment.exposure = 3.6f;
    environment.sun.irradiance = {1.03f, 1.0f, 0.97f}; // a little warmer than the air alone makes it
    environment.clouds.coverage = 0.46f;
    environment.clouds.seed = 1; // the meadow lies in the sun
    environment.fog.density = 0.00022f;
    environment.fog.height = 90;
    environment.fog.base = 26;
    environment.fog.tint = {1.05f, 1.0f, 0.95f};
    environment.water.on = true; // fills the stream's bed, which lies lower than all else
    environment.water.level = 28.5f;
    environment.water.colour = {0.010f, 0.036f, 0.036f};
    environment.water.clarity = 1.6f;
    environment.water.waves = 0.05f;
    environment.water.wavelength = 2.4f;
    environment.water.foam = 0.35f;
    return environment;
}

} // namespace

io::Status makeValley(const std::filesystem::path& folder, Textures& textures)
{
    Stage stage{folder, "Valley", makeValleyLand(), textures};
    stage.addModels(valleyEntries());
    stage.addMarker("spawn_point", {0.6f, 1.8f, 0.6f});
    stage.edit("spawn_point", [](io::Template& t) { t.player.start = true; });
    stage.addMarker("point_of_interest", {0.5f, 0.5f, 0.5f});
    stage.addParticles("campfire_smoke", "Camp", smokeOfFire());
    if (io::Status sounds = addSounds(stage); !sounds) return sounds;
    if (io::Status ground = stage.addGround(layers(), 1024, 0, kValleyTop); !ground) return ground;
    stage.setEnvironment(morning());
    const io::ObjectId camp = setCamp(stage);
    layRocks(stage);
    plantForest(stage);
    plantUndergrowth(stage);
    plantFarForest(stage);
    smokeOverFire(stage, camp); // last, so that the numbers of others stay
    setSounds(stage);
    growGrass(stage);
    setViews(stage);
    return stage.save();
}

} // namespace make
