#include "io/files/project.h"

#include "io/base/paths.h"
#include "io/files/documents.h"
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

void readTemplates(const Project& project, Scene& scene, Complaints& complaints)
{
    std::set<std::string> seen;
    for (const std::string& name : project.templates) {
        if (!seen.insert(name).second) {
            complaints.push_back({Severity::Warning, shown(project.folder, kProjectFile),
                                  "templates: \"" + name + "\" is listed twice"});
            continue;
        }
        const TemplateId id = scene.templateSlot(name);
        Result<std::string> text = readProjectFile(project.folder, templateFile(name));
        Result<Template> read =
            text ? readTemplateText(std::move(*text), shown(project.folder, templateFile(name)), complaints)
                 : Result<Template>{text.error()};
        if (read)
            scene.exchange(id, std::move(*read));
        else
            complaints.push_back(
                {Severity::Error, read.error().where, read.error().what + "; its objects stay empty places"});
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
        complaints.push_back(
            {Severity::Error, read.error().where, read.error().what + "; the usual light is shown instead"});
}

ProjectBody bodyOf(const World& world)
{
    const Scene& scene = world.scene;
    ProjectBody body{world.project.name,
                     world.project.start,
                     world.project.scenes,
                     world.project.templates,
                     {scene.cameras().begin(), scene.cameras().end()},
                     {scene.paths().begin(), scene.paths().end()},
                     world.project.extra};
    for (const Scene::TemplateSlot& slot : scene.templates())
        if (slot.value && std::find(body.templates.begin(), body.templates.end(), slot.name) == body.templates.end())
            body.templates.push_back(slot.name);
    return body;
}

// Adds a small file unless the one on disk says the same in other words: what a person laid out by hand, or cannot
// be read and was not changed since, stays as it is.
template <class T, class Read>
void addIfChanged(FileTransaction& transaction, const fs::path& folder, const std::string& file, const T& value,
                  std::string text, Read read)
{
    Complaints ignored;
    Result<std::string> old = readProjectFile(folder, file);
    if (old && *old != text) {
        const Result<T> parsed = read(std::move(*old), file, ignored);
        if ((parsed ? *parsed : T{}) == value) return;
    }
    transaction.add(file, std::move(text));
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
    world.project.extra = std::move(body->extra);
    world.scene.exchange(std::move(body->cameras));
    world.scene.exchange(std::move(body->paths));

    Result<SceneEntry> entry = chooseScene(world.project, scene, complaints);
    if (!entry) return entry.error();
    world.entry = *entry;
    readTemplates(world.project, world.scene, complaints);
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
    const ProjectBody body = bodyOf(world);
    addIfChanged(transaction, folder, kProjectFile, body, projectText(body), readProjectText);
    transaction.add(world.entry.file, sceneText(world.scene, environmentFile));
    addIfChanged(transaction, folder, environmentFile, world.scene.environment(),
                 environmentText(world.scene.environment()), readEnvironmentText);
    for (const Scene::TemplateSlot& slot : world.scene.templates()) {
        if (!slot.value) continue;
        const auto read = [&](std::string text, const std::string& file, Complaints& complaints) {
            Result<Template> result = readTemplateText(std::move(text), file, complaints);
            if (result) result->name = slot.name;
            return result;
        };
        addIfChanged(transaction, folder, templateFile(slot.name), *slot.value, templateText(*slot.value), read);
    }
    Result<FileTransaction::Report> report = transaction.commit();
    if (report)
        for (const Object& object : world.scene.objects())
            world.scene.lastSavedId = std::max(world.scene.lastSavedId, object.id);
    return report;
}

} // namespace io
