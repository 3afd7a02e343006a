// Readers of foreign bytes, fed with damaged copies of good files. The damage comes from a fixed seed, so that a
// failure comes again; WOLD_FUZZ_ROUNDS multiplies the work for a long run, also under the sanitizers.
#include "tests/unit/files/model_checks.h"
#include "tests/unit/files/support.h"

#include "io/files/card_trimming.h"
#include "io/files/documents.h"
#include "io/files/geo_tiff.h"
#include "io/files/height_import.h"
#include "io/files/height_map_file.h"
#include "io/files/image_bytes.h"
#include "io/files/image_file.h"
#include "io/files/png_file.h"
#include "io/files/json.h"
#include "io/files/levels.h"
#include "io/files/model_file.h"
#include "io/files/scene_file.h"

#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <random>

#ifdef __SANITIZE_ADDRESS__
// OpenImageIO keeps the errors of a thread for ever.
extern "C" const char* __lsan_default_suppressions()
{
    return "leak:libOpenImageIO";
}
#endif

namespace io {
namespace {

int rounds(int usual)
{
    const char* more = std::getenv("WOLD_FUZZ_ROUNDS");
    return more ? usual * std::atoi(more) : usual;
}

// Damages text and bytes in the ways that disks, editors and merges do, and that attackers do.
class Mutator {
public:
    std::string damaged(std::string bytes)
    {
        for (int i = 0; i < pick({1, 1, 1, 2, 4, 16}); ++i)
            damage(bytes);
        return bytes;
    }

private:
    template <class T> T pick(std::initializer_list<T> choices) { return *(choices.begin() + below(choices.size())); }
    std::size_t below(std::size_t limit) { return limit == 0 ? 0 : m_random() % limit; }

    void damage(std::string& bytes)
    {
        const std::size_t at = below(bytes.size());
        const std::size_t length = std::min(below(64) + 1, bytes.size() - at);
        switch (below(8)) {
        case 0:
            return void(bytes.empty() || (bytes[at] ^= char(1 << below(8))));
        case 1:
            return void(bytes.empty() || (bytes[at] = char(below(256))));
        case 2:
            return void(bytes.erase(at, length));
        case 3:
            return void(bytes.insert(at, bytes.substr(below(bytes.size()), length)));
        case 4:
            return void(bytes.resize(at));
        case 5:
            return void(bytes.insert(
                at, pick<const char*>({"{", "}", "[", "]", ",", ":", "\"", "\\", "\n", "null", "-", "1e999", "\xFF"})));
        case 6:
            return changeNumber(bytes, at);
        default:
            return changeWord(bytes, at);
        }
    }
    void changeNumber(std::string& bytes, std::size_t from)
    {
        const std::size_t start = bytes.find_first_of("0123456789", from);
        if (start == std::string::npos) return;
        const std::size_t end = std::min(bytes.find_first_not_of("0123456789", start), bytes.size());
        bytes.replace(
            start, end - start,
            pick<const char*>({"0", "-1", "1", "255", "65535", "65536", "2147483647", "2147483648", "4294967296",
                               "9007199254740993", "1e308", "-1e-320", "0.5", "true", "\"x\""}));
    }
    void changeWord(std::string& bytes, std::size_t at) // 32 bits of a binary file
    {
        if (bytes.size() < 4) return;
        const std::uint32_t word = pick<std::uint32_t>(
            {0, 1, 0x7FFFFFFF, 0x80000000, 0xFFFFFFFF, 0x7F800000, 0x7FC00000, std::uint32_t(m_random())});
        std::memcpy(bytes.data() + std::min(at, bytes.size() - 4) / 4 * 4, &word, 4);
    }

    std::mt19937 m_random{20240611};
};

Scene someScene()
{
    Scene scene;
    for (const char* name : {"oak", "rock"})
        scene.exchange(scene.templateSlot(name), Template{});
    for (std::uint32_t id = 1; id <= 6; ++id) {
        Object object;
        object.templateId = TemplateId{id % 3};
        object.transform.position = {id * 0.1, -1.5, 1e3};
        object.transform.rotation = {0, float(id) * 33.3f, 0};
        object.parent = ObjectId{id > 3 ? 3u : 0u};
        if (id == 2) object.extra.add("age", "[1,{\"b\":null}]");
        scene.exchange(ObjectId{id}, object);
    }
    Terrain terrain{.heightMap = "terrain/h.png"};
    terrain.layers.resize(2);
    scene.exchange(terrain);
    return scene;
}

Scene emptyWithTemplates()
{
    Scene scene;
    for (const char* name : {"oak", "rock"})
        scene.exchange(scene.templateSlot(name), Template{});
    return scene;
}

// What a reader takes, it can write, and reads again as the same.
TEST(Fuzz, Scenes)
{
    const std::string good = sceneText(someScene(), "environments/day.json");
    Mutator mutator;
    int taken = 0;
    for (int i = 0; i < rounds(15'000); ++i) {
        const std::string text = mutator.damaged(good);
        SCOPED_TRACE(text);
        Scene scene = emptyWithTemplates();
        Complaints complaints;
        const Result<std::string> environment = readSceneText(text, "s.json", scene, complaints);
        if (!environment) continue;
        ++taken;
        const std::string once = sceneText(scene, *environment);
        Scene again = emptyWithTemplates();
        const Result<std::string> second = readSceneText(once, "s.json", again, complaints);
        ASSERT_TRUE(second) << second.error().text() << once;
        ASSERT_EQ(sceneText(again, *second), once);
    }
    EXPECT_GT(taken, 100);
}

template <class Read, class Write> void fuzzDocument(const std::string& good, int count, Read read, Write write)
{
    Mutator mutator;
    for (int i = 0; i < rounds(count); ++i) {
        const std::string text = mutator.damaged(good);
        SCOPED_TRACE(text);
        Complaints complaints;
        const auto first = read(text, "d.json", complaints);
        if (!first) continue;
        const std::string once = write(*first);
        const auto second = read(once, "d.json", complaints);
        ASSERT_TRUE(second) << second.error().text() << once;
        ASSERT_EQ(write(*second), once);
    }
}

TEST(Fuzz, Environments)
{
    Environment environment;
    environment.extra.add("sun.corona", "{\"a\":[1,2]}");
    fuzzDocument(environmentText(environment), 8000, readEnvironmentText, environmentText);
}

TEST(Fuzz, Projects)
{
    ProjectBody project{
        .name = "p", .start = "a", .scenes = {{"a", "scenes/a.scene.json"}}, .templates = {"oak", "fir"}};
    project.cameras.resize(2);
    project.paths = {{.name = "tour", .keys = {{.time = 0}, {.time = 1}}}};
    project.extra.add("paths.0.keys.1.ease", "\"in\"");
    fuzzDocument(projectText(project), 8000, readProjectText, projectText);
}

TEST(Fuzz, Templates)
{
    fuzzDocument(templateText(Template{.category = "Trees", .model = "models/oak.glb"}), 8000, readTemplateText,
                 templateText);
}

TEST(Fuzz, Json)
{
    const std::string good = R"({"a":[1,-2.5e3,"x\u00e9\n\\",true,null,{"b":{}}],"c":[[[]]],"d":"名前"})";
    Mutator mutator;
    for (int i = 0; i < rounds(30'000); ++i) {
        const Result<Value> value = parseJson(mutator.damaged(good), "j");
        if (!value) continue;
        const Result<Value> again = parseJson(writeJson(*value), "j");
        ASSERT_TRUE(again);
        ASSERT_EQ(*again, *value);
    }
}

class ModelFuzz : public testing::Test {
protected:
    void read(const std::string& bytes, const char* name)
    {
        Complaints complaints;
        Result<Model> model = readModelBytes(bytes, m_folder / name, m_folder.path(), complaints);
        m_taken += bool(model);
        if (!model) return;
        expectSound(*model, "damaged");
        makeLevels(*model);
        trimCards(*model);
        expectSound(*model, "damaged, trimmed");
    }
    TemporaryFolder m_folder;
    int m_taken = 0;
};

std::string goodGlb()
{
    Model model = boxModel({1, 2, 3}, {1, 1, 1, 1});
    Material second{.name = "second", .alphaMode = AlphaMode::Mask};
    auto image = std::make_shared<Image>();
    image->size = {4, 4};
    image->bytes.resize(64);
    for (const std::size_t texel : {5u, 6u, 9u}) // alpha
        image->bytes[texel * 4 + 3] = std::byte{255};
    model.images = {image};
    second.baseColourTexture = {.image = 0, .scale = {0.9f, 0.9f}};
    second.normalTexture = {.image = 0};
    model.materials.push_back(second);
    model.parts = {{0, 18, 0}, {18, 18, 1}};
    model.vertices[0].colour = {1, 2, 3, 4};
    return *encodeGlb(model);
}

TEST_F(ModelFuzz, Glb)
{
    const std::string good = goodGlb();
    Mutator mutator;
    for (int i = 0; i < rounds(6000); ++i)
        read(mutator.damaged(good), "m.glb");
    EXPECT_GT(m_taken, 100);
}

// As text, where more of the damage gets past the first look: nodes, instances, a strip, data in a URI.
TEST_F(ModelFuzz, Gltf)
{
    const std::string good =
        R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0,2]}],"extensionsUsed":["EXT_mesh_gpu_instancing"],)"
        R"("nodes":[{"children":[1],"translation":[1,2,3],"rotation":[0,0,0,1],"scale":[1,-1,1]},{"mesh":0},)"
        R"({"mesh":0,"extensions":{"EXT_mesh_gpu_instancing":{"attributes":{"TRANSLATION":0}}},"matrix":[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1]}],)"
        R"("meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1,"material":0},{"attributes":{"POSITION":0,"TEXCOORD_0":2},"mode":5}]}],)"
        R"("materials":[{"alphaMode":"MASK","pbrMetallicRoughness":{"baseColorFactor":[1,1,1,1],"baseColorTexture":{"index":0,"extensions":{"KHR_texture_transform":{"offset":[0,1],"rotation":1}}}}}],)"
        R"("textures":[{"source":0,"sampler":0}],"samplers":[{"wrapS":33071}],"images":[{"bufferView":0,"mimeType":"image/png"}],)"
        R"("buffers":[{"uri":"data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAAAAABAAIAAAA=","byteLength":44}],)"
        R"("bufferViews":[{"buffer":0,"byteOffset":0,"byteLength":36},{"buffer":0,"byteOffset":36,"byteLength":6}],)"
        R"("accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3","sparse":{"count":1,"indices":{"bufferView":1,"componentType":5123},"values":{"bufferView":0}}},)"
        R"({"bufferView":1,"componentType":5123,"count":3,"type":"SCALAR"},{"bufferView":0,"componentType":5126,"count":3,"type":"VEC2"}]})";
    read(good, "good.gltf");
    ASSERT_EQ(m_taken, 1);
    Mutator mutator;
    for (int i = 0; i < rounds(10'000); ++i)
        read(mutator.damaged(good), "m.gltf");
    EXPECT_GT(m_taken, 100);
}

// Our own walks over image bytes; the decoders behind them are not ours to fuzz here.
TEST(Fuzz, ImageBytes)
{
    Image image{.size = {3, 3}, .channels = 3, .bytes = std::vector<std::byte>(27)};
    const TemporaryFolder folder;
    ASSERT_TRUE(writeImage(folder / "a.jpg", image));
    std::string dds(128, '\1');
    dds.replace(0, 4, "DDS ");
    Mutator mutator;
    for (const std::string& good : {*encodePng(image), get(folder / "a.jpg"), dds}) {
        for (int i = 0; i < rounds(10'000); ++i) {
            const std::string bytes = mutator.damaged(good);
            ASSERT_LE(withoutMetadata(bytes).size(), bytes.size());
            (void)headerFault(bytes);
        }
    }
}

// Bare samples, their headers, SRTM tiles and the tags of GeoTIFFs: damaged, they are read or refused.
TEST(Fuzz, HeightMaps)
{
    const TemporaryFolder folder;
    const std::string header = rawHeaderText({9, 7}, HeightSample::I16, 2.5, {1, -2}, glm::dvec2{-3, 40});
    std::string raw(9 * 7 * 2, '\3'), tile;
    for (int i = 0; i < 1201 * 1201; ++i)
        tile += std::string{i % 1000 == 0 ? "\x80\x00" : "\x02\x10", 2};
    Mutator mutator;
    int taken = 0;
    for (int i = 0; i < rounds(3000); ++i) {
        put(folder / "a.hdr", mutator.damaged(header));
        put(folder / "a.raw", i % 3 == 0 ? mutator.damaged(raw) : raw);
        Complaints complaints;
        const RawLayout layout{.size = i % 5 == 0 ? std::optional{glm::ivec2{i % 40 - 2, i % 17}} : std::nullopt};
        const Result<HeightSource> source = readHeightSource(folder / "a.raw", layout, complaints);
        if (!source) continue;
        const Result<ImportedGround> ground = groundFrom(*source, {}, Scene{}, complaints);
        if (!ground) continue;
        ++taken;
        for (const float metres : ground->grid.metres)
            ASSERT_TRUE(std::isfinite(metres));
    }
    EXPECT_GT(taken, 100);
    for (int i = 0; i < rounds(15); ++i) {
        put(folder / "N10E010.hgt", mutator.damaged(tile));
        Complaints complaints;
        (void)readHeightSource(folder / "N10E010.hgt", {}, complaints);
    }
}

TEST(Fuzz, GeoTiffs)
{
    // Little endian: a directory with a pixel scale, a tie point, keys and a mark of voids, and what they name behind it.
    std::string tiff{"II*\0\x08\0\0\0", 8};
    const auto add = [&tiff](std::uint64_t value, int bytes) {
        for (int i = 0; i < bytes; ++i)
            tiff += char(value >> (8 * i));
    };
    add(4, 2);
    for (const auto& [tag, type, count, at] : {std::array{33550u, 12u, 3u, 64u}, {33922u, 12u, 6u, 88u}, {34735u, 3u, 8u, 136u}, {42113u, 2u, 4u, 0x392du}})
        add(tag, 2), add(type, 2), add(count, 4), add(at, 4);
    tiff.resize(64);
    for (const double value : {0.001, 0.001, 0.0, 0.0, 0.0, 0.0, 8.0, 47.0, 0.0})
        add(std::bit_cast<std::uint64_t>(value), 8);
    for (const unsigned key : {1u, 1u, 0u, 1u, 1024u, 0u, 1u, 2u})
        add(key, 2);
    ASSERT_NEAR(geoTiffOf(tiff).metresPerTexel.value_or(0), 92, 2);
    ASSERT_EQ(geoTiffOf(tiff).nodata, -9);
    Mutator mutator;
    for (int i = 0; i < rounds(30'000); ++i) {
        const GeoTiff geo = geoTiffOf(mutator.damaged(tiff));
        const double metres = geo.metresPerTexel.value_or(1);
        ASSERT_TRUE(std::isfinite(metres) && metres > 0);
    }
}

// What reads heights in bands refuses what the decoder of whole pictures refuses, and nothing else.
TEST(Fuzz, HeightMapsInBands)
{
    Image image{.size = {40, 30}, .channels = 1, .type = PixelType::U16};
    for (int i = 0; i < 40 * 30 * 2; ++i)
        image.bytes.push_back(std::byte(i * i / 7));
    const std::string good = *encodePng(image);
    const TemporaryFolder folder;
    Mutator mutator;
    for (int i = 0; i < rounds(2000); ++i) {
        put(folder / "h.png", mutator.damaged(good));
        Complaints complaints;
        const Result<Image> whole = readImage(folder / "h.png");
        const Result<HeightMap> map = readHeightMap(folder / "h.png", {.maxHeight = 100}, complaints);
        ASSERT_EQ(bool(map), whole && whole->size.x > 1 && whole->size.y > 1) << i << " " << (map ? "" : map.error().what);
        if (map) {
            EXPECT_EQ(map->size, whole->size);
        }
    }
}

} // namespace
} // namespace io
