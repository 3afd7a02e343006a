#include "support.h"

#include "io/files/scene_file.h"

#include <chrono>
#include <random>

namespace io {
namespace {

Scene sceneWithTemplates()
{
    Scene scene;
    for (const char* name : {"oak", "rock"})
        scene.exchange(scene.templateSlot(name), Template{});
    return scene;
}

Object placed(const Scene& scene, const char* name, const glm::dvec3& position)
{
    Object object;
    object.templateId = scene.findTemplate(name);
    object.transform.position = position;
    return object;
}

Scene smallScene()
{
    Scene scene = sceneWithTemplates();
    Terrain terrain;
    terrain.heightMap = "terrain/h.png";
    scene.exchange(terrain);
    scene.exchange(ObjectId{12}, placed(scene, "rock", {0.1, -2, 1e6}));
    Object oak = placed(scene, "oak", {1, 2, 3});
    oak.transform.rotation = {0, 45.5f, 0};
    oak.transform.scale = {1.1f, 1.1f, 1.1f};
    oak.parent = ObjectId{3};
    oak.name = "starý dub";
    oak.extra.add("age", "120");
    scene.exchange(ObjectId{4}, oak);
    Object group;
    group.name = "grove";
    scene.exchange(ObjectId{3}, group);
    return scene;
}

const char* const kSmallText = R"({
  "format": "wold-scene",
  "version": 1,
  "environment": "environments/day.json",
  "terrain": {
    "height_map": "terrain/h.png",
    "metres_per_texel": 1,
    "origin": [0,0],
    "min_height": 0,
    "max_height": 100,
    "layers": []
  },
  "objects": [
{"id":3,"template":"","name":"grove","position":[0,0,0]},
{"id":4,"template":"oak","name":"starý dub","position":[1,2,3],"rotation":[0,45.5,0],"scale":[1.1,1.1,1.1],"parent":3,"age":120},
{"id":12,"template":"rock","position":[0.1,-2,1000000]}
]}
)";

struct Read {
    Scene scene = sceneWithTemplates();
    Complaints complaints;
    Result<std::string> environment{std::string{}};
    explicit Read(std::string text) { environment = readSceneText(std::move(text), "s.json", scene, complaints); }
    std::string faults() const { return environment ? listed(complaints) : "refused: " + environment.error().text(); }
};

std::string sceneOf(const std::string& objects)
{
    return "{\"format\":\"wold-scene\",\"version\":1,\"environment\":\"e\",\"objects\":[\n" + objects + "\n]}";
}

TEST(SceneFile, HasOneObjectALine)
{
    EXPECT_EQ(sceneText(smallScene(), "environments/day.json"), kSmallText);
}

TEST(SceneFile, ComesBackAsItWas)
{
    const Read read{kSmallText};
    ASSERT_TRUE(read.environment);
    EXPECT_EQ(*read.environment, "environments/day.json");
    EXPECT_TRUE(sameContent(read.scene, smallScene()));
    EXPECT_EQ(sceneText(read.scene, *read.environment), kSmallText);
    EXPECT_EQ(read.faults(), "s.json:15: age: unknown key; kept as it is\n");
}

TEST(SceneFile, MovingOneObjectChangesOneLine)
{
    Scene scene = smallScene();
    const std::string before = sceneText(scene, "e");
    Object moved = scene.at(ObjectId{12});
    moved.transform.position.x += 1;
    scene.exchange(ObjectId{12}, moved);
    const std::string after = sceneText(scene, "e");
    const std::size_t line = before.find("{\"id\":12");
    EXPECT_EQ(before.substr(0, line), after.substr(0, line));
    EXPECT_EQ(before.substr(before.find('\n', line)), after.substr(after.find('\n', line)));
}

TEST(SceneFile, AnEmptySceneIsTheSameBytesTwice)
{
    const std::string text = sceneText(Scene{}, "e");
    EXPECT_TRUE(text.ends_with("\"objects\": []\n}\n")) << text;
    EXPECT_EQ(sceneText(Read{text}.scene, "e"), text);
}

TEST(SceneFile, UnknownKeysOfTheSceneAndItsTerrainSurvive)
{
    const Read read{R"({"format":"wold-scene","version":1,"environment":"e","weather":{"rain": 1},
"terrain":{"holes":[],"layers":[{"name":"grass","wet":true}]},"objects":[]})"};
    const std::string text = sceneText(read.scene, "e");
    for (const char* kept : {"\"weather\": {\"rain\":1}", "\"holes\": []", "\"wet\": true"})
        EXPECT_NE(text.find(kept), std::string::npos) << text;
    EXPECT_EQ(sceneText(Read{text}.scene, "e"), text);
}

TEST(SceneFile, ObjectsMayComeInAnyOrderAndLayout)
{
    const Read read{
        "{\"objects\":[{\"position\":[1,0,0],\"template\":\"oak\",\n\"id\":9}\n,{\"id\":2,\"template\":\"rock\"}],"
        "\"environment\":\"e\",\"version\":1,\"format\":\"wold-scene\"}"};
    EXPECT_EQ(read.faults(), "");
    EXPECT_EQ(read.scene.at(ObjectId{9}).transform.position.x, 1);
}

TEST(SceneFile, FaultsOfObjectsAreNamedWithTheirLine)
{
    EXPECT_EQ(Read{sceneOf(R"({"id":1,"template":"oak","position":[1,"2",3]})")}.faults(),
              "s.json:2: position: expected a number, found \"2\"\n");
    EXPECT_EQ(Read{sceneOf("{\"id\":1,\"template\":\"oak\"},\n{\"id\":1,\"template\":\"rock\"}")}.faults(),
              "s.json:3: id: 1 is taken by an object above; this one is left out\n");
    EXPECT_EQ(Read{sceneOf(R"({"id":1,"template":"oak","position":[1e8,0,0]})")}.faults(),
              "s.json:2: position: 100000000 is outside -10000000 to 10000000 m\n");
    EXPECT_EQ(Read{sceneOf(R"({"id":1,"template":"oak","position":[1e999,0,0]})")}.faults(),
              "s.json:2: position: must be a finite number\n");
    EXPECT_EQ(Read{sceneOf(R"({"id":1,"template":"oak","position":[1e999,"2",3]})")}.faults(),
              "s.json:2: position: must be a finite number\n");
    EXPECT_EQ(Read{sceneOf(R"({"id":1,"template":"oak","position":[1,2]})")}.faults(),
              "s.json:2: position: expected 3 numbers in brackets, found a list of 2\n");
    EXPECT_EQ(Read{sceneOf(R"({"id":1,"template":"oak","position":[1,2,3,"4"]})")}.faults(),
              "s.json:2: position: expected 3 numbers in brackets, found a list of 4\n");
    EXPECT_EQ(Read{sceneOf(R"({"id":1,"template":"oak","position":[]})")}.faults(),
              "s.json:2: position: expected 3 numbers in brackets, found a list of 0\n");
    EXPECT_EQ(Read{sceneOf(R"({"id":1,"template":"oak","scale":[1,0,1]})")}.faults(),
              "s.json:2: scale: 0 is too small; made 0.000001\n");
    EXPECT_EQ(Read{sceneOf(R"({"id":1,"template":"oak","scale":[1,1e999,1]})")}.faults(),
              "s.json:2: scale: must be a finite number\n");
    EXPECT_EQ(Read{sceneOf(R"({"id":1,"template":"oak","rotation":[0,NaN,0]})")}.faults().substr(0, 17), "refused: s.json:2");
    EXPECT_EQ(Read{sceneOf(R"({"id":1,"template":7})")}.faults(),
              "s.json:2: template: expected a text in quotes, found 7\n");
    EXPECT_EQ(Read{sceneOf(R"({"id":-1,"template":"oak"})")}.faults().substr(0, 15), "s.json:2: id: -");
    EXPECT_EQ(Read{sceneOf(R"({"id":4294967296,"template":"oak"})")}.faults(),
              "s.json:2: id: 4294967296 is outside 1 to 4000000000\n");
    EXPECT_EQ(Read{sceneOf("5")}.faults(), "s.json:2: objects: expected an object in braces; left out\n");
    EXPECT_EQ(Read{R"({"format":"wold-scene","version":1,"environment":"e","objects":{}})"}.faults(),
              "s.json:1: objects: expected a list in brackets\n");
}

TEST(SceneFile, AnUnknownTemplateMakesAnEmptySlotAndIsNamedOnce)
{
    const Read read{sceneOf("{\"id\":1,\"template\":\"yew\"},\n{\"id\":2,\"template\":\"yew\"}")};
    EXPECT_EQ(read.faults(),
              "s.json:2: template: \"yew\" is no template of this project; add it, or the objects stay empty places\n");
    const TemplateId yew = read.scene.findTemplate("yew");
    EXPECT_EQ(read.scene.find(yew), nullptr);
    EXPECT_EQ(read.scene.at(ObjectId{2}).templateId, yew);
    EXPECT_NE(sceneText(read.scene, "e").find("\"template\":\"yew\""), std::string::npos);
}

TEST(SceneFile, ObjectsWithoutIdGetFreshOnes)
{
    const Read read{sceneOf("{\"template\":\"oak\"},\n{\"id\":5,\"template\":\"rock\"}")};
    EXPECT_EQ(read.scene.objects().size(), 2u);
    ASSERT_NE(read.scene.find(ObjectId{6}), nullptr);
    EXPECT_EQ(read.scene.templateName(read.scene.at(ObjectId{6}).templateId), "oak");
}

TEST(SceneFile, TheLastIdIsWrittenWhereNoObjectHasItAnyMore)
{
    Scene scene = smallScene();
    scene.lastSavedId = ObjectId{12};
    EXPECT_EQ(sceneText(scene, "environments/day.json"), kSmallText);
    scene.lastSavedId = ObjectId{17};
    const std::string text = sceneText(scene, "e");
    EXPECT_NE(text.find("},\n  \"last_id\": 17,\n  \"objects\": ["), std::string::npos) << text;
    Read read{text};
    EXPECT_EQ(read.faults(), "s.json:16: age: unknown key; kept as it is\n");
    EXPECT_EQ(sceneText(read.scene, "e"), text);
    EXPECT_EQ(number(read.scene.freshId()), 18u);
}

TEST(SceneFile, AnyLastIdLeavesRoomForFreshOnes)
{
    Read below{R"({"format":"wold-scene","version":1,"environment":"e","objects":[{"template":"oak"},
{"id":5,"template":"oak"}],"last_id":2})"};
    EXPECT_EQ(below.faults(), "s.json:1: id: missing; the object gets a new one\n");
    EXPECT_NE(below.scene.find(ObjectId{6}), nullptr);
    Read above{R"({"format":"wold-scene","version":1,"environment":"e","objects":[{"template":"oak"}],"last_id":7})"};
    EXPECT_NE(above.scene.find(ObjectId{8}), nullptr); // wherever the key stands
    Read wrong{R"({"format":"wold-scene","version":1,"environment":"e","objects":[],"last_id":4294967295})"};
    EXPECT_EQ(wrong.faults(), "s.json:1: last_id: 4294967295 is outside 1 to 4000000000\n");
    EXPECT_GT(number(wrong.scene.freshId()), 0u);
    Read last{sceneOf("{\"id\":4294967295,\"template\":\"oak\"}")};
    EXPECT_EQ(last.faults(), "s.json:2: id: 4294967295 is outside 1 to 4000000000\n");
    EXPECT_GT(number(last.scene.freshId()), 0u);
}

TEST(SceneFile, ParentsThatAreMissingOrCircularAreRemoved)
{
    const Read read{
        sceneOf("{\"id\":1,\"template\":\"\",\"parent\":2},\n{\"id\":2,\"template\":\"\",\"parent\":3},\n"
                "{\"id\":3,\"template\":\"\",\"parent\":1},\n{\"id\":4,\"template\":\"oak\",\"parent\":1},\n"
                "{\"id\":5,\"template\":\"oak\",\"parent\":99},\n{\"id\":6,\"template\":\"oak\",\"parent\":6}")};
    EXPECT_EQ(read.faults(), "s.json:6: parent: 99 is no object of this scene; removed\n"
                             "s.json:2: parent: 2 makes a circle of parents; removed\n"
                             "s.json:7: parent: 6 makes a circle of parents; removed\n");
    EXPECT_EQ(read.scene.at(ObjectId{1}).parent, ObjectId::None);
    EXPECT_EQ(read.scene.at(ObjectId{2}).parent, ObjectId{3});
    EXPECT_EQ(read.scene.at(ObjectId{4}).parent, ObjectId{1});
}

TEST(SceneFile, CutOffTextIsRefused)
{
    const std::string whole = kSmallText;
    for (std::size_t size = 0; size + 2 < whole.size(); ++size)
        ASSERT_FALSE(Read{whole.substr(0, size)}.environment) << size;
}

TEST(SceneFile, AHundredThousandObjectsComeAndGoQuickly)
{
    Scene scene = sceneWithTemplates();
    std::mt19937 random{1};
    std::uniform_real_distribution<double> metres{-1000, 1000};
    for (std::uint32_t id = 1; id <= 100'000; ++id) {
        Object object = placed(scene, id % 2 ? "oak" : "rock", {metres(random), metres(random), metres(random)});
        object.transform.rotation.y = float(metres(random));
        object.transform.scale = glm::vec3{float(1 + metres(random) / 2000)};
        scene.exchange(ObjectId{id}, object);
    }
    const auto start = std::chrono::steady_clock::now();
    const std::string text = sceneText(scene, "e");
    const Read read{text};
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
    EXPECT_EQ(sceneText(read.scene, "e"), text);
    EXPECT_TRUE(sameContent(read.scene, scene));
#ifndef __SANITIZE_ADDRESS__ // which is no clock
    EXPECT_LT(seconds.count(), 5); // 0.3 s where it was written; slack for busy machines
#endif
}

} // namespace
} // namespace io
