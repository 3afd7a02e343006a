// What is heard in the valley: birds over the woods, the stream along its bed. The fire and the ground under one's feet have
// their sounds in their own templates and layers; wind.ogg is the wind of any project.
#include "projects/make/sounds.h"
#include "projects/make/valley.h"
#include "projects/make/valley_land.h"

namespace make {

io::Status addSounds(Stage& stage)
{
    stage.edit("campfire", [](io::Template& fire) {
        fire.sound = {.file = "sounds/fire.ogg", .volume = 0.9f, .radius = 24, .offset = {0, 0.4f, 0}};
    });
    for (const char* wooden : {"hut", "log", "stump", "stump_broken", "fence", "dead_tree"})
        stage.edit(wooden, [](io::Template& what) { what.steps = "sounds/steps_wood.ogg"; });
    for (const char* stone : {"boulder", "rock", "rock_mossy", "rock_slab", "rock_small"})
        stage.edit(stone, [](io::Template& what) { what.steps = "sounds/steps_gravel.ogg"; });
    stage.addSound("sound_birds", {.file = "sounds/birds.ogg",
                                   .group = io::SoundGroup::Ambience,
                                   .volume = 0.4f,
                                   .radius = 260,
                                   .falloff = {{0, 1}, {0.4f, 0.8f}, {1, 0}},
                                   .flat = true,
                                   .occluded = false,
                                   .hours = {5, 20.5f},
                                   .weather = io::SoundWeather::Dry});
    stage.addSound("sound_stream", {.file = "sounds/stream.ogg",
                                    .group = io::SoundGroup::Ambience,
                                    .volume = 0.5f,
                                    .radius = 48,
                                    .occluded = false,
                                    .offset = {0, 1.5f, 0}}); // over the water, which fills the bed
    return writeSounds(stage.folder());
}

void setSounds(Stage& stage)
{
    Random random{702};
    const io::ObjectId group = stage.addGroup("Sounds", kCamp);
    for (const glm::vec2 at : {kCamp + glm::vec2{-70, -20}, glm::vec2{-150, 330}, glm::vec2{-120, -260}})
        stage.put({.what = "sound_birds", .at = at, .yaw = 0, .scale = 1, .name = "Birds", .parent = group}, random);
    for (float z = -420; z <= 420; z += 40)
        stage.put({.what = "sound_stream", .at = {streamX(z), z}, .yaw = 0, .scale = 1, .name = "Stream", .parent = group}, random);
}

} // namespace make
