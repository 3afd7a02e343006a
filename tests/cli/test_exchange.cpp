// wold import and wold export, from outside.
#include "tests/cli/wold.h"

#include "io/files/atomic_file.h"
#include "io/files/height_map_file.h"
#include "io/files/image_file.h"
#include "io/files/model_file.h"
#include "io/files/project.h"

#include <algorithm>
#include <fstream>

namespace test {
namespace {

namespace fs = std::filesystem;

struct Exchange : SmallWorld {
    std::string heightMap(const char* name, int side, double low = 0, double high = 12)
    {
        io::HeightGrid grid{.size = {side, side}};
        for (int i = 0; i < side * side; ++i)
            grid.metres.push_back(float(i % side) * 0.1f);
        EXPECT_TRUE(io::writeHeightMap16(folder.path() / name, grid, low, high));
        return folder / name;
    }
    std::string scene() const { return textOf(project + "/scenes/main.scene.json"); }
};

TEST_F(Exchange, aHeightMapOfTheSameMeasuresTakesItsPlace)
{
    const Ran ran = wold({"import", project, heightMap("new.png", 65), "--quiet", "--json", "-"});
    ASSERT_EQ(ran.code, 0) << ran.err;
    const io::Value done = (*json(ran.out).find("imported")->asArray())[0];
    EXPECT_EQ(text(done, "height_map"), "terrain/new.png");
    EXPECT_EQ(number(done, "metres_per_texel"), 1);
    EXPECT_NE(scene().find("terrain/new.png"), std::string::npos);
    EXPECT_EQ(wold({"check", project}).code, 0);
    const Ran out = wold({"export", project, "--out", folder / "out.png"});
    EXPECT_EQ(out.code, 0) << out.err;
    EXPECT_NE(out.out.find("16 bits from 0 to 12 m"), std::string::npos) << out.out;
    EXPECT_EQ(io::readImage(folder / "out.png")->bytes, io::readImage(folder / "new.png")->bytes);
}

TEST_F(Exchange, aHeightMapOfOtherMeasuresNeedsForce)
{
    const std::string before = scene(), file = heightMap("new.png", 33);
    const Ran refused = wold({"import", project, file, "--metres-per-texel", "2", "--heights", "-5,40"});
    expectFault(refused, "new.png");
    EXPECT_NE(refused.lastError().find("33 x 33 texels, not 65 x 65; 2 m a texel, not 1; heights -5 … 40 m, not 0 … 12 m"), std::string::npos) << refused.err;
    EXPECT_NE(refused.lastError().find("--force"), std::string::npos);
    EXPECT_EQ(scene(), before);
    EXPECT_FALSE(fs::exists(project + "/terrain/new.png"));
    const Ran done = wold({"import", project, file, "--metres-per-texel", "2", "--heights", "-5,40", "--force"});
    ASSERT_EQ(done.code, 0) << done.err;
    EXPECT_NE(done.out.find("in place of the ground that was there"), std::string::npos) << done.out;
    EXPECT_NE(scene().find("\"metres_per_texel\": 2"), std::string::npos) << scene();
    EXPECT_EQ(wold({"check", project}).code, 0);
}

TEST_F(Exchange, bareSamplesAreToldTheirSize)
{
    const std::string raw = folder.write("g.raw", std::string(65 * 33 * 2, '\1'));
    expectFault(wold({"import", project, raw}), "g.raw");
    expectFault(wold({"import", project, raw, "--size", "64x33"}), "4290 bytes are not 64 x 33");
    const Ran done = wold({"import", project, raw, "--size", "65x33", "--sample", "u16", "--big-endian", "--heights", "0,12", "--force", "--quiet", "--json", "-"});
    ASSERT_EQ(done.code, 0) << done.err;
    EXPECT_EQ(done.err, "");
}

TEST_F(Exchange, badWordsAreMisuse)
{
    const std::string file = heightMap("new.png", 65);
    expectMisuse(wold({"import", project}), "FILE");
    expectMisuse(wold({"import", project, file, "--metres-per-texel", "0"}), "--metres-per-texel 0");
    expectMisuse(wold({"import", project, file, "--metres-per-texel", "-4"}), "--metres-per-texel -4");
    expectMisuse(wold({"import", project, file, "--heights", "9"}), "LOW,HIGH");
    expectMisuse(wold({"import", project, file, "--heights", "9,3"}), "LOW,HIGH");
    expectMisuse(wold({"import", project, file, "--size", "12"}), "WIDTHxHEIGHT");
    expectMisuse(wold({"import", project, file, "--sample", "u17"}), "u8 u16 i16 f32");
    expectMisuse(wold({"import", project, file, "--as", "song"}), "heights model texture sound");
    expectMisuse(wold({"export", project, "--out", folder / "a.doc"}), ".png");
    expectMisuse(wold({"export", project, "--out", folder / "a.png", "--step", "2"}), "--step");
    expectMisuse(wold({"export", project, "--out", folder / "a.glb", "--only", "trees"}), "terrain");
}

TEST_F(Exchange, everyFormatComesBack)
{
    const auto original = io::readImage(project + "/terrain/ground.png");
    for (const char* name : {"a.png", "a.r16", "a.exr", "a.tif", "a.r32"}) {
        const Ran out = wold({"export", project, "--out", folder / name, "--quiet"});
        ASSERT_EQ(out.code, 0) << name << out.err;
        const Ran in = wold({"import", project, folder / name, "--as", "heights", "--quiet"});
        ASSERT_EQ(in.code, 0) << name << in.err;
        const Ran again = wold({"export", project, "--out", folder / "again.r32", "--quiet"});
        const Ran first = wold({"export", project, "--out", folder / "first.r32", "--quiet"});
        EXPECT_EQ(textOf(folder / "again.r32"), textOf(folder / "first.r32"));
    }
    ASSERT_EQ(wold({"export", project, "--out", folder / "last.r16", "--quiet"}).code, 0);
    const std::string bytes = textOf(folder / "last.r16");
    std::vector<float> heights(original->bytes.size() / 2);
    for (std::size_t i = 0; i < heights.size(); ++i) { // the peak is 12 m, as 65535 was
        const auto level = std::uint16_t(std::uint8_t(bytes[2 * i]) | std::uint8_t(bytes[2 * i + 1]) << 8);
        EXPECT_LE(std::abs(int(level) - int(original->row<std::uint16_t>(0)[i])), 1);
    }
}

TEST_F(Exchange, theGroundAsAMesh)
{
    const Ran out = wold({"export", project, "--out", folder / "g.glb", "--only", "terrain", "--step", "2", "--quiet", "--json", "-"});
    ASSERT_EQ(out.code, 0) << out.err;
    EXPECT_EQ(number(json(out.out), "triangles"), 32 * 32 * 2);
    io::Complaints complaints;
    const auto model = io::readModel(folder / "g.glb", folder.path(), complaints);
    ASSERT_TRUE(model) << model.error().text();
    EXPECT_EQ(model->indices.size(), 32u * 32 * 6);
    EXPECT_TRUE(complaints.empty());
}

TEST_F(Exchange, theWholeWorldAsOneFile)
{
    const std::string sixth = R"({"do":"place","template":"crate","at":[20,3,10],"yaw":90,"scale":2})" "\n" R"({"do":"save"})" "\n";
    ASSERT_EQ(wold({"run", project, "-", "--quiet"}, sixth).code, 0);
    for (const char* name : {"w.glb", "w.gltf"}) {
        const Ran out = wold({"export", project, "--out", folder / name, "--quiet", "--json", "-"});
        ASSERT_EQ(out.code, 0) << out.err;
        const io::Value done = json(out.out);
        EXPECT_EQ(number(done, "models"), 1);
        EXPECT_EQ(number(done, "instances"), 6);
        EXPECT_EQ(number(done, "left_out"), 1); // the post
        io::Complaints complaints;
        const auto model = io::readModel(folder / name, folder.path(), complaints);
        ASSERT_TRUE(model) << model.error().text();
        EXPECT_TRUE(complaints.empty());
        EXPECT_EQ(model->indices.size(), (64u * 64 * 2 + 6 * 12) * 3);
        // Crates of 2 m stand at x = -8, -4, 0, 4 and 8, and one of 4 m at 20, 3, 10.
        const auto corner = [&](const glm::vec3& at) {
            return std::ranges::any_of(model->vertices, [&](const io::Vertex& v) { return glm::distance(v.position, at) < 1e-3f; });
        };
        for (const float x : {-9.f, -7.f, -1.f, 7.f, 9.f})
            EXPECT_TRUE(corner({x, -1, 1}) || corner({x, 0, 1})) << x;
        EXPECT_TRUE(corner({22, 5, 12}) || corner({22, 7, 12}));
    }
    const std::string once = textOf(folder / "w.glb");
    ASSERT_EQ(wold({"export", project, "--out", folder / "w.glb", "--quiet"}).code, 0);
    EXPECT_EQ(textOf(folder / "w.glb"), once);
}

TEST_F(Exchange, modelsPicturesAndSoundsFindTheirFolders)
{
    fs::copy_file(project + "/models/crate.glb", folder.path() / "box.glb");
    const io::Image picture{.size = {4, 4}, .channels = 3, .bytes = std::vector<std::byte>(48, std::byte{90})};
    ASSERT_TRUE(io::writeImage(folder / "moss.png", picture));
    const std::string sound = folder.write("wind.wav", std::string{"RIFF\x24\0\0\0WAVEfmt ", 16});
    const Ran ran = wold({"import", project, folder / "box.glb", folder / "moss.png", sound, "--quiet", "--json", "-"});
    ASSERT_EQ(ran.code, 0) << ran.err;
    for (const char* file : {"models/box.glb", "textures/moss.png", "sounds/wind.wav", "templates/box.json"})
        EXPECT_TRUE(fs::exists(project + "/" + file)) << file;
    const Ran placed = wold({"run", project, "-", "--quiet"}, "{\"do\":\"place\",\"template\":\"box\",\"at\":[1,0,1]}\n");
    EXPECT_EQ(placed.code, 0) << placed.out;
    EXPECT_EQ(wold({"check", project}).code, 0);
    // The same again adds nothing, another of that name gets a number.
    ASSERT_EQ(wold({"import", project, folder / "box.glb", "--quiet"}).code, 0);
    EXPECT_FALSE(fs::exists(project + "/models/box_2.glb"));
    ASSERT_TRUE(io::writeFile(folder / "box.glb", *io::encodeGlb(io::boxModel(glm::vec3{3}, {1, 0, 0, 1}))));
    ASSERT_EQ(wold({"import", project, folder / "box.glb", "--quiet"}).code, 0);
    EXPECT_TRUE(fs::exists(project + "/templates/box_2.json"));
}

TEST_F(Exchange, oneBadFileAmongManyImportsNone)
{
    const std::string before = scene();
    const std::string broken = folder.write("broken.glb", "glTF but no more");
    fs::copy_file(project + "/models/crate.glb", folder.path() / "box.glb");
    expectFault(wold({"import", project, folder / "box.glb", heightMap("new.png", 65), broken}), "broken.glb");
    expectFault(wold({"import", project, folder / "box.glb", folder.write("a.txt", "words")}), "a.txt");
    expectFault(wold({"import", project, folder.write("a.wav", "words")}), "a.wav");
    expectFault(wold({"import", project, folder / "new.png", heightMap("other.png", 65)}), "one height map at a time");
    EXPECT_EQ(scene(), before);
    EXPECT_FALSE(fs::exists(project + "/models/box.glb"));
    EXPECT_FALSE(fs::exists(project + "/terrain/new.png"));
}

} // namespace
} // namespace test
