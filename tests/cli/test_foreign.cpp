// A world of things that nobody here made: measured ground of the Andes, Kenney's houses, Proton Scatter's trees and
// rocks. It is put together at run time, and skipped where the test data is absent.
#include "io/files/atomic_file.h"
#include "io/files/image_file.h"
#include "io/files/json.h"
#include "io/files/project.h"
#include "tests/cli/wold.h"

#include <algorithm>
#include <cstdlib>
#include <fmt/format.h>
#include <set>

namespace test {
namespace {

namespace fs = std::filesystem;

constexpr double kTexel = 90; // m, SRTM's 3 arc-seconds
constexpr const char* kMap = "andes-aconcagua-1024-u16.png";

fs::path dataFolder()
{
    const char* set = std::getenv("WOLD_TEST_DATA");
    return set ? set : "";
}

glm::dvec2 metresOf(const fs::path& list, std::string_view map)
{
    const io::Value all = json(textOf(list));
    for (const io::Value& entry : *all.asArray())
        if (text(entry, "file") == map) return {number(entry, "min_m"), number(entry, "max_m")};
    ADD_FAILURE() << "heightmaps.json does not name " << map;
    return {};
}

// The texel whose surroundings are the most level, below the snow: where a person would build.
glm::ivec2 levelPlace(const io::Image& map, glm::dvec2 metres)
{
    const auto height = [&](int x, int z) {
        return glm::mix(metres.x, metres.y, double(map.row<std::uint16_t>(z)[x * map.channels]) / 65535);
    };
    glm::ivec2 best{map.size / 2};
    double least = 1e9; // m between neighbours
    for (int z = 200; z < map.size.y - 200; ++z)
        for (int x = 200; x < map.size.x - 200; ++x) {
            double step = 0;
            for (int i = -2; i <= 2; ++i)
                for (int j = -2; j <= 2; ++j)
                    step = std::max(step, std::abs(height(x + i, z + j) - height(x, z)));
            if (step < least && height(x, z) > 2000 && height(x, z) < 3800) best = {x, z}, least = step;
        }
    return best;
}

struct Foreign : testing::Test {
    Folder folder;
    fs::path data = dataFolder();
    fs::path project = folder.path() / "andes";
    io::World world;

    void SetUp() override
    {
        if (data.empty() || !fs::exists(data / "heightmaps" / kMap))
            GTEST_SKIP() << "no test data at WOLD_TEST_DATA (" << data.string() << ")";
        world.project = {
            .folder = project, .name = "Andes", .scenes = {{"main", "scenes/main.scene.json"}}, .start = "main"};
        world.entry = world.project.scenes.front();
        world.environmentFile = "environments/andes.json";
        addGround();
        addModels("kenney-city", {"building-small-a", "building-small-b", "building-garage", "grass-trees-tall"},
                  "Houses", 4);
        addModels("proton-scatter", {"tree", "pine_tree", "bush", "large_rock", "small_rock"}, "Plants", 1);
        world.scene.exchange(std::vector<io::Camera>{{.name = "village", .eye = {0, 0, 0}}});
        const auto saved = io::saveWorld(world);
        ASSERT_TRUE(saved) << saved.error().text();
    }

    void addGround()
    {
        const glm::dvec2 metres = metresOf(data / "heightmaps/heightmaps.json", kMap);
        fs::create_directories(project / "terrain");
        fs::copy_file(data / "heightmaps" / kMap, project / "terrain/andes.png");
        const auto map = io::readImage(project / "terrain/andes.png");
        ASSERT_TRUE(map) << map.error().text();
        ASSERT_EQ(map->type, io::PixelType::U16);
        io::Terrain terrain{.heightMap = "terrain/andes.png",
                            .metresPerTexel = kTexel,
                            .origin = -glm::dvec2{levelPlace(*map, metres)} * kTexel,
                            .minHeight = metres.x,
                            .maxHeight = metres.y};
        terrain.layers = {{.name = "scree", .colour = {0.32f, 0.27f, 0.22f}},
                          {.name = "snow", .colour = {0.85f, 0.88f, 0.92f}, .altitude = {4300, 1e5f}}};
        world.scene.exchange(terrain);
    }

    void addModels(const std::string& from, const std::vector<std::string>& names, const char* category, float scale)
    {
        const fs::path source = data / "corpus/gltf-valid" / from;
        fs::create_directories(project / "models" / from);
        for (const std::string& name : names) {
            fs::copy_file(source / (name + ".glb"), project / "models" / from / (name + ".glb"));
            world.project.templates.push_back(name);
            world.scene.exchange(world.scene.templateSlot(name),
                                 io::Template{.name = name,
                                              .category = category,
                                              .model = "models/" + from + "/" + name + ".glb",
                                              .scale = {scale, scale * 1.3f}});
        }
        if (fs::exists(source / "Textures"))
            fs::copy(source / "Textures", project / "models" / from / "Textures", fs::copy_options::recursive);
    }

    std::vector<io::Value> runScript(const std::string& script)
    {
        const Ran ran = wold({"run", project.string(), "-", "--quiet", "--size", "640x360"}, script);
        EXPECT_EQ(ran.code, 0) << ran.err << ran.out;
        std::vector<io::Value> answers;
        for (const std::string& line : linesOf(ran.out))
            answers.push_back(json(line));
        return answers;
    }
    std::string scene() const { return textOf(project / "scenes/main.scene.json"); }
};

double at(const io::Value& vector, std::size_t i)
{
    return *(*vector.asArray())[i].asNumber();
}

bool hasManyColours(const io::Image& image)
{
    std::set<int> seen;
    for (int y = 0; y < image.size.y; y += 3)
        for (int x = 0; x < image.size.x; x += 3) {
            const auto* p = image.row<std::uint8_t>(y) + x * image.channels;
            seen.insert((p[0] >> 4) << 8 | (p[1] >> 4) << 4 | p[2] >> 4);
        }
    return seen.size() > 40;
}

TEST_F(Foreign, opensDrawsPicksPlacesSavesAndReadsAgain)
{
    const auto height = runScript(R"({"do": "height", "at": [0, 0]})");
    ASSERT_EQ(height.size(), 1u);
    const double ground = number(height[0], "height");
    EXPECT_GT(ground, 2000);
    EXPECT_LT(ground, 3800);

    // A village, a wood around it, and a look at both.
    const std::string view = fmt::format("0,{},70,0,-12,60", ground + 30);
    const auto placed = runScript(R"({"do": "place", "template": "building-small-a", "at": [0, 0, 0]}
{"do": "drop", "ids": [1]}
{"do": "scatter", "templates": ["building-small-b", "building-garage"], "center": [0, 0], "radius": 40, "density": 0.002, "seed": 3}
{"do": "scatter", "templates": ["tree", "pine_tree", "bush", "large_rock", "grass-trees-tall"], "center": [0, 0], "radius": 120, "density": 0.01, "seed": 4}
{"do": "save"}
)");
    ASSERT_EQ(placed.size(), 5u);
    const io::Value facts = json(wold({"info", project.string(), "--json", "-", "--quiet"}).out);
    EXPECT_GT(number(facts, "instances"), 300);
    EXPECT_GT(number(facts, "triangles"), 10'000);

    const fs::path picture = fs::path{WOLD_TEST_OUT} / "andes.png"; // kept, to be looked at
    const Ran drawn =
        wold({"render", project.string(), "--view", view, "--out", picture.string(), "--size", "960x540", "--quiet"});
    ASSERT_EQ(drawn.code, 0) << drawn.err;
    const auto image = io::readImage(picture);
    ASSERT_TRUE(image);
    EXPECT_TRUE(hasManyColours(*image));

    // What is drawn in the middle is what a click finds, and what is placed there stands there.
    const std::string points = folder.write("points", "320 200\n320 5\n");
    const Ran picked = wold({"pick", project.string(), "--points", points, "--view", view, "--size", "640x360"});
    ASSERT_EQ(picked.code, 0) << picked.err;
    const io::Value hit = json(linesOf(picked.out).at(0));
    EXPECT_NE(text(hit, "surface"), "none");
    const auto added = runScript(fmt::format(R"({{"do": "view", "eye": [0, {}, 70], "yaw": 0, "pitch": -12, "fov": 60}}
{{"do": "place", "template": "large_rock", "pixel": [320, 200]}}
{{"do": "save"}}
)",
                                             ground + 30));
    const double id = number(added.at(1), "id");
    const auto rock = runScript(fmt::format(R"({{"do": "object", "id": {}}})", id));
    EXPECT_LT(std::abs(at(*rock.at(0).find("position"), 0) - at(*hit.find("position"), 0)), 1);

    const std::string saved = scene();
    const auto again = runScript("{\"do\": \"save\"}\n");
    EXPECT_EQ(scene(), saved);
    EXPECT_EQ(wold({"check", project.string()}).code, 0);
}

} // namespace
} // namespace test
