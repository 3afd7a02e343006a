// project.json, environments and templates: exact text, round trips, and every fault with its line.
#include "support.h"

#include "io/files/documents.h"

namespace io {
namespace {

std::string environmentFaults(std::string text)
{
    Complaints complaints;
    const Result<Environment> read = readEnvironmentText(std::move(text), "e.json", complaints);
    return read ? listed(complaints) : "refused: " + read.error().text();
}

std::string environmentWith(const std::string& members)
{
    return "{\n\"format\": \"wold-environment\",\n\"version\": 1,\n" + members + "\n}";
}

TEST(EnvironmentFile, ReadsWell)
{
    Environment environment;
    environment.extra.add("aurora", R"({"strength":2})");
    environment.extra.add("sun.corona", "1.50");
    const std::string text = environmentText(environment);
    EXPECT_TRUE(text.starts_with(
        "{\n  \"format\": \"wold-environment\",\n  \"version\": 1,\n  \"time\": 10.5,\n  \"clock\": \"solar\",\n"))
        << text;
    EXPECT_NE(text.find("    \"irradiance\": [1,1,1],\n    \"angular_diameter\": 0.53,\n    \"corona\": 1.50\n  },\n"),
              std::string::npos)
        << text;
    EXPECT_TRUE(text.ends_with("    \"shading\": \"pbr\"\n  },\n  \"aurora\": {\"strength\":2}\n}\n")) << text;
}

TEST(EnvironmentFile, ComesBackAsItWas)
{
    Environment environment;
    environment.time = 6.1f;
    environment.sun.mode = SunMode::Manual;
    environment.fog.tint = {0.1f, 0.2f, 1.0f / 3};
    environment.extra.add("sun.a\\.b", "[1,{\"x\":null}]");
    Complaints complaints;
    const Result<Environment> back = readEnvironmentText(environmentText(environment), "e.json", complaints);
    ASSERT_TRUE(back) << back.error().text();
    EXPECT_EQ(*back, environment);
    EXPECT_EQ(environmentText(*back), environmentText(environment));
    EXPECT_EQ(listed(complaints), "e.json:28: sun.a.b: unknown key; kept as it is\n");
}

TEST(EnvironmentFile, MissingKeysHaveTheirDefaults)
{
    Complaints complaints;
    const Result<Environment> read = readEnvironmentText(environmentWith("\"time\": 3"), "e.json", complaints);
    ASSERT_TRUE(read);
    Environment expected;
    expected.time = 3;
    EXPECT_EQ(*read, expected);
    EXPECT_TRUE(complaints.empty());
}

TEST(EnvironmentFile, FaultsAreNamedWithLineAndKey)
{
    EXPECT_EQ(environmentFaults(environmentWith("\"time\": \"noon\"")),
              "e.json:4: time: expected a number, found \"noon\"\n");
    EXPECT_EQ(environmentFaults(environmentWith("\"sun\": {\n\"mode\": \"x\"}")),
              "e.json:5: sun.mode: expected time or manual, found \"x\"\n");
    EXPECT_EQ(environmentFaults(environmentWith("\"sun\": [1]")),
              "e.json:4: sun: expected an object in braces, found a list of 1\n");
    EXPECT_EQ(environmentFaults(environmentWith("\"time\": 25")), "e.json:4: time: 25 is outside 0 to 24 h\n");
    EXPECT_EQ(environmentFaults(environmentWith("\"time\": 1e999")), "e.json:4: time: must be a finite number\n");
    EXPECT_EQ(environmentFaults(environmentWith("\"time\": 1,\n\"time\": 2")),
              "e.json:5: time: the key appears twice; the first is used\n");
    EXPECT_EQ(environmentFaults(environmentWith("\"fog\": {\"tint\": [1,\"a\",1]}")),
              "e.json:4: fog.tint: expected a number, found \"a\"\n");
    EXPECT_EQ(environmentFaults(environmentWith("\"fog\": {\"tint\": [[1],{},1]}")),
              "e.json:4: fog.tint: expected a number, found null\n");
    EXPECT_EQ(environmentFaults(environmentWith("\"day_of_year\": 1.5")),
              "e.json:4: day_of_year: 1.5 must be a whole number\n");
    EXPECT_EQ(environmentFaults(environmentWith("\"tme\": 1")), "e.json:4: tme: unknown key; kept as it is\n");
}

TEST(EnvironmentFile, ValuesOutsideAreMovedToTheNearestEnd)
{
    Complaints complaints;
    const Result<Environment> read = readEnvironmentText(environmentWith("\"time\": 25"), "e.json", complaints);
    EXPECT_EQ(read->time, 24);
    EXPECT_EQ(errorsIn(complaints), 1);
}

TEST(EnvironmentFile, EndsOfCascadesMustRise)
{
    EXPECT_EQ(environmentFaults(environmentWith("\"shadows\": {\n\"splits\": \"manual\",\n\"end_1\": 60,\n\"end_2\": 50}")),
              "e.json:7: shadows.end_2: 50 m must be beyond end_1, 60 m\n");
    EXPECT_EQ(environmentFaults(environmentWith("\"shadows\": {\n\"splits\": \"manual\",\n\"end_1\": 60}")),
              "e.json:4: shadows.end_2: 45 m must be beyond end_1, 60 m\n");
    EXPECT_EQ(environmentFaults(environmentWith("\"shadows\": {\"end_1\": 60, \"end_2\": 50}")), "");
    Complaints complaints;
    const Result<Environment> read = readEnvironmentText(
        environmentWith("\"shadows\": {\"splits\": \"manual\", \"end_1\": 60, \"end_2\": 50}"), "e.json", complaints);
    EXPECT_EQ(read->shadows.end1, 60);
    EXPECT_GT(read->shadows.end2, 60) << "so that there are shadows all the same";
    EXPECT_EQ(errorsIn(complaints), 1);
}

TEST(EnvironmentFile, LimitsOfTheExposureAreInOrder)
{
    Complaints complaints;
    const Result<Environment> read = readEnvironmentText(environmentWith("\"auto_exposure\": {\n\"lowest\": 12,\n\"highest\": 3}"), "e.json", complaints);
    EXPECT_EQ(listed(complaints), "e.json:6: auto_exposure.highest: 3 EV must not be below lowest, 12 EV\n");
    EXPECT_EQ(read->autoExposure.lowest, 12);
    EXPECT_EQ(read->autoExposure.highest, 12);
}

TEST(EnvironmentFile, HazeScattersNoMoreThanItTakesAway)
{
    Complaints complaints;
    const Result<Environment> read = readEnvironmentText(environmentWith("\"sky\": {\n\"mie_scattering\": 8,\n\"mie_extinction\": 5}"), "e.json", complaints);
    EXPECT_EQ(listed(complaints), "e.json:6: sky.mie_extinction: 5 1e-6/m must not be below mie_scattering, 8 1e-6/m\n");
    EXPECT_EQ(read->sky.mieScattering, 8);
    EXPECT_EQ(read->sky.mieExtinction, 8);
}

TEST(EnvironmentFile, RainAndSnowGoAsFarAsTheyAct)
{
    EXPECT_EQ(environmentFaults(environmentWith("\"weather\": {\"rain\": 60, \"snow\": 11}")),
              "e.json:4: weather.rain: 60 is outside 0 to 50 mm/h\ne.json:4: weather.snow: 11 is outside 0 to 10 mm/h\n");
}

TEST(EnvironmentFile, HeadersAreChecked)
{
    EXPECT_EQ(environmentFaults("{}"), "e.json:1: format: missing; add \"format\": \"wold-environment\"\n"
                                       "e.json:1: version: missing; add \"version\": 1\n");
    EXPECT_EQ(environmentFaults(R"({"format":"wold-scene","version":1})"),
              "refused: e.json:1: format: \"wold-scene\" where \"wold-environment\" was expected");
    EXPECT_EQ(environmentFaults(R"({"format":"wold-environment","version":2,"new":1})"),
              "refused: e.json:1: version: 2 was written by a newer Wold; this one reads 1: update Wold");
}

TEST(EnvironmentFile, BrokenTextIsRefusedWithItsLine)
{
    const std::string whole = environmentText(Environment{});
    for (const std::string& broken :
         {std::string{}, std::string{"["}, std::string{"{"}, std::string{"{\"a\" 1}"}, std::string{"{} x"},
          std::string{"{\"time\":01}"}, std::string{"{\"time\":tru}"}, std::string{"{\"x\":[[1}]}"},
          std::string{"{\"time\":1.2.3}"}, std::string{"{\"x\":nul}"}, std::string{"{\"x\":\"\xFF\"}"},
          whole.substr(0, whole.size() / 2), whole + "}", std::string(100'000, '['),
          "{\"x\":" + std::string(100'000, '[') + std::string(100'000, ']') + "}"}) {
        const std::string fault = environmentFaults(broken);
        EXPECT_TRUE(fault.starts_with("refused: e.json:")) << broken.substr(0, 40) << " -> " << fault;
    }
}

TEST(EnvironmentFile, MarksAndReturnsAreNoMatter)
{
    std::string text = "\xEF\xBB\xBF" + environmentText(Environment{});
    for (std::size_t at = 0; (at = text.find('\n', at)) != std::string::npos; at += 2)
        text.insert(at, "\r");
    EXPECT_EQ(environmentFaults(text), "");
}

TEST(EnvironmentFile, ComplaintsAreCapped)
{
    std::string members;
    for (int i = 0; i < 1000; ++i)
        members += (i ? ",\n\"k" : "\"k") + std::to_string(i) + "\": 1";
    Complaints complaints;
    ASSERT_TRUE(readEnvironmentText(environmentWith(members), "e.json", complaints));
    ASSERT_EQ(complaints.size(), 51u);
    EXPECT_EQ(complaints.back().what, "950 more like these");
}

TEST(TemplateFile, ComesBackAsItWas)
{
    Template thing;
    thing.model = "models/\"oak\".glb";
    thing.scale = {0.8f, 1.2f};
    thing.alignToGround = true;
    thing.collision = Collision::Capsule;
    thing.extra.add("sway", "0.30");
    Complaints complaints;
    const Result<Template> back = readTemplateText(templateText(thing), "t.json", complaints);
    ASSERT_TRUE(back);
    EXPECT_EQ(*back, thing);
    EXPECT_EQ(complaints.size(), 1u);
}

TEST(ProjectFile, HasASceneATemplateACameraAndAKeyOnALineEach)
{
    ProjectBody project{
        .name = "Valley", .start = "main", .scenes = {{"main", "scenes/main.scene.json"}}, .templates = {"oak", "fir"}};
    project.cameras = {{.name = "hill", .eye = {1, 2, 3}}};
    project.paths = {{.name = "tour", .keys = {{.time = 0}, {.time = 2.5, .eye = {4, 5, 6}}}}};
    project.cameras[0].extra.add("lens", "{\"mm\":35}");
    project.extra.add("paths.0.keys.1.ease", "\"in\"");
    project.extra.add("input", "[]");
    const std::string text = projectText(project);
    EXPECT_EQ(text, R"({
  "format": "wold-project",
  "version": 1,
  "name": "Valley",
  "start": "main",
  "scenes": [
    {"name": "main", "file": "scenes/main.scene.json"}
  ],
  "templates": [
    "oak",
    "fir"
  ],
  "cameras": [
    {"name": "hill", "eye": [1,2,3], "yaw": 0, "pitch": 0, "fov": 60, "lens": {"mm":35}}
  ],
  "paths": [
    {
      "name": "tour",
      "keys": [
        {"time": 0, "eye": [0,0,0], "yaw": 0, "pitch": 0, "fov": 60},
        {"time": 2.5, "eye": [4,5,6], "yaw": 0, "pitch": 0, "fov": 60}
      ]
    }
  ],
  "input": []
}
)");
}

TEST(ProjectFile, UnknownKeysSurviveWhereTheyWere)
{
    const std::string text = R"({"format":"wold-project","version":1,"scenes":[{"name":"a","file":"b","mood":"calm"}],
"cameras":[{"name":"c","lens":{"mm": 35}}],"paths":[{"name":"p","keys":[{"time":0,"ease":"in"}],"loop":true}],"input":[ ]})";
    Complaints complaints;
    const Result<ProjectBody> once = readProjectText(text, "project.json", complaints);
    ASSERT_TRUE(once);
    EXPECT_EQ(listed(complaints), "project.json:1: scenes.0.mood: unknown key; kept as it is\n"
                                  "project.json:2: cameras.0.lens: unknown key; kept as it is\n"
                                  "project.json:2: paths.0.keys.0.ease: unknown key; kept as it is\n"
                                  "project.json:2: paths.0.loop: unknown key; kept as it is\n"
                                  "project.json:2: input: unknown key; kept as it is\n");
    const std::string written = projectText(*once);
    for (const char* kept :
         {"\"mood\": \"calm\"", "\"lens\": {\"mm\":35}", "\"ease\": \"in\"", "\"loop\": true", "\"input\": []"})
        EXPECT_NE(written.find(kept), std::string::npos) << kept << " in " << written;
    const Result<ProjectBody> twice = readProjectText(written, "project.json", complaints);
    ASSERT_TRUE(twice);
    EXPECT_EQ(*twice, *once);
    EXPECT_EQ(projectText(*twice), written);
}

} // namespace
} // namespace io
