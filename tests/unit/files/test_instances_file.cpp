#include "support.h"

#include "io/base/random.h"
#include "io/files/instances_file.h"
#include "io/files/project.h"

#include <chrono>
#include <cmath>
#include <cstring>

namespace io {
namespace {

InstanceTiles someInstances(std::size_t count, double extent, std::uint64_t seed = 3)
{
    Random random{seed};
    std::map<glm::ivec2, InstanceTile, TileOrder> tiles;
    for (std::size_t i = 0; i < count; ++i) {
        Transform transform{.rotation = {0, random.range(0, 360), random.range(-5, 5)}, .scale = glm::vec3{random.range(0.5f, 2)}};
        transform.position = {random.signedUnit() * extent, random.range(0, 300), random.signedUnit() * extent};
        const PlacedInstance placed = instanceAt(transform, random.below(2), i % 7 == 0 ? kPaintedInstance : std::uint8_t(0));
        tiles[placed.tile].instances.push_back(placed.instance);
    }
    InstanceTiles shared;
    for (auto& [place, tile] : tiles) {
        if (place.x % 3 == 0) markErased(tile, glm::ivec2{5, 60});
        shared[place] = std::make_shared<const InstanceTile>(std::move(tile));
    }
    return shared;
}

// As it was signed before, so that what is wrong inside is reached.
std::string signedAnew(std::string bytes)
{
    if (bytes.size() < 16) return bytes;
    std::uint32_t crc = ~0u;
    for (std::size_t i = 16; i < bytes.size(); ++i) {
        crc ^= std::uint8_t(bytes[i]);
        for (int bit = 0; bit < 8; ++bit)
            crc = crc >> 1 ^ (crc & 1 ? 0xedb88320u : 0);
    }
    crc = ~crc;
    std::memcpy(&bytes[12], &crc, 4);
    return bytes;
}

template <class T> std::string changed(std::string bytes, std::size_t at, T value)
{
    std::memcpy(&bytes[at], &value, sizeof value);
    return signedAnew(std::move(bytes));
}

TEST(InstancesFile, GivesBackWhatWasWritten)
{
    const InstanceTiles tiles = someInstances(5000, 400);
    const std::string bytes = encodeInstances(tiles);
    const Result<ReadInstances> read = decodeInstances(bytes, 2);
    ASSERT_TRUE(read) << read.error().what;
    EXPECT_TRUE(sameInstances(read->tiles, tiles));
    EXPECT_EQ(encodeInstances(read->tiles), bytes);
    EXPECT_EQ(encodeInstances(decodeInstances(encodeInstances({}), 0)->tiles), encodeInstances({}));
}

TEST(InstancesFile, LiesAsItIsDocumented)
{
    InstanceTile tile;
    tile.instances.push_back({.x = 0x0102, .z = 0x0304, .y = -2, .rotation = {1, 2, -3}, .species = 9, .flags = 1, .scale = 1.5f});
    markErased(tile, glm::ivec2{1, 0});
    const std::string bytes = encodeInstances({{{-1, 2}, std::make_shared<const InstanceTile>(tile)}});
    ASSERT_EQ(bytes.size(), 24u + 16 + 20 + 512);
    const std::string tail{"\1\0\0\0\1\0\0\0"              // tiles, instances
                           "\xff\xff\xff\xff\2\0\0\0"       // x, z
                           "\1\0\0\0\1\0\0\0"               // instances, parts
                           "\2\1\4\3\xfe\xff\xff\xff\1\0\2\0\xfd\xff\x9\1\0\0\xc0\x3f"
                           "\2\0\0\0\0\0\0\0", 24 + 20 + 8};
    EXPECT_EQ(bytes.substr(16, tail.size()), tail);
    EXPECT_EQ(bytes.substr(0, 12), (std::string{"WOLDINST\1\0\0\0", 12}));
    EXPECT_EQ(signedAnew(bytes), bytes);
}

TEST(InstancesFile, AMillionFitInThirtyMegabytes)
{
    const InstanceTiles tiles = someInstances(1'000'000, 2500);
    const auto clock = std::chrono::steady_clock::now();
    const std::string bytes = encodeInstances(tiles);
    const auto written = std::chrono::steady_clock::now();
    const Result<ReadInstances> read = decodeInstances(bytes, 2);
    const auto end = std::chrono::steady_clock::now();
    ASSERT_TRUE(read);
    EXPECT_LE(bytes.size(), 30u * 1000 * 1000);
    const auto ms = [](auto span) { return int(std::chrono::duration_cast<std::chrono::milliseconds>(span).count()); };
    RecordProperty("bytes", int(bytes.size()));
    std::printf("a million instances: %zu bytes, encoded in %d ms, decoded in %d ms\n", bytes.size(), ms(written - clock), ms(end - written));
}

TEST(InstancesFile, SaysWhatIsWrongWithIt)
{
    const std::string good = encodeInstances({{{0, 0}, std::make_shared<const InstanceTile>(InstanceTile{.instances = {{}, {.species = 1}}})},
                                              {{1, 0}, std::make_shared<const InstanceTile>(InstanceTile{.instances = {{}}})}});
    constexpr std::size_t kTiles = 16, kCount = 20, kFirst = 24, kScale = kFirst + 16 + 16, kSecond = kFirst + 16 + 40;
    const auto fault = [](const std::string& bytes) {
        const Result<ReadInstances> read = decodeInstances(bytes, 2);
        return read ? std::string{"nothing"} : read.error().what;
    };
    const auto expect = [&](const std::string& bytes, const char* words) { EXPECT_NE(fault(bytes).find(words), std::string::npos) << fault(bytes); };
    EXPECT_EQ(fault(good), "nothing");
    expect("", "no file of instances");
    expect("WOLDINSX" + good.substr(8), "no file of instances");
    std::string newer = good;
    newer[8] = 2;
    expect(newer, "version 2");
    for (std::size_t size = 0; size < good.size(); ++size) {
        EXPECT_NE(fault(good.substr(0, size)), "nothing");
        EXPECT_NE(fault(signedAnew(good.substr(0, size))), "nothing");
    }
    std::string flipped = good;
    flipped[40] ^= 4;
    expect(flipped, "bytes are not those");
    expect(changed(good, kTiles, 0xffffffffu), "ends too early");
    expect(changed(good, kTiles, 1u), "more in it");
    expect(changed(good, kCount, 4u), "as many instances");
    expect(changed(good, kFirst + 8, 0xffffffffu), "ends too early");
    expect(changed(good, kFirst + 12, 2u), "parts");
    expect(changed(good, kFirst, 200'000), "outside of the world");
    expect(changed(good, kFirst, std::numeric_limits<int>::min()), "outside of the world");
    expect(changed(good, kSecond, 0), "out of order");
    for (const float scale : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(), -1.0f, 0.0f, 1e20f})
        expect(changed(good, kScale, scale), "scale");
    const Result<ReadInstances> fewer = decodeInstances(good, 1);
    ASSERT_TRUE(fewer);
    EXPECT_EQ(fewer->strangers, 1u);
    EXPECT_EQ(instanceCount(fewer->tiles), 2u);
}

TEST(InstancesFile, DamagedCopiesAreReadOrRefusedButNeverBreakAnything)
{
    const std::string good = encodeInstances(someInstances(60, 100));
    Random random{11};
    int taken = 0;
    for (int round = 0; round < 20'000; ++round) {
        std::string bytes = good;
        for (int i = random.below(4); i >= 0; --i)
            switch (random.below(4)) {
            case 0: bytes[std::size_t(random.below(int(bytes.size())))] = char(random.next()); break;
            case 1: bytes.resize(std::size_t(random.below(int(bytes.size())) + 1)); break;
            case 2: bytes.insert(std::size_t(random.below(int(bytes.size()))), std::size_t(random.below(40)), char(random.next())); break;
            default: bytes.erase(std::size_t(random.below(int(bytes.size()))), std::size_t(random.below(40))); bytes += 'x';
            }
        const Result<ReadInstances> read = decodeInstances(signedAnew(std::move(bytes)), 2);
        if (!read) continue;
        ++taken;
        for (const auto& [place, tile] : read->tiles)
            for (const Instance& instance : tile->instances) {
                const Transform transform = transformOf(place, instance);
                ASSERT_TRUE(std::isfinite(transform.position.x + transform.position.y + transform.position.z) && std::isfinite(transform.scale.x) && instance.species < 2);
            }
    }
    EXPECT_GT(taken, 500);
}

// A project with one scene, two templates and a layer of both.
struct Planted {
    TemporaryFolder folder;
    World world;
    Planted()
    {
        world.project = {.folder = folder.path(), .name = "sample", .scenes = {{"main", "scenes/main.scene.json"}}, .start = "main"};
        world.entry = world.project.scenes[0];
        for (const char* name : {"fir", "birch"})
            world.scene.exchange(world.scene.templateSlot(name), Template{});
        const ScatterId id = world.scene.freshScatterId();
        world.scene.exchange({ScatterLayer{.id = id, .name = "wood", .species = {{.templateName = "fir"}, {.templateName = "birch"}}}});
        world.scene.exchange(id, someInstances(3000, 500));
        EXPECT_TRUE(saveWorld(world));
    }
    fs::path file() const { return folder / "scenes/main.1.scatter"; }
};

struct Read {
    Complaints complaints;
    World world;
    explicit Read(const fs::path& folder)
    {
        Result<World> opened = openWorld(folder, {}, complaints);
        EXPECT_TRUE(opened);
        world = std::move(*opened);
        EXPECT_TRUE(readAssets(world, complaints));
    }
};

TEST(InstancesOfAProject, AreSavedBesideTheirSceneAndReadBack)
{
    Planted planted;
    EXPECT_EQ(get(planted.folder / "scenes/main.scene.json").find("instances"), std::string::npos);
    Read read{planted.folder.path()};
    EXPECT_EQ(listed(read.complaints), "");
    EXPECT_TRUE(sameContent(read.world.scene, planted.world.scene));
    const auto again = saveWorld(read.world);
    ASSERT_TRUE(again);
    EXPECT_TRUE(again->written.empty());
}

TEST(InstancesOfAProject, OneThatChangedIsWrittenAlone)
{
    Planted planted;
    Read read{planted.folder.path()};
    const LayerTile tile{ScatterId{1}, read.world.scene.instances(ScatterId{1}).begin()->first};
    read.world.scene.exchange(tile, nullptr);
    const auto saved = saveWorld(read.world);
    ASSERT_TRUE(saved);
    EXPECT_EQ(saved->written, (std::vector<fs::path>{"scenes/main.1.scatter"}));
    Read again{planted.folder.path()};
    EXPECT_TRUE(sameContent(again.world.scene, read.world.scene));
}

TEST(InstancesOfAProject, TheirFileGoesWithTheirLayer)
{
    Planted planted;
    planted.world.scene.exchange(std::vector<ScatterLayer>{});
    ASSERT_TRUE(saveWorld(planted.world));
    EXPECT_FALSE(fs::exists(planted.file()));
    EXPECT_EQ(get(planted.folder / "scenes/main.scene.json").find("scatter"), std::string::npos);
    Read read{planted.folder.path()};
    EXPECT_EQ(listed(read.complaints), "");
}

TEST(InstancesOfAProject, AWorldWhoseFilesWereNotReadLeavesThemAlone)
{
    Planted planted;
    const std::string before = get(planted.file());
    Complaints complaints;
    Result<World> opened = openWorld(planted.folder.path(), {}, complaints);
    ASSERT_TRUE(opened);
    ASSERT_TRUE(saveWorld(*opened));
    EXPECT_EQ(get(planted.file()), before);
}

TEST(InstancesOfAProject, ABrokenFileIsNamedAndKept)
{
    Planted planted;
    const std::string damaged = get(planted.file()).substr(0, 1000);
    put(planted.file(), damaged);
    Read read{planted.folder.path()};
    EXPECT_EQ(errorsIn(read.complaints), 1);
    EXPECT_NE(listed(read.complaints).find("main.1.scatter: its bytes are not those"), std::string::npos) << listed(read.complaints);
    EXPECT_EQ(read.world.scene.instanceCount(), 0u);
    ASSERT_TRUE(saveWorld(read.world));
    EXPECT_EQ(get(planted.file()), damaged);
    read.world.scene.exchange(ScatterId{1}, someInstances(10, 10));
    ASSERT_TRUE(saveWorld(read.world));
    EXPECT_EQ(get(planted.file().string() + ".bad"), damaged);
    EXPECT_EQ(Read{planted.folder.path()}.world.scene.instanceCount(), 10u);
}

TEST(InstancesOfAProject, WhatIsMissingIsNamed)
{
    Planted planted;
    fs::remove(planted.file());
    const Complaints gone = checkProject(planted.folder.path());
    EXPECT_EQ(errorsIn(gone), 1);
    EXPECT_NE(listed(gone).find("main.1.scatter"), std::string::npos) << listed(gone);

    Planted other;
    std::string scene = get(other.folder / "scenes/main.scene.json");
    scene.replace(scene.find("\"birch\""), 7, "\"beech\"");
    put(other.folder / "scenes/main.scene.json", scene);
    const Complaints strange = checkProject(other.folder.path());
    EXPECT_EQ(errorsIn(strange), 1);
    EXPECT_NE(listed(strange).find("\"beech\" is no template"), std::string::npos) << listed(strange);
}

TEST(InstancesOfAProject, LayersThatCannotBeToldApartAreMended)
{
    Planted planted;
    std::string scene = get(planted.folder / "scenes/main.scene.json");
    const std::string twice = R"({"id":1,"name":"wood","future":[1]},{"name":""},)";
    scene.insert(scene.find('{', scene.find("\"scatter\"")), twice);
    put(planted.folder / "scenes/main.scene.json", scene);
    Read read{planted.folder.path()};
    EXPECT_NE(listed(read.complaints).find("scatter.2.id: 1 is taken by a layer above"), std::string::npos) << listed(read.complaints);
    EXPECT_NE(listed(read.complaints).find("scatter.1.id: missing"), std::string::npos) << listed(read.complaints);
    ASSERT_EQ(read.world.scene.scatterLayers().size(), 3u);
    ASSERT_TRUE(saveWorld(read.world));
    EXPECT_NE(get(planted.folder / "scenes/main.scene.json").find("\"future\": [1]"), std::string::npos);
}

} // namespace
} // namespace io
