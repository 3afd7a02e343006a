// Reads what a scene names: models, height map, layer images; each file once, several at a time.
#include "io/base/paths.h"
#include "io/files/card_trimming.h"
#include "io/files/cover_map_file.h"
#include "io/files/grass_map_file.h"
#include "io/files/height_map_file.h"
#include "io/files/image_file.h"
#include "io/files/instances_file.h"
#include "io/files/levels.h"
#include "io/files/model_file.h"
#include "io/files/project.h"

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <map>
#include <mutex>
#include <thread>

namespace io {
namespace {

constexpr glm::vec4 kMarkerColour{0.25f, 0.45f, 0.8f, 1};
constexpr glm::vec4 kMissingColour{0.9f, 0.05f, 0.6f, 1};

struct Job {
    std::string name; // of the file, for progress
    std::function<void(Complaints&, const Progress&)> run; // may report its own progress, and ends early when that says so
    Complaints complaints;
    float done = 0; // 0..1
};

// Runs all jobs on other threads, while this one tells of the progress. False when it was cancelled.
bool runAll(std::vector<Job>& jobs, const Progress& progress)
{
    std::mutex mutex;
    std::condition_variable changed;
    std::atomic<bool> cancelled{false};
    std::atomic<std::size_t> next{0};
    std::size_t finished = 0; // these three are the mutex's, as what is done of each job
    bool news = false;
    std::string step;
    const auto tell = [&](Job& job, float done, bool last) {
        const std::lock_guard lock{mutex};
        job.done = done;
        step = job.name;
        finished += last ? 1 : 0;
        news = true;
        changed.notify_one();
    };
    const auto work = [&] {
        for (std::size_t i = next++; i < jobs.size(); i = next++) {
            Job& job = jobs[i];
            const Progress own = [&](float fraction, std::string_view) { return tell(job, std::min(fraction, 1.0f), false), !cancelled; };
            if (!cancelled) job.run(job.complaints, own);
            tell(job, 1, true);
        }
    };
    std::vector<std::jthread> threads;
    for (std::size_t i = 0; i < std::min<std::size_t>(jobs.size(), std::max(1u, std::thread::hardware_concurrency()));
         ++i)
        threads.emplace_back(work);

    for (bool all = jobs.empty(); !all;) {
        std::unique_lock lock{mutex};
        changed.wait(lock, [&] { return std::exchange(news, false); });
        all = finished == jobs.size();
        float done = 0;
        for (const Job& job : jobs)
            done += job.done;
        const std::string now = step;
        lock.unlock();
        if (!report(progress, all ? 1 : done / float(jobs.size()), now)) cancelled = true;
    }
    return !cancelled;
}

Complaint complaintOf(const std::string& where, const char* key, const Error& error)
{
    return {Severity::Error, where, std::string{key} + ": " + error.text()};
}

Result<Model> readModelOf(const World& world, const std::string& file, Complaints& complaints)
{
    const Result<std::filesystem::path> path = insideFolder(world.project.folder, file);
    if (!path) return path.error();
    return readModel(*path, world.project.folder, complaints);
}

std::shared_ptr<const Model> box(const glm::vec3& size, const glm::vec4& colour)
{
    return std::make_shared<const Model>(boxModel(size, colour));
}

std::string templatePath(const World& world, std::string_view name)
{
    return (world.project.folder / "templates" / (std::string{name} + ".json")).string();
}

// Templates that share a file share its model.
void addModelJobs(const World& world, Assets& assets, std::vector<Job>& jobs)
{
    const auto slots = world.scene.templates();
    assets.models.resize(slots.size());
    std::map<std::string, std::vector<std::size_t>> usersOf;
    for (std::size_t i = 0; i < slots.size(); ++i)
        usersOf[slots[i].value ? slots[i].value->model : std::string{}].push_back(i);
    for (auto& [file, users] : usersOf) {
        if (file.empty()) {
            for (const std::size_t i : users)
                assets.models[i] =
                    slots[i].value ? box(slots[i].value->markerSize, kMarkerColour) : box(glm::vec3{1}, kMissingColour);
            continue;
        }
        jobs.push_back({file, [&world, &assets, users](Complaints& complaints, const Progress&) {
                            const auto model = readTemplateModel(world, TemplateId(users.front() + 1), complaints);
                            for (const std::size_t i : users)
                                assets.models[i] = model;
                        }});
    }
}

void addImageJobs(const World& world, Assets& assets, std::vector<Job>& jobs)
{
    const std::vector<TerrainLayer>& layers = world.scene.terrain().layers;
    const std::string where = (world.project.folder / world.entry.file).string();
    assets.layers.resize(layers.size());
    std::map<std::string, std::vector<std::shared_ptr<const Image>*>> usersOf;
    for (std::size_t i = 0; i < layers.size(); ++i) {
        if (!layers[i].texture.empty()) usersOf[layers[i].texture].push_back(&assets.layers[i].colour);
        if (!layers[i].normalTexture.empty()) usersOf[layers[i].normalTexture].push_back(&assets.layers[i].normal);
        if (!layers[i].roughnessTexture.empty()) usersOf[layers[i].roughnessTexture].push_back(&assets.layers[i].roughness);
        if (!layers[i].heightTexture.empty()) usersOf[layers[i].heightTexture].push_back(&assets.layers[i].height);
    }
    for (const auto& [file, users] : usersOf) {
        jobs.push_back({file, [&world, where, file, users](Complaints& complaints, const Progress&) {
                            const Result<std::filesystem::path> path = insideFolder(world.project.folder, file);
                            Result<Image> image = path ? readImage(*path) : Result<Image>{path.error()};
                            if (!image)
                                return complaints.push_back(complaintOf(where, "terrain.layers", image.error()));
                            const auto shared = std::make_shared<const Image>(std::move(*image));
                            for (auto* user : users)
                                *user = shared;
                        }});
    }
}

struct Ground {
    std::shared_ptr<const HeightMap> heights;
    std::shared_ptr<const CoverMap> cover;
};

void addGroundJob(const World& world, Ground& ground, std::vector<Job>& jobs)
{
    const Terrain& terrain = world.scene.terrain();
    if (terrain.heightMap.empty()) return;
    jobs.push_back({terrain.heightMap, [&](Complaints& complaints, const Progress& progress) {
                        ground.heights = readHeights(world, terrain, complaints, progress);
                        if (ground.heights) ground.cover = readCover(world, terrain, ground.heights->size, complaints);
                    }});
}

void addGrassJob(const World& world, std::shared_ptr<const GrassMap>& map, std::vector<Job>& jobs)
{
    const Grass& grass = world.scene.grass();
    if (grass.map.empty()) return;
    jobs.push_back({grass.map, [&](Complaints& complaints, const Progress&) { map = readGrassMap(world, grass, complaints); }});
}

void addInstanceJobs(const World& world, std::map<ScatterId, World::InstancesFile>& read, std::vector<Job>& jobs)
{
    for (const ScatterLayer& layer : world.scene.scatterLayers())
        jobs.push_back({instancesFile(world.entry.file, layer.id),
                        [&world, &layer, &into = read[layer.id]](Complaints& complaints, const Progress&) { into = readInstances(world, layer, complaints); }});
}

} // namespace

World::InstancesFile readInstances(const World& world, const ScatterLayer& layer, Complaints& complaints)
{
    const std::string where = (world.project.folder / world.entry.file).string(), key = "scatter." + layer.name;
    for (const Species& species : layer.species)
        if (world.scene.findTemplate(species.templateName) == TemplateId::None)
            complaints.push_back({Severity::Error, where, key + ": \"" + species.templateName + "\" is no template of this project; add it, or its instances stay empty places"});

    World::InstancesFile none{.whole = false};
    const Result<std::filesystem::path> path = insideFolder(world.project.folder, instancesFile(world.entry.file, layer.id));
    const Result<std::string> bytes = path ? readFile(*path) : Result<std::string>{path.error()};
    if (!bytes) {
        complaints.push_back(complaintOf(where, key.c_str(), {bytes.error().where, bytes.error().what + "; the layer is shown without instances"}));
        return none;
    }
    Result<ReadInstances> read = decodeInstances(*bytes, layer.species.size());
    none.bytes = fingerprint(*bytes);
    if (!read) {
        complaints.push_back({Severity::Error, path->string(), read.error().what + "; the layer \"" + layer.name + "\" is shown without instances"});
        return none;
    }
    if (read->strangers > 0)
        complaints.push_back({Severity::Error, path->string(), std::to_string(read->strangers) + " instances are of species that the layer \"" + layer.name + "\" does not list; left out"});
    return {std::move(read->tiles), none.bytes, read->strangers == 0};
}

std::shared_ptr<const Model> readTemplateModel(const World& world, TemplateId id, Complaints& complaints)
{
    const Template* value = world.scene.find(id);
    if (!value) return box(glm::vec3{1}, kMissingColour);
    if (value->model.empty()) return box(value->markerSize, kMarkerColour);
    Result<Model> model = readModelOf(world, value->model, complaints);
    if (model) {
        addLevels(*model);
        trimCards(*model);
        return std::make_shared<const Model>(std::move(*model));
    }
    complaints.push_back(complaintOf(templatePath(world, value->name), "model", model.error()));
    return box(value->markerSize, kMissingColour);
}

std::shared_ptr<const HeightMap> readHeights(const World& world, const Terrain& terrain, Complaints& complaints, const Progress& progress)
{
    const Result<std::filesystem::path> path = insideFolder(world.project.folder, terrain.heightMap);
    Result<HeightMap> heights = path ? readHeightMap(*path, terrain, complaints, progress) : Result<HeightMap>{path.error()};
    if (heights) return std::make_shared<const HeightMap>(std::move(*heights));
    const std::string where = (world.project.folder / world.entry.file).string();
    complaints.push_back(complaintOf(where, "terrain.height_map", heights.error()));
    return nullptr;
}

std::shared_ptr<const CoverMap> readCover(const World& world, const Terrain& terrain, glm::ivec2 size, Complaints& complaints)
{
    if (terrain.coverMap.empty()) return nullptr;
    const Result<std::filesystem::path> path = insideFolder(world.project.folder, terrain.coverMap);
    Result<CoverMap> cover = path ? readCoverMap(*path, size) : Result<CoverMap>{path.error()};
    if (cover) return std::make_shared<const CoverMap>(std::move(*cover));
    complaints.push_back(complaintOf((world.project.folder / world.entry.file).string(), "terrain.cover_map", cover.error()));
    return nullptr;
}

std::shared_ptr<const GrassMap> readGrassMap(const World& world, const Grass& grass, Complaints& complaints)
{
    if (grass.map.empty()) return nullptr;
    const Result<std::filesystem::path> path = insideFolder(world.project.folder, grass.map);
    auto texels = path ? readGrassTexels(*path) : Result<TexelTiles<std::uint32_t>>{path.error()};
    if (texels) return std::make_shared<const GrassMap>(std::move(*texels), grass.metresPerTexel, grass.origin);
    complaints.push_back(complaintOf((world.project.folder / world.entry.file).string(), "grass.map", texels.error()));
    return nullptr;
}

Result<Assets> readAssets(World& world, Complaints& complaints, const Progress& progress)
{
    Assets assets;
    std::vector<Job> jobs;
    Ground ground;
    addGroundJob(world, ground, jobs); // the largest first
    std::shared_ptr<const GrassMap> grassMap;
    addGrassJob(world, grassMap, jobs);
    addImageJobs(world, assets, jobs);
    addModelJobs(world, assets, jobs);
    std::map<ScatterId, World::InstancesFile> instances;
    addInstanceJobs(world, instances, jobs);
    const bool complete = runAll(jobs, progress);
    if (!complete) return Error{world.project.folder.string(), "reading was cancelled"};
    for (const Job& job : jobs)
        complaints.insert(complaints.end(), job.complaints.begin(), job.complaints.end());
    if (ground.heights) {
        const Terrain& terrain = world.scene.terrain();
        world.heightFiles[terrain.heightMap] = {ground.heights, terrain.minHeight, terrain.maxHeight};
        if (ground.cover) world.coverFiles[terrain.coverMap] = ground.cover;
        world.scene.exchange(std::move(ground.heights));
        world.scene.exchange(std::move(ground.cover));
    }
    if (grassMap) {
        world.grassFiles[world.scene.grass().map] = grassMap;
        world.scene.exchange(std::move(grassMap));
    }
    for (auto& [layer, file] : instances) {
        world.scene.exchange(layer, file.tiles);
        world.instanceFiles[instancesFile(world.entry.file, layer)] = std::move(file);
    }
    return assets;
}

Complaints checkProject(const std::filesystem::path& project)
{
    Complaints complaints;
    const auto keep = [&](const Complaints& found) { // scenes share templates: each fault is named once
        for (const Complaint& complaint : found) {
            const auto same = [&](const Complaint& known) {
                return known.where == complaint.where && known.what == complaint.what;
            };
            if (std::none_of(complaints.begin(), complaints.end(), same)) complaints.push_back(complaint);
        }
    };
    std::vector<SceneEntry> scenes{{}}; // the start scene; the others once they are known
    for (std::size_t i = 0; i < scenes.size(); ++i) {
        Complaints found;
        Result<World> world = openWorld(project, scenes[i].name, found);
        if (world) {
            if (const Result<Assets> assets = readAssets(*world, found); !assets)
                found.push_back({Severity::Error, assets.error().where, assets.error().what});
            if (i == 0)
                for (const SceneEntry& entry : world->project.scenes)
                    if (entry != world->entry) scenes.push_back(entry);
        } else {
            found.push_back({Severity::Error, world.error().where, world.error().what});
        }
        keep(found);
    }
    return complaints;
}

} // namespace io
