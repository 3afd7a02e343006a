#include "support.h"

#include "io/base/paths.h"
#include "io/files/height_map_file.h"
#include "io/files/image_file.h"
#include "io/files/model_file.h"
#include "io/files/project.h"

#include <csignal>
#include <sys/stat.h>
#include <sys/wait.h>

#include <atomic>
#include <cmath>
#include <map>

namespace io {
namespace {

// A project with two templates, three objects, a terrain with one textured layer, a camera and two scenes.
World sampleWorld(const fs::path& folder)
{
    World world;
    world.project = {.folder = folder,
                     .name = "sample",
                     .scenes = {{"main", "scenes/main.scene.json"}, {"night", "scenes/night.scene.json"}},
                     .start = "main"};
    world.entry = world.project.scenes[0];
    world.environmentFile = "environments/day.json";
    Scene& scene = world.scene;
    const TemplateId box = scene.templateSlot("box"), marker = scene.templateSlot("marker");
    scene.exchange(box, Template{.category = "Things", .model = "models/box.glb"});
    scene.exchange(marker, Template{.markerSize = {1, 3, 1}});
    for (std::uint32_t id = 1; id <= 3; ++id) {
        Object object;
        object.templateId = id == 3 ? marker : box;
        object.transform.position = {id * 1.1, 0, -2.0 * id};
        scene.exchange(ObjectId{id}, object);
    }
    Terrain terrain{.heightMap = "terrain/h.png", .minHeight = -10, .maxHeight = 10};
    terrain.layers.push_back({.name = "grass", .texture = "textures/grass.png"});
    scene.exchange(terrain);
    scene.exchange(std::vector<Camera>{{.name = "hill", .eye = {1, 2, 3}}});
    return world;
}

void writeHeavyFiles(const fs::path& folder)
{
    put(folder / "models/box.glb", *encodeGlb(boxModel(glm::vec3{1}, glm::vec4{1})));
    HeightGrid map{.size = {4, 4}, .metres = std::vector<float>(16, 5)};
    ASSERT_TRUE(writeHeightMap16(folder / "terrain/h.png", map, -10, 10));
    Image grass{.size = {2, 2}, .channels = 3, .bytes = std::vector<std::byte>(12)};
    fs::create_directories(folder / "textures");
    ASSERT_TRUE(writeImage(folder / "textures/grass.png", grass));
}

void writeSample(const fs::path& folder)
{
    World world = sampleWorld(folder);
    ASSERT_TRUE(saveWorld(world));
    world.entry = world.project.scenes[1];
    ASSERT_TRUE(saveWorld(world));
    writeHeavyFiles(folder);
}

struct Opened {
    Complaints complaints;
    Result<World> world;
    explicit Opened(const fs::path& project, std::string_view scene = {}) : world{openWorld(project, scene, complaints)}
    {
    }
};

std::map<std::string, std::string> filesIn(const fs::path& folder)
{
    std::map<std::string, std::string> files;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator{folder})
        if (entry.is_regular_file()) files[entry.path().lexically_relative(folder).string()] = get(entry.path());
    return files;
}

void replace(const fs::path& file, const std::string& from, const std::string& to)
{
    std::string text = get(file);
    const std::size_t at = text.find(from);
    ASSERT_NE(at, std::string::npos) << from << " in " << text;
    put(file, text.replace(at, from.size(), to));
}

TEST(Project, ComesBackAsItWas)
{
    const TemporaryFolder folder;
    writeSample(folder.path());
    const World was = sampleWorld(folder.path());
    for (const fs::path& name : {folder.path(), folder / "project.json"}) {
        const Opened opened{name};
        ASSERT_TRUE(opened.world) << opened.world.error().text();
        EXPECT_EQ(listed(opened.complaints), "");
        EXPECT_TRUE(sameContent(opened.world->scene, was.scene));
        EXPECT_EQ(opened.world->entry, was.entry);
        EXPECT_EQ(opened.world->environmentFile, was.environmentFile);
        EXPECT_EQ(opened.world->project.templates, (std::vector<std::string>{"box", "marker"}));
    }
    EXPECT_EQ(Opened(folder.path(), "night").world->entry.name, "night");
}

TEST(Project, SavingWithoutAChangeWritesNothing)
{
    const TemporaryFolder folder;
    writeSample(folder.path());
    const auto before = filesIn(folder.path());
    Opened opened{folder.path()};
    const Result<FileTransaction::Report> report = saveWorld(*opened.world);
    ASSERT_TRUE(report);
    EXPECT_TRUE(report->written.empty());
    EXPECT_EQ(filesIn(folder.path()), before);
}

TEST(Project, SavingWritesOnlyTheFilesThatChanged)
{
    const TemporaryFolder folder;
    writeSample(folder.path());
    Opened opened{folder.path()};
    Environment environment = opened.world->scene.environment();
    environment.time = 20;
    opened.world->scene.exchange(environment);
    EXPECT_EQ(saveWorld(*opened.world)->written, (std::vector<fs::path>{"environments/day.json"}));
    opened.world->scene.exchange(ObjectId{2}, std::nullopt);
    EXPECT_EQ(saveWorld(*opened.world)->written, (std::vector<fs::path>{"scenes/main.scene.json"}));
    opened.world->scene.exchange(opened.world->scene.templateSlot("new"), Template{});
    EXPECT_EQ(saveWorld(*opened.world)->written.size(), 2u); // the template, and its name in project.json
    EXPECT_TRUE(sameContent(Opened(folder.path()).world->scene, opened.world->scene));
}

TEST(Project, TheHighestIdDoesNotReturnAfterItsObjectWasDeletedAndSaved)
{
    const TemporaryFolder folder;
    writeSample(folder.path());
    const auto before = filesIn(folder.path());
    Opened opened{folder.path()};
    EXPECT_EQ(number(opened.world->scene.freshId()), 4u); // tried and undone: no file held it
    ASSERT_TRUE(saveWorld(*opened.world));
    EXPECT_EQ(filesIn(folder.path()), before);

    const auto last = opened.world->scene.exchange(ObjectId{3}, std::nullopt);
    ASSERT_TRUE(saveWorld(*opened.world));
    const auto deleted = filesIn(folder.path());
    Opened again{folder.path()};
    EXPECT_EQ(listed(again.complaints), "");
    EXPECT_TRUE(saveWorld(*again.world)->written.empty());
    EXPECT_EQ(number(again.world->scene.freshId()), 4u);

    again.world->scene.exchange(ObjectId{3}, last); // the deletion undone: the file is as it was
    ASSERT_TRUE(saveWorld(*again.world));
    EXPECT_EQ(filesIn(folder.path()), before);

    opened.world->scene.exchange(ObjectId{9}, last); // saved once and deleted in one sitting
    ASSERT_TRUE(saveWorld(*opened.world));
    opened.world->scene.exchange(ObjectId{9}, std::nullopt);
    ASSERT_TRUE(saveWorld(*opened.world));
    EXPECT_EQ(number(Opened(folder.path()).world->scene.freshId()), 10u);
}

TEST(Project, ADeletedTemplateTakesItsFileWithIt)
{
    const TemporaryFolder folder;
    writeSample(folder.path());
    const auto before = filesIn(folder.path());
    Opened opened{folder.path()};
    Scene& scene = opened.world->scene;
    const TemplateId marker = scene.findTemplate("marker");
    const auto object = scene.exchange(ObjectId{3}, std::nullopt);
    const auto value = scene.exchange(marker, std::nullopt);
    const auto saved = saveWorld(*opened.world);
    ASSERT_TRUE(saved);
    EXPECT_EQ(saved->removed, (std::vector<fs::path>{"templates/marker.json"}));
    EXPECT_FALSE(fs::exists(folder / "templates/marker.json"));
    EXPECT_EQ(get(folder / "project.json").find("marker"), std::string::npos);
    const Opened without{folder.path()};
    EXPECT_EQ(listed(without.complaints), "");
    EXPECT_EQ(without.world->project.templates, (std::vector<std::string>{"box"}));
    const auto again = saveWorld(*opened.world);
    EXPECT_TRUE(again->written.empty() && again->removed.empty());

    scene.exchange(marker, value); // undone after the save
    scene.exchange(ObjectId{3}, object);
    ASSERT_TRUE(saveWorld(*opened.world));
    EXPECT_EQ(filesIn(folder.path()), before);
}

TEST(Project, OnlyTheFileThatATemplateWasReadFromIsRemoved)
{
    const TemporaryFolder folder;
    writeSample(folder.path());
    put(folder / "templates/other.json", "mine"); // not of this project
    Opened opened{folder.path()};
    Scene& scene = opened.world->scene;
    scene.exchange(scene.templateSlot("other"), std::nullopt);
    scene.exchange(scene.findTemplate("marker"), std::nullopt);
    scene.exchange(scene.findTemplate("box"), std::nullopt);
    const std::string changed = get(folder / "templates/box.json") + "\n";
    put(folder / "templates/box.json", changed); // by another program
    fs::rename(folder / "templates/marker.json", folder / "templates/real.json");
    fs::create_symlink("real.json", folder / "templates/marker.json");
    const auto saved = saveWorld(*opened.world);
    ASSERT_TRUE(saved);
    EXPECT_EQ(saved->kept.size(), 2u);
    EXPECT_TRUE(saved->removed.empty());
    EXPECT_EQ(get(folder / "templates/other.json"), "mine");
    EXPECT_EQ(get(folder / "templates/box.json"), changed);
    EXPECT_TRUE(fs::exists(folder / "templates/marker.json"));
    EXPECT_TRUE(Opened(folder.path()).world->project.templates.empty());
}

TEST(Project, OtherScenesThatUseATemplateAreKnown)
{
    const TemporaryFolder folder;
    writeSample(folder.path());
    const Opened opened{folder.path()};
    EXPECT_EQ(otherScenesWith(*opened.world, "box"), (std::vector<std::string>{"night"}));
    EXPECT_TRUE(otherScenesWith(*opened.world, "yew").empty());
}

TEST(Project, FilesLaidOutByHandStayUntilTheyChange)
{
    const TemporaryFolder folder;
    writeSample(folder.path());
    const std::string byHand =
        "{ \"format\": \"wold-template\", \"version\": 1, \"category\": \"Things\", \"model\": \"models/box.glb\" }";
    put(folder / "templates/box.json", byHand);
    Opened opened{folder.path()};
    opened.world->scene.exchange(ObjectId{2}, std::nullopt);
    ASSERT_TRUE(saveWorld(*opened.world));
    EXPECT_EQ(get(folder / "templates/box.json"), byHand);
    const TemplateId box = opened.world->scene.findTemplate("box");
    Template changed = *opened.world->scene.find(box);
    changed.castShadow = false;
    opened.world->scene.exchange(box, changed);
    ASSERT_TRUE(saveWorld(*opened.world));
    EXPECT_NE(get(folder / "templates/box.json").find("\"cast_shadow\": false"), std::string::npos);
}

TEST(Project, DamagedSmallFilesAreComplainedOfAndNotOverwritten)
{
    const TemporaryFolder folder;
    writeSample(folder.path());
    put(folder / "templates/box.json", "{ broken");
    put(folder / "environments/day.json", "{ broken too");
    Opened opened{folder.path()};
    ASSERT_TRUE(opened.world) << opened.world.error().text();
    EXPECT_EQ(errorsIn(opened.complaints), 3)
        << listed(opened.complaints); // both files, and the objects of the template
    EXPECT_EQ(opened.world->scene.objects().size(), 3u);
    opened.world->scene.exchange(ObjectId{3}, std::nullopt);
    ASSERT_TRUE(saveWorld(*opened.world));
    EXPECT_EQ(get(folder / "templates/box.json"), "{ broken");
    EXPECT_EQ(get(folder / "environments/day.json"), "{ broken too");
    EXPECT_NE(get(folder / "scenes/main.scene.json").find("\"template\":\"box\""), std::string::npos);
    EXPECT_NE(get(folder / "project.json").find("\"box\""), std::string::npos);
}

TEST(Project, DamagedSmallFilesAreSetAsideBeforeTheyAreWrittenOver)
{
    const TemporaryFolder folder;
    writeSample(folder.path());
    const std::string environment = "{\n  \"time\": NaN\n}", box = "{ broken";
    put(folder / "environments/day.json", environment);
    put(folder / "templates/box.json", box);
    Opened opened{folder.path()};
    ASSERT_TRUE(opened.world) << opened.world.error().text();
    const std::string said = listed(opened.complaints);
    EXPECT_NE(said.find("day.json:2"), std::string::npos) << said;
    EXPECT_NE(said.find("day.json.bad"), std::string::npos) << said;
    Environment changed = opened.world->scene.environment();
    changed.time = 20;
    opened.world->scene.exchange(changed);
    opened.world->scene.exchange(opened.world->scene.findTemplate("box"), Template{.name = "box", .category = "New"});
    ASSERT_TRUE(saveWorld(*opened.world));
    EXPECT_EQ(get(folder / "environments/day.json.bad"), environment);
    EXPECT_EQ(get(folder / "templates/box.json.bad"), box);
    EXPECT_EQ(Opened(folder.path()).world->scene.environment().time, 20);
    EXPECT_TRUE(saveWorld(*opened.world)->written.empty());
}

TEST(Project, WhatCannotBeOpenedSaysWhy)
{
    const TemporaryFolder folder;
    EXPECT_NE(Opened(folder / "nowhere").world.error().what.find("there is no such project"), std::string::npos);
    EXPECT_NE(Opened(folder.path()).world.error().what.find("is no project"), std::string::npos);
    writeSample(folder.path());
    EXPECT_EQ(Opened(folder.path(), "dawn").world.error().what, "there is no scene \"dawn\"; there is main, night");
    fs::remove(folder / "scenes/night.scene.json");
    EXPECT_FALSE(Opened(folder.path(), "night").world);
    put(folder / "scenes/main.scene.json", "{\n\"objects\": [\n}");
    EXPECT_TRUE(
        Opened(folder.path()).world.error().text().starts_with((folder / "scenes/main.scene.json").string() + ":3: "))
        << Opened(folder.path()).world.error().text();
    put(folder / "project.json", "[]");
    EXPECT_FALSE(Opened(folder.path()).world);
}

TEST(Project, AnUnknownStartSceneIsMended)
{
    const TemporaryFolder folder;
    writeSample(folder.path());
    replace(folder / "project.json", "\"start\": \"main\"", "\"start\": \"dawn\"");
    const Opened opened{folder.path()};
    ASSERT_TRUE(opened.world);
    EXPECT_EQ(opened.world->entry.name, "main");
    EXPECT_EQ(errorsIn(opened.complaints), 1);
}

TEST(Project, NothingOutsideIsReadOrWritten)
{
    const TemporaryFolder outer;
    const fs::path folder = outer / "project";
    writeSample(folder);
    put(outer / "secret.json", "{}");
    replace(folder / "scenes/main.scene.json", "environments/day.json", "../secret.json");
    Opened opened{folder};
    ASSERT_TRUE(opened.world);
    EXPECT_NE(listed(opened.complaints).find("leads out of the project"), std::string::npos);
    EXPECT_FALSE(saveWorld(*opened.world));
    EXPECT_EQ(get(outer / "secret.json"), "{}");

    replace(folder / "project.json", "scenes/main.scene.json", "/etc/passwd");
    EXPECT_NE(Opened(folder).world.error().what.find("leads out of the project"), std::string::npos);
    replace(folder / "project.json", "/etc/passwd", "link.json");
    fs::create_symlink("/etc/passwd", folder / "link.json");
    EXPECT_NE(Opened(folder).world.error().what.find("leads out of the project"), std::string::npos);
    fs::remove(folder / "link.json");
    ::mkfifo((folder / "link.json").c_str(), 0600);
    EXPECT_NE(Opened(folder).world.error().what.find("not a regular file"), std::string::npos);
}

TEST(Project, ASaveThatIsKilledLeavesOldOrNew)
{
    const TemporaryFolder folder;
    writeSample(folder.path());
    World old = *Opened(folder.path()).world;
    World changed = old;
    changed.scene.exchange(ObjectId{1}, std::nullopt);
    changed.scene.exchange(std::vector<Camera>{});
    for (int microseconds = 0; microseconds < 60'000; microseconds += 3000) { // a kill from outside, at any moment
        ASSERT_TRUE(saveWorld(old));
        const pid_t child = ::fork();
        if (child == 0) {
            (void)saveWorld(changed);
            std::_Exit(0);
        }
        ::usleep(useconds_t(microseconds));
        ::kill(child, SIGKILL);
        ::waitpid(child, nullptr, 0);
        const Opened opened{folder.path()};
        ASSERT_TRUE(opened.world) << opened.world.error().text();
        EXPECT_TRUE(sameContent(opened.world->scene, old.scene) || sameContent(opened.world->scene, changed.scene))
            << microseconds;
        EXPECT_EQ(listed(opened.complaints), "");
    }
}

TEST(Assets, AreReadAndShared)
{
    const TemporaryFolder folder;
    writeSample(folder.path());
    Opened opened{folder.path()};
    Scene& scene = opened.world->scene;
    scene.exchange(scene.templateSlot("twin"), Template{.model = "models/box.glb"});
    std::atomic<int> steps{0};
    float last = 0;
    const Result<Assets> assets = readAssets(*opened.world, opened.complaints, [&](float fraction, std::string_view) {
        ++steps;
        last = fraction;
        return true;
    });
    ASSERT_TRUE(assets);
    EXPECT_EQ(listed(opened.complaints), "");
    ASSERT_EQ(assets->models.size(), 3u);
    EXPECT_EQ(assets->model(scene.findTemplate("box")), assets->model(scene.findTemplate("twin")));
    EXPECT_EQ(assets->model(scene.findTemplate("marker"))->bounds.size(), glm::vec3(1, 3, 1));
    ASSERT_NE(opened.world->scene.heights(), nullptr);
    EXPECT_NEAR(*opened.world->scene.heights()->height(1, 1), 5, 1e-3);
    ASSERT_EQ(assets->layers.size(), 1u);
    EXPECT_NE(assets->layers[0].colour, nullptr);
    EXPECT_EQ(assets->layers[0].normal, nullptr);
    EXPECT_GE(steps, 1);
    EXPECT_EQ(last, 1);
}

TEST(Assets, MissingOnesHaveStandIns)
{
    const TemporaryFolder folder;
    writeSample(folder.path());
    for (const char* heavy : {"models/box.glb", "terrain/h.png", "textures/grass.png"})
        fs::remove(folder / heavy);
    Opened opened{folder.path()};
    const Result<Assets> assets = readAssets(*opened.world, opened.complaints);
    ASSERT_TRUE(assets);
    EXPECT_EQ(errorsIn(opened.complaints), 3) << listed(opened.complaints);
    for (const auto& model : assets->models)
        ASSERT_NE(model, nullptr);
    EXPECT_EQ(opened.world->scene.heights(), nullptr);
    EXPECT_EQ(assets->layers[0].colour, nullptr);
}

TEST(Assets, ReadingCanBeCancelled)
{
    const TemporaryFolder folder;
    writeSample(folder.path());
    Opened opened{folder.path()};
    EXPECT_FALSE(readAssets(*opened.world, opened.complaints, [](float, std::string_view) { return false; }));
}

TEST(Assets, ALargeHeightMapTellsHowFarItIsAndCanBeCancelledWithin)
{
    const TemporaryFolder folder;
    writeSample(folder.path());
    ASSERT_TRUE(writeHeightMap16(folder / "terrain/h.png", {.size = {1500, 8000}, .metres = std::vector<float>(1500 * 8000, 5)}, 0, 10));
    const int jobs = 3; // heights, a texture, a model
    const auto within = [&](float fraction) { return std::abs(fraction * jobs - std::round(fraction * jobs)) > 1e-3f; };
    Opened opened{folder.path()};
    int parts = 0;
    float last = 0;
    ASSERT_TRUE(readAssets(*opened.world, opened.complaints, [&](float fraction, std::string_view) {
        EXPECT_GE(fraction, last);
        last = fraction;
        parts += within(fraction) ? 1 : 0;
        return true;
    }));
    EXPECT_GE(parts, 2);
    EXPECT_EQ(last, 1);

    Opened again{folder.path()};
    last = 0;
    const Result<Assets> stopped = readAssets(*again.world, again.complaints, [&](float fraction, std::string_view) {
        last = fraction;
        return !within(fraction);
    });
    ASSERT_FALSE(stopped);
    EXPECT_EQ(stopped.error().what, "reading was cancelled");
    EXPECT_EQ(again.world->scene.heights(), nullptr);
    EXPECT_EQ(listed(again.complaints), "");
}

TEST(CheckProject, NamesEveryFaultOnce)
{
    const TemporaryFolder folder;
    writeSample(folder.path());
    EXPECT_EQ(listed(checkProject(folder.path())), "");
    fs::remove(folder / "models/box.glb"); // used by both scenes
    replace(folder / "scenes/night.scene.json", "\"id\":1", "\"id\":2");
    const Complaints complaints = checkProject(folder.path());
    EXPECT_EQ(errorsIn(complaints), 2) << listed(complaints);
    EXPECT_NE(listed(complaints).find("night.scene.json:28: id: 2 is taken"), std::string::npos) << listed(complaints);
    EXPECT_EQ(errorsIn(checkProject(folder / "nowhere")), 1);
}

TEST(NewProject, IsACopyOfAStarterUnderItsOwnName)
{
    const TemporaryFolder folder;
    writeSample(folder / "resources/projects/sample");
    ::setenv("WOLD_RESOURCES", (folder / "resources").c_str(), 1);
    const Status made = newProject(folder / "my world", "sample");
    const Status again = newProject(folder / "my world", "sample");
    const Status unknown = newProject(folder / "other", "nope");
    const Status outside = newProject(folder / "other", "../projects/sample");
    ::unsetenv("WOLD_RESOURCES");
    ASSERT_TRUE(made) << made.error().text();
    EXPECT_FALSE(again);
    EXPECT_EQ(unknown.error().what, "there is no such starter; there is sample");
    EXPECT_FALSE(outside);
    EXPECT_FALSE(fs::exists(folder / "other"));
    const Opened opened{folder / "my world"};
    ASSERT_TRUE(opened.world);
    EXPECT_EQ(opened.world->project.name, "my world");
    EXPECT_EQ(listed(checkProject(folder / "my world")), "");
}

TEST(NewProject, MayFillAnEmptyFolder)
{
    const TemporaryFolder folder;
    writeSample(folder / "resources/projects/sample");
    fs::create_directory(folder / "empty");
    ::setenv("WOLD_RESOURCES", (folder / "resources").c_str(), 1);
    const Status made = newProject(folder / "empty/", "sample");
    ::unsetenv("WOLD_RESOURCES");
    ASSERT_TRUE(made) << made.error().text();
    EXPECT_TRUE(fs::exists(folder / "empty/project.json"));
}

} // namespace
} // namespace io
