// A world being furnished: templates with their models, and objects that stand on its ground.
#pragma once

#include "io/files/project.h"
#include "projects/make/models.h"
#include "projects/make/random.h"

#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>

namespace make {

struct Put {
    std::string_view what;      // a template
    glm::vec2 at{0};            // world x and z
    std::optional<float> yaw;   // degrees; drawn from the template's range when not given
    std::optional<float> scale; // likewise
    std::string name;
    float lift = 0; // m above where it would stand
    io::ObjectId parent = io::ObjectId::None;
};

class Stage {
public:
    Stage(std::filesystem::path folder, std::string name, io::HeightGrid heights, Textures& textures);

    void addModels(std::span<const Entry> entries);
    void addMarker(const std::string& name, glm::vec3 size, bool casts = false);
    void addParticles(const std::string& name, const std::string& category, const io::ParticleSource& particles); // a small marker that gives them off
    void addSound(const std::string& name, const io::SoundSource& sound); // a small marker that lets it be heard
    void edit(std::string_view name, const std::function<void(io::Template&)>& change);
    io::ObjectId addGroup(const std::string& name, glm::vec2 at);
    io::ObjectId put(const Put& put, Random& random);
    void addLayer(io::ScatterLayer layer); // whose instances follow
    void plant(const Put& put, Random& random); // an instance of that layer, as painted by hand

    // Ground that something of `radius` metres may take: no one else's is within it.
    bool isFree(glm::vec2 at, float radius) const;
    void take(glm::vec2 at, float radius);

    const std::filesystem::path& folder() const { return m_world.project.folder; }
    const io::HeightGrid& heights() const { return m_heights; }
    std::size_t objects() const { return m_world.scene.objects().size(); }
    std::size_t count(std::string_view what) const;

    void setEnvironment(io::Environment environment) { m_world.scene.exchange(std::move(environment)); }
    void setViews(std::vector<io::Camera> cameras, std::vector<io::CameraPath> paths);

    // The ground's file, its layers and their textures (`side` texels), and how high the file reaches.
    io::Status addGround(std::vector<io::TerrainLayer> layers, int side, double minHeight, double maxHeight);
    void setGrass(io::Grass grass, io::TexelTiles<std::uint32_t> texels);
    io::Status save(); // models and all text

private:
    io::Transform placed(const Put& put, const io::Template& what, Random& random) const;

    io::World m_world;
    io::HeightGrid m_heights;
    Textures& m_textures;
    io::ScatterLayer m_layer;
    std::map<glm::ivec2, io::InstanceTile, io::TileOrder> m_planted; // of it
    std::map<std::string, std::string> m_models;        // file inside the project, its bytes
    std::map<std::string, float, std::less<>> m_depths; // how far a template's model reaches below its origin, m
    std::map<std::pair<int, int>, std::vector<glm::vec3>> m_taken; // x, z, radius by square of 8 m
};

// A camera at `eye` that looks at `target`; heights are above the ground there.
io::Camera cameraAt(const Stage& stage, const std::string& name, glm::vec3 eye, glm::vec3 target, float fov);
io::PathKey keyAt(const Stage& stage, double time, glm::vec3 eye, glm::vec3 target, float fov = 60);

} // namespace make
