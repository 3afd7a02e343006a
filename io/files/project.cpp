#include "io/files/project.h"

#include "io/base/log.h"
#include "io/base/paths.h"
#include "io/files/cover_map_file.h"
#include "io/files/grass_map_file.h"
#include "io/files/documents.h"
#include "io/files/file_names.h"
#include "io/files/height_map_file.h"
#include "io/files/instances_file.h"
#include "io/files/scene_file.h"

#include <algorithm>
#include <set>

namespace io {
namespace fs = std::filesystem;
namespace {

constexpr const char* kProjectFile = "project.json";
constexpr std::uint64_t kLargestText = std::uint64_t(2) << 30; // a million objects take 0.1 to 0.2 GiB

Result<std::string> readProjectFile(const fs::path& folder, const std::string& file)
{
    const Result<fs::path> path = insideFolder(folder, file);
    if (!path) return path.error();
    return readFile(*path, kLargestText);
}

std::string shown(const fs::path& folder, const std::string& file)
{
    return (folder / file).string();
}

std::string templateFile(std::string_view name)
{
    return "templates/" + std::string{name} + ".json";
}

// Where a file that cannot be read goes before another is written in its place.
std::string setAside(const std::string& file)
{
    return file + ".bad";
}

Result<fs::path> projectFolder(const fs::path& project)
{
    std::error_code error;
    const fs::path folder = project.filename() == kProjectFile && !fs::is_directory(project, error)
                                ? (project.has_parent_path() ? project.parent_path() : fs::path{"."})
                                : project;
    if (!fs::exists(folder, error))
        return Error{folder.string(), "there is no such project; name a folder that holds project.json"};
    if (!fs::exists(folder / kProjectFile, error))
        return Error{folder.string(), "is no project; name a folder that holds project.json"};
    return folder;
}

Result<SceneEntry> chooseScene(const Project& project, std::string_view asked, Complaints& complaints)
{
    const std::string where = shown(project.folder, kProjectFile);
    if (project.scenes.empty()) return Error{where, "scenes: the project has none; add one"};
    const std::string_view name = asked.empty() ? std::string_view{project.start} : asked;
    std::string names;
    for (const SceneEntry& entry : project.scenes) {
        if (entry.name == name) return entry;
        names += (names.empty() ? "" : ", ") + entry.name;
    }
    if (!asked.empty()) return Error{where, "there is no scene \"" + std::string{asked} + "\"; there is " + names};
    if (!name.empty())
        complaints.push_back(
            {Severity::Error, where, "start: there is no scene \"" + project.start + "\"; there is " + names});
    return project.scenes.front();
}

void readTemplates(World& world, Complaints& complaints)
{
    const Project& project = world.project;
    Scene& scene = world.scene;
    std::set<std::string> seen;
    for (const std::string& name : project.templates) {
        if (!seen.insert(name).second) {
            complaints.push_back({Severity::Warning, shown(project.folder, kProjectFile),
                                  "templates: \"" + name + "\" is listed twice"});
            continue;
        }
        const TemplateId id = scene.templateSlot(name);
        Result<std::string> text = readProjectFile(project.folder, templateFile(name));
        const std::uint64_t bytes = text ? fingerprint(*text) : 0;
        Result<Template> read =
            text ? readTemplateText(std::move(*text), shown(project.folder, templateFile(name)), complaints)
                 : Result<Template>{text.error()};
        if (read) {
            scene.exchange(id, std::move(*read));
            world.templateFiles[name] = bytes;
        } else
            complaints.push_back({Severity::Error, read.error().where, read.error().what + "; its objects stay empty places until it is mended"});
    }
}

void readEnvironment(World& world, Complaints& complaints)
{
    const fs::path& folder = world.project.folder;
    if (world.environmentFile.empty()) {
        world.environmentFile = "environments/" + world.entry.name + ".json";
        complaints.push_back({Severity::Warning, shown(folder, world.entry.file),
                              "environment: missing; " + world.environmentFile + " is taken"});
    }
    Result<std::string> text = readProjectFile(folder, world.environmentFile);
    Result<Environment> read =
        text ? readEnvironmentText(std::move(*text), shown(folder, world.environmentFile), complaints)
             : Result<Environment>{text.error()};
    if (read)
        world.scene.exchange(std::move(*read));
    else
        complaints.push_back({Severity::Error, read.error().where,
                              read.error().what + "; the usual light is shown instead: mend the file and open the project again" +
                                  (text ? ", or change the light, and Save keeps the file as " + setAside(world.environmentFile) : "")});
}

// A template without a value was deleted if its file was read, else the file is missing or damaged.
bool deleted(const World& world, const Scene::TemplateSlot& slot)
{
    return !slot.value && world.templateFiles.contains(slot.name);
}

// Without those that were deleted and with those that are new, which keep a sorted list sorted.
std::vector<std::string> templateNames(const World& world)
{
    std::vector<std::string> names = world.project.templates;
    for (const Scene::TemplateSlot& slot : world.scene.templates()) {
        if (deleted(world, slot)) std::erase(names, slot.name);
        if (!slot.value || std::ranges::find(names, slot.name) != names.end()) continue;
        const bool sorted = std::ranges::is_sorted(names);
        names.insert(sorted ? std::ranges::upper_bound(names, slot.name) : names.end(), slot.name);
    }
    return names;
}

ProjectBody bodyOf(const World& world)
{
    const Scene& scene = world.scene;
    return {world.project.name,
            world.project.start,
            world.project.scenes,
            templateNames(world),
            {scene.cameras().begin(), scene.cameras().end()},
            {scene.paths().begin(), scene.paths().end()},
            world.project.controls,
            world.project.extra};
}

// Adds a small file unless the one on disk says the same in other words: what a person laid out by hand, or cannot
// be read and was not changed since, stays as it is. What cannot be read is set aside before it is written over.
// Answers the fingerprint of what then is on the disk.
template <class T, class Read>
std::uint64_t addIfChanged(FileTransaction& transaction, const fs::path& folder, const std::string& file, const T& value,
                  std::string text, Read read)
{
    Complaints ignored;
    Result<std::string> old = readProjectFile(folder, file);
    if (old && *old != text) {
        const Result<T> parsed = read(*old, file, ignored);
        if ((parsed ? *parsed : T{}) == value) return fingerprint(*old);
        if (!parsed) {
            log::warning("{}; the file is kept as {}", parsed.error().text(), shown(folder, setAside(file)));
            transaction.add(setAside(file), *std::move(old));
        }
    }
    const std::uint64_t bytes = fingerprint(text);
    transaction.add(file, std::move(text));
    return bytes;
}

bool named(const World& world, const SceneEntry& other, const std::string& heightMap)
{
    if (other.file == world.entry.file) return false;
    Result<std::string> text = readProjectFile(world.project.folder, other.file);
    Scene scene;
    Complaints ignored;
    return text && readSceneText(std::move(*text), other.file, scene, ignored) && scene.terrain().heightMap == heightMap;
}

// Adds the heights unless their file holds them, and answers what the scene's file is to say of them.
Result<Terrain> addHeights(FileTransaction& transaction, const World& world)
{
    Terrain terrain = world.scene.terrain();
    const auto& heights = world.scene.heights();
    if (!heights || terrain.heightMap.empty()) return terrain;
    const auto known = world.heightFiles.find(terrain.heightMap);
    if (known != world.heightFiles.end() && known->second.minHeight == terrain.minHeight && known->second.maxHeight == terrain.maxHeight &&
        (known->second.heights == heights || known->second.heights->sameHeights(*heights)))
        return terrain;
    if (const Result<fs::path> path = insideFolder(world.project.folder, terrain.heightMap); !path) return path.error();
    if (!holdsHeights(terrain.heightMap)) terrain.heightMap = freshFile(world.project.folder, terrain.heightMap, ".png");
    Result<std::string> bytes = encodeHeightMap(*heights, terrain);
    if (!bytes) return Error{shown(world.project.folder, terrain.heightMap), bytes.error().what};
    // Between other heights the same file would mean another ground in the scenes that share it.
    const bool moved = terrain.minHeight != world.scene.terrain().minHeight || terrain.maxHeight != world.scene.terrain().maxHeight;
    if (moved && std::ranges::any_of(world.project.scenes, [&](const SceneEntry& other) { return named(world, other, terrain.heightMap); }))
        terrain.heightMap = freshFile(world.project.folder, terrain.heightMap, fs::path{terrain.heightMap}.extension().string());
    transaction.add(terrain.heightMap, *std::move(bytes));
    return terrain;
}

// What was painted, unless its file holds it.
template <class Map>
Status addPainted(FileTransaction& transaction, const World& world, const std::string& file, const std::shared_ptr<const Map>& map,
                  const std::map<std::string, std::shared_ptr<const Map>, std::less<>>& files, Result<std::string> (*encode)(const Map&))
{
    if (!map || file.empty()) return {};
    const auto known = files.find(file);
    if (known != files.end() && (known->second == map || *known->second == *map)) return {};
    if (const Result<fs::path> path = insideFolder(world.project.folder, file); !path) return path.error();
    Result<std::string> bytes = encode(*map);
    if (!bytes) return Error{shown(world.project.folder, file), bytes.error().what};
    transaction.add(file, *std::move(bytes));
    return {};
}

// Adds the instances of layers unless their files hold them, and removes the files of layers that are gone. Answers what then
// is on the disk.
Result<decltype(World::instanceFiles)> addInstances(FileTransaction& transaction, const World& world)
{
    const fs::path& folder = world.project.folder;
    decltype(World::instanceFiles) files;
    for (const ScatterLayer& layer : world.scene.scatterLayers()) {
        const std::string file = instancesFile(world.entry.file, layer.id);
        const InstanceTiles& tiles = world.scene.instances(layer.id);
        const auto known = world.instanceFiles.find(file);
        if (known != world.instanceFiles.end() && sameInstances(known->second.tiles, tiles)) {
            files.insert(*known);
            continue;
        }
        if (const Result<fs::path> path = insideFolder(folder, file); !path) return path.error();
        std::error_code fault;
        if (known == world.instanceFiles.end() && tiles.empty() && fs::exists(folder / file, fault)) continue; // never read
        std::string bytes = encodeInstances(tiles);
        if (known == world.instanceFiles.end() || !known->second.whole)
            if (Result<std::string> old = readProjectFile(folder, file); old && *old != bytes) {
                log::warning("{}: what cannot be read of it is kept as {}", shown(folder, file), shown(folder, setAside(file)));
                transaction.add(setAside(file), *std::move(old));
            }
        files[file] = {tiles, fingerprint(bytes), true};
        transaction.add(file, std::move(bytes));
    }
    for (const auto& [file, held] : world.instanceFiles)
        if (!files.contains(file) && held.whole) transaction.remove(file, held.bytes);
    return files;
}

// What the files hold is what the world now remembers of them.
void remember(World& world, std::vector<std::string> templates, decltype(World::templateFiles) templateFiles,
              decltype(World::instanceFiles) instanceFiles)
{
    world.instanceFiles = std::move(instanceFiles);
    world.project.templates = std::move(templates);
    world.templateFiles = std::move(templateFiles);
    for (const Object& object : world.scene.objects())
        world.scene.lastSavedId = std::max(world.scene.lastSavedId, object.id);
}

} // namespace

Result<World> openWorld(const fs::path& project, std::string_view scene, Complaints& complaints)
{
    const Result<fs::path> folder = projectFolder(project);
    if (!folder) return folder.error();
    if (const Status recovered = recoverTransactions(*folder); !recovered)
        complaints.push_back({Severity::Error, recovered.error().where, recovered.error().what});

    World world;
    world.project.folder = *folder;
    Result<std::string> text = readProjectFile(*folder, kProjectFile);
    if (!text) return text.error();
    Result<ProjectBody> body = readProjectText(std::move(*text), shown(*folder, kProjectFile), complaints);
    if (!body) return body.error();
    world.project.name = std::move(body->name);
    world.project.start = std::move(body->start);
    world.project.scenes = std::move(body->scenes);
    world.project.templates = std::move(body->templates);
    world.project.controls = std::move(body->controls);
    world.project.extra = std::move(body->extra);
    world.scene.exchange(std::move(body->cameras));
    world.scene.exchange(std::move(body->paths));

    Result<SceneEntry> entry = chooseScene(world.project, scene, complaints);
    if (!entry) return entry.error();
    world.entry = *entry;
    readTemplates(world, complaints);
    Result<std::string> sceneFile = readProjectFile(*folder, world.entry.file);
    if (!sceneFile) return sceneFile.error();
    Result<std::string> environment =
        readSceneText(std::move(*sceneFile), shown(*folder, world.entry.file), world.scene, complaints);
    if (!environment) return environment.error();
    world.environmentFile = std::move(*environment);
    readEnvironment(world, complaints);
    return world;
}

Result<FileTransaction::Report> saveWorld(World& world)
{
    const fs::path& folder = world.project.folder;
    const std::string environmentFile =
        world.environmentFile.empty() ? "environments/" + world.entry.name + ".json" : world.environmentFile;
    FileTransaction transaction{folder};
    ProjectBody body = bodyOf(world);
    addIfChanged(transaction, folder, kProjectFile, body, projectText(body), readProjectText);
    Result<Terrain> terrain = addHeights(transaction, world);
    if (!terrain) return terrain.error();
    const Scene& scene = world.scene;
    Status painted = addPainted(transaction, world, scene.terrain().coverMap, scene.cover(), world.coverFiles, encodeCoverMap);
    if (painted) painted = addPainted(transaction, world, scene.grass().map, scene.grassMap(), world.grassFiles, encodeGrassMap);
    if (!painted) return painted.error();
    Result<decltype(World::instanceFiles)> instanceFiles = addInstances(transaction, world);
    if (!instanceFiles) return instanceFiles.error();
    transaction.add(world.entry.file, sceneText(world.scene, environmentFile, *terrain));
    addIfChanged(transaction, folder, environmentFile, world.scene.environment(),
                 environmentText(world.scene.environment()), readEnvironmentText);
    decltype(World::templateFiles) templateFiles;
    for (const Scene::TemplateSlot& slot : world.scene.templates()) {
        if (deleted(world, slot)) transaction.remove(templateFile(slot.name), world.templateFiles[slot.name]);
        if (!slot.value) continue;
        const auto read = [&](std::string text, const std::string& file, Complaints& complaints) {
            Result<Template> result = readTemplateText(std::move(text), file, complaints);
            if (result) result->name = slot.name;
            return result;
        };
        templateFiles[slot.name] =
            addIfChanged(transaction, folder, templateFile(slot.name), *slot.value, templateText(*slot.value), read);
    }
    Result<FileTransaction::Report> report = transaction.commit();
    if (!report) return report;
    for (const fs::path& kept : report->kept)
        log::warning("{}: another program changed it; what it held is deleted here, but the file stays",
                     (folder / kept).string());
    if (world.scene.heights()) world.heightFiles[terrain->heightMap] = {world.scene.heights(), terrain->minHeight, terrain->maxHeight};
    if (scene.cover()) world.coverFiles[terrain->coverMap] = scene.cover();
    if (scene.grassMap()) world.grassFiles[scene.grass().map] = scene.grassMap();
    world.scene.exchange(*std::move(terrain)); // whose two heights may lie farther apart now, or in another file
    remember(world, std::move(body.templates), std::move(templateFiles), *std::move(instanceFiles));
    return report;
}

std::vector<std::string> otherScenesWith(const World& world, std::string_view templateName)
{
    std::vector<std::string> names;
    for (const SceneEntry& entry : world.project.scenes) {
        if (entry.file == world.entry.file) continue;
        Result<std::string> text = readProjectFile(world.project.folder, entry.file);
        Scene scene;
        Complaints ignored;
        if (!text || !readSceneText(std::move(*text), entry.file, scene, ignored)) continue;
        const TemplateId id = scene.findTemplate(templateName);
        const auto grows = [&](const Species& species) { return species.templateName == templateName; };
        if (std::ranges::any_of(scene.scatterLayers(), [&](const ScatterLayer& layer) { return std::ranges::any_of(layer.species, grows); }) ||
            (id != TemplateId::None && std::ranges::any_of(scene.objects(), [&](const Object& object) { return object.templateId == id; })))
            names.push_back(entry.name);
    }
    return names;
}

} // namespace io
