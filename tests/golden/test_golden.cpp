// Golden pictures: each entry of pictures.json is drawn and compared with pictures/NAME.png. A picture that is too far
// off leaves NAME.now.png and NAME.difference.png in the build folder.
#include "editor/ground_making.h"
#include "io/files/atomic_file.h"
#include "io/files/image_file.h"
#include "io/files/json.h"
#include "io/scene/environment_presets.h"
#include "tests/golden/compare.h"
#include "tests/golden/valley.h"

#include <cmath>
#include <cstdlib>
#include <gtest/gtest.h>

namespace test {
namespace {

namespace fs = std::filesystem;

const fs::path kFolder = fs::path{WOLD_SOURCE_DIR} / "tests/golden";
const fs::path kOut = WOLD_GOLDEN_OUT;

struct Golden {
    std::string name, camera;
    renderer::Show show = renderer::Show::Final;
    std::string look; // of the day; empty: the world's own
    double mean = 1, outliers = 0.005; // tolerances; drivers round differently at edges
};

std::string textOr(const io::Value& entry, std::string_view key, std::string otherwise)
{
    const io::Value* value = entry.find(key);
    return value ? *value->asString() : otherwise;
}

double numberOr(const io::Value& entry, std::string_view key, double otherwise)
{
    const io::Value* value = entry.find(key);
    return value ? *value->asNumber() : otherwise;
}

std::vector<Golden> readList()
{
    const auto text = io::readFile(kFolder / "pictures.json");
    EXPECTS(text);
    const auto list = io::parseJson(*text, "pictures.json");
    EXPECTS(list);
    std::vector<Golden> result;
    const auto names = enumNames(renderer::Show{});
    for (const io::Value& entry : *list->asArray()) {
        const auto show = std::find(names.begin(), names.end(), textOr(entry, "show", "final"));
        EXPECTS(show != names.end());
        result.push_back({textOr(entry, "name", ""), textOr(entry, "camera", ""), renderer::Show(show - names.begin()),
                          textOr(entry, "look", ""), numberOr(entry, "mean", 1), numberOr(entry, "outliers", 0.005)});
    }
    return result;
}

io::Image draw(const Golden& golden)
{
    renderer::FrameInput in{.camera = valley().camera(golden.camera), .size = {480, 270}, .show = golden.show};
    if (!golden.look.empty()) {
        const auto looks = enumNames(io::Preset{});
        const auto look = std::ranges::find(looks, golden.look);
        EXPECTS(look != looks.end());
        in.environment = io::withPreset(valley().document->scene().environment(), io::Preset(look - looks.begin()));
    }
    valley().renderer().render(in);
    return valley().renderer().readPicture();
}

void check(const Golden& golden, const io::Image& now)
{
    const fs::path file = kFolder / "pictures" / (golden.name + ".png");
    if (std::getenv("WOLD_GOLDEN_UPDATE")) {
        ASSERT_TRUE(io::writeImage(file, now));
        return;
    }
    const auto kept = io::readImage(file);
    ASSERT_TRUE(kept) << kept.error().text() << "; tests/golden/update draws it";
    ASSERT_EQ(kept->size, now.size);
    const Difference difference = compare(*kept, now);
    if (difference.mean <= golden.mean && difference.outliers <= golden.outliers) return;
    const fs::path seen = kOut / (golden.name + ".now.png"), off = kOut / (golden.name + ".difference.png");
    EXPECT_TRUE(io::writeImage(seen, now));
    EXPECT_TRUE(io::writeImage(off, difference.picture));
    ADD_FAILURE() << golden.name << ": mean " << difference.mean << " (at most " << golden.mean << "), outliers "
                  << difference.outliers << " (at most " << golden.outliers << "); see " << seen << " and " << off;
}

TEST(GoldenPictures, valleyLooksAsItDid)
{
    fs::create_directories(kOut);
    for (const Golden& golden : readList())
        check(golden, draw(golden));
    EXPECT_EQ(valley().renderer().glErrors(), 0u);
}

// A landscape as the editor makes them, under the valley's textures, from its foot to where it is small; by both vertex stages.
TEST(GoldenPictures, aMountainAtThreeDistances)
{
    fs::create_directories(kOut);
    const auto ground = editor::generateGround({.seed = 3, .width = 1025, .depth = 1025, .metresPerTexel = 4});
    ASSERT_TRUE(ground) << ground.error().text();
    const io::Scene& plain = valley().document->scene();
    const auto map = std::make_shared<const io::HeightMap>(*ground);
    io::Scene mountain;
    mountain.exchange(plain.environment());
    mountain.exchange(io::Terrain{.heightMap = "terrain/mountain.png",
                                  .metresPerTexel = map->metresPerTexel,
                                  .origin = map->origin,
                                  .layers = {{.name = "grass", .colour = {0.13f, 0.17f, 0.05f}},
                                             {.name = "scree", .colour = {0.32f, 0.3f, 0.27f}, .slope = {28, 90}},
                                             {.name = "rock", .colour = {0.23f, 0.22f, 0.21f}, .slope = {36, 90}},
                                             {.name = "snow", .colour = {0.75f, 0.77f, 0.8f}, .roughness = 0.7f, .slope = {0, 46}, .altitude = {560, 1e5f}},
                                             {.name = "gravel", .colour = {0.42f, 0.4f, 0.36f}, .slope = {0, 30}, .flow = {0.72f, 1}}}});
    mountain.exchange(map);
    renderer::Renderer& renderer = valley().renderer();
    renderer.update(mountain, {}, {.everything = true});
    glm::ivec2 summit{0};
    for (int z = 200; z < 500; ++z)
        for (int x = 200; x < 800; ++x)
            if (map->at(x, z) > map->at(summit.x, summit.y)) summit = {x, z};
    const glm::dvec3 top{map->origin.x + summit.x * 4.0, map->at(summit.x, summit.y), map->origin.y + summit.y * 4.0};
    for (const auto& [name, away, above] : {std::tuple{"mountain-near", 300.0, 40.0}, {"mountain", 1000.0, 90.0}, {"mountain-far", 2400.0, 420.0}}) {
        io::Camera camera{.eye = top + glm::normalize(glm::dvec3{0.2, 0, 1}) * away, .yaw = float(glm::degrees(std::atan2(0.2, 1.0))), .fov = 50};
        camera.eye.y = map->height(camera.eye.x, camera.eye.z).value_or(0) + above;
        camera.pitch = float(glm::degrees(std::atan2(top.y - camera.eye.y, away))) - 4;
        for (const auto stages : {renderer::GroundStages::Grid, renderer::GroundStages::Tessellation}) {
            renderer::FrameInput in{.camera = camera, .size = {480, 270}};
            in.settings.terrain = stages;
            renderer.render(in);
            check({.name = name}, renderer.readPicture());
        }
    }
    EXPECT_EQ(renderer.glErrors(), 0u);
    renderer.update(plain, valley().document->assets(), {.everything = true});
}

} // namespace
} // namespace test
