#include "projects/make/valley.h"
#include "projects/make/valley_land.h"
#include "projects/make/worlds.h"

namespace make {
namespace {

std::vector<io::TerrainLayer> layers()
{
    io::TerrainLayer meadow = layer("Meadow", "ground_grass", 3.2f);

    io::TerrainLayer knolls = layer("Dry meadow", "ground_dry", 3.4f); // on the plain's low knolls
    knolls.altitude = {34.6f, 46};
    knolls.slope = {0, 14};
    knolls.blend = 0.05f;
    knolls.colour = {0.85f, 0.9f, 0.75f};

    io::TerrainLayer floor = layer("Forest floor", "ground_forest", 3.6f);
    floor.altitude = {52, 1e5f};
    floor.blend = 0.5f;

    io::TerrainLayer dry = layer("Dry grass", "ground_dry", 3.4f);
    dry.altitude = {165, 1e5f};
    dry.blend = 0.9f;

    io::TerrainLayer scree = layer("Scree", "ground_scree", 4);
    scree.slope = {33, 90};
    scree.altitude = {40, 1e5f};
    scree.blend = 0.35f;

    io::TerrainLayer rock = layer("Rock", "ground_rock", 9);
    rock.slope = {39, 90};
    rock.altitude = {38, 1e5f};
    rock.blend = 0.3f;
    rock.roughness = 0.85f;

    io::TerrainLayer pebbles = layer("Pebbles", "ground_pebbles", 2.6f);
    pebbles.altitude = {-1e5f, 29.3f};
    pebbles.blend = 0.02f;
    pebbles.roughness = 0.8f;
    return {meadow, knolls, floor, dry, scree, rock, pebbles};
}

// A clear morning late in September.
io::Environment morning()
{
    io::Environment environment;
    environment.time = 8.8f;
    environment.dayOfYear = 264;
    environment.latitude = 49;
    environment.exposure = 3.6f;
    environment.sun.irradiance = {1.10f, 1.0f, 0.89f}; // a little warmer than the air alone makes it
    environment.clouds.coverage = 0.46f;
    environment.fog.density = 0.00022f;
    environment.fog.height = 90;
    environment.fog.base = 26;
    environment.fog.tint = {1.05f, 1.0f, 0.95f};
    return environment;
}

} // namespace

io::Status makeValley(const std::filesystem::path& folder, Textures& textures)
{
    Stage stage{folder, "Valley", makeValleyLand(), textures};
    stage.addModels(valleyEntries());
    stage.addMarker("spawn_point", {0.6f, 1.8f, 0.6f});
    stage.addMarker("point_of_interest", {0.5f, 0.5f, 0.5f});
    if (io::Status ground = stage.addGround(layers(), 1024, 0, kValleyTop); !ground) return ground;
    stage.setEnvironment(morning());
    setCamp(stage);
    layRocks(stage);
    plantForest(stage);
    plantUndergrowth(stage);
    setViews(stage);
    return stage.save();
}

} // namespace make
