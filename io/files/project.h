// A project: a folder with project.json, its scenes, environments, templates and the files they name.
#pragma once

#include "io/base/complaint.h"
#include "io/base/progress.h"
#include "io/base/result.h"
#include "io/files/atomic_file.h"
#include "io/scene/assets.h"
#include "io/scene/scene.h"

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace io {

struct SceneEntry {
    std::string name;
    std::string file; // scenes/NAME.scene.json
    bool operator==(const SceneEntry&) const = default;
};

// What makes the player of a project do something: "jump" by the key "Space", "mouse 1", "pad A" or "pad left +x".
struct Control {
    std::string action;
    std::string by;
    bool operator==(const Control&) const = default;
};

struct Project {
    std::filesystem::path folder;
    std::string name;
    std::vector<SceneEntry> scenes;
    std::string start;                  // name of a scene
    std::vector<std::string> templates; // templates/NAME.json
    std::vector<Control> controls;      // of the player; an action without any has its own (app/play)
    Extra extra;
};

// One scene of a project, without its heavy files.
struct World {
    Project project;
    SceneEntry entry;            // the scene that is open
    std::string environmentFile; // environments/NAME.json, named by the scene
    Scene scene;                 // objects, templates, environment, terrain; cameras and paths from project.json
    // What files of the ground that were read or written hold, by their names: those are not written again.
    struct HeightFile {
        std::shared_ptr<const HeightMap> heights;
        double minHeight = 0, maxHeight = 0; // that they were read or written with
    };
    std::map<std::string, HeightFile, std::less<>> heightFiles;
    std::map<std::string, std::shared_ptr<const CoverMap>, std::less<>> coverFiles;
    std::map<std::string, std::shared_ptr<const GrassMap>, std::less<>> grassFiles;
    // What files of instances hold, by their names, and whether all that lies in them was read.
    struct InstancesFile {
        InstanceTiles tiles;
        std::uint64_t bytes = 0; // fingerprint()
        bool whole = true;
    };
    std::map<std::string, InstancesFile, std::less<>> instanceFiles;
    // Templates that were read from a file or saved to it, and what it held (fingerprint()): only that file is
    // removed when its template is deleted.
    std::map<std::string, std::uint64_t, std::less<>> templateFiles;
};

// `project` is the folder or its project.json; an empty scene name is the start scene. Finishes or drops a save that
// was cut off. An error is a world that cannot be opened; complaints are what was mended or left out.
Result<World> openWorld(const std::filesystem::path& project, std::string_view scene, Complaints& complaints);

// The whole world as one transaction; what did not change is not written. The world remembers what its files hold.
Result<FileTransaction::Report> saveWorld(World& world);

// The other scenes of the project that hold objects of this template, by name.
std::vector<std::string> otherScenesWith(const World& world, std::string_view templateName);

// Models and layer images that the scene names, and its heights and instances, which become the scene's. What cannot be read is complained
// about and replaced by a stand-in, so that the rest can be worked on. An error only when cancelled.
Result<Assets> readAssets(World& world, Complaints& complaints, const Progress& progress = {});
// The heights that a terrain of this project names; null, with a complaint, where they cannot be read. The caller tells the
// world's heightFiles, and coverFiles, of what it keeps.
std::shared_ptr<const HeightMap> readHeights(const World& world, const Terrain& terrain, Complaints& complaints, const Progress& progress = {});
// The cover of that name over heights of that size; likewise.
std::shared_ptr<const CoverMap> readCover(const World& world, const Terrain& terrain, glm::ivec2 size, Complaints& complaints);
std::shared_ptr<const GrassMap> readGrassMap(const World& world, const Grass& grass, Complaints& complaints); // likewise
// The instances of a layer of the scene; none, with a complaint, where they cannot be read.
World::InstancesFile readInstances(const World& world, const ScatterLayer& layer, Complaints& complaints);
std::shared_ptr<const Model> readTemplateModel(const World& world, TemplateId id, Complaints& complaints);

// `wold new`: from a starter that ships ("empty", "valley"). The folder must be missing or empty.
Status newProject(const std::filesystem::path& folder, std::string_view starter);

// `wold check`: reads all that the project names.
Complaints checkProject(const std::filesystem::path& project);

} // namespace io
