// A world with grass all over it, and what a look at it finds.
#pragma once

#include "renderer/passes/grass.h"
#include "renderer/wind.h"
#include "tests/gl/support/pass_bench.h"
#include "tests/gl/support/shared_renderer.h"
#include "tests/gl/support/test_world.h"

#include <cmath>
#include <glm/gtc/packing.hpp>
#include <set>
#include <tuple>
#include <vector>

namespace test {

struct Plant {
    glm::dvec3 root{0}; // m, world
    float height = 0, width = 0; // m
    int kind = 0;
    std::uint32_t ground = 0; // its colour there
    glm::vec2 bend{0};        // rad, along x and z
};

inline io::GrassKind meadow()
{
    return {.name = "meadow", .density = 32, .height = {0.2f, 0.4f}};
}

// A world with grass all over it, and the pass that places it.
class Meadow {
public:
    explicit Meadow(io::GrassCover cover = {{0, 0}, {1, 0}, 1}, std::vector<io::GrassKind> kinds = {meadow()})
        : m_world{makeWorld({.heightMap = {257, 257}, .metresPerTexel = 1, .trees = 0, .boxes = 0})}, m_pass{m_bench.shaders}, m_geometry{m_bench.shaders}
    {
        const glm::dvec2 corner = m_world.scene.heights()->origin;
        io::TexelTiles<std::uint32_t> field{glm::ivec2{513, 513}};
        const std::vector<std::uint32_t> all(513u * 513u, io::packed(cover));
        m_world.scene.exchange(io::Grass{.map = "terrain/grass.png", .metresPerTexel = 0.5, .origin = corner, .kinds = std::move(kinds)});
        m_world.scene.exchange(std::make_shared<const io::GrassMap>(field.with(all, {513, 513}, {0, 0}), 0.5, corner));
        follow({.everything = true});
        settings.mostBlades = 300'000;
        settings.grassDistance = 60;
    }

    TestWorld& world() { return m_world; }
    renderer::Scenery& scenery() { return m_scenery; }
    void follow(const io::Changes& changes)
    {
        m_scenery.terrain.update(m_world.scene, m_world.assets, changes);
        m_scenery.world.update(m_world.scene, m_world.assets, changes);
        m_scenery.grass.update(m_world.scene, changes);
    }

    std::vector<Plant> look(const io::Camera& camera, glm::ivec2 size = {160, 90}, double seconds = 0)
    {
        renderer::Viewpoint v;
        v.eye = v.culledFor = renderer::eyeOf(camera, size);
        v.wind = renderer::windOf(io::Wind{}, true, v.eye.position, seconds);
        v.view = renderer::viewBlock(v.eye, v.eye.clipFromRelative, seconds, 0);
        m_bench.frame(v.view, [&](renderer::GpuFrame& gpu) {
            m_scenery.terrain.aim(v.eye, v.eye);
            m_scenery.footprints.update(m_scenery.world, m_scenery.terrain, v.eye.position, double(settings.grassDistance));
            m_scenery.world.forgetTouched();
            m_scenery.terrain.forgetTouched();
            m_geometry.begin(v, true);
            m_pass.render(gpu, m_geometry, {}, m_scenery, v, io::Environment{}, pressers, settings);
        });
        std::vector<Plant> plants;
        for (const glsl::GrassBlade& blade : m_pass.readBlades())
            plants.push_back({glm::dvec3{blade.root} + v.eye.position, glm::unpackHalf2x16(blade.size).x, glm::unpackHalf2x16(blade.size).y, int(blade.look >> 8 & 15), blade.ground, glm::unpackHalf2x16(blade.bend)});
        return plants;
    }

    std::vector<glsl::Instance> models(int kind) const { return m_pass.readPlants(kind); } // of the last look

    renderer::Settings settings;
    std::vector<renderer::Presser> pressers;

private:
    PassBench m_bench;
    TestWorld m_world;
    renderer::Scenery m_scenery;
    renderer::GrassPass m_pass;
    renderer::GeometryPass m_geometry;
};

inline double groundAt(Meadow& meadow, glm::dvec2 place)
{
    return *meadow.world().scene.heights()->height(place.x, place.y);
}

// From above, so that all around the place is in view.
inline io::Camera over(Meadow& meadow, glm::dvec2 place, double height = 14, float yaw = 0)
{
    return {.eye = {place.x, groundAt(meadow, place) + height, place.y}, .yaw = yaw, .pitch = -89, .fov = 60};
}

using Key = std::tuple<long, long, int, long>; // cell, kind, hundredths of a millimetre

// What stands in a square of 4 m.
inline std::set<Key> standingIn(const std::vector<Plant>& plants, glm::dvec2 corner)
{
    std::set<Key> found;
    for (const Plant& plant : plants)
        if (plant.root.x >= corner.x && plant.root.z >= corner.y && plant.root.x < corner.x + 4 && plant.root.z < corner.y + 4)
            found.insert({long(std::floor(plant.root.x / double(GRASS_CELL))), long(std::floor(plant.root.z / double(GRASS_CELL))), plant.kind, std::lround(plant.height * 1e5f)});
    return found;
}

} // namespace test
