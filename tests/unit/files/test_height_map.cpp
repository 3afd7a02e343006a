#include "support.h"

#include "io/files/height_map_file.h"
#include "io/files/image_file.h"

#include <cmath>

namespace io {
namespace {

const Terrain kAndes{.metresPerTexel = 90, .origin = {-100, -200}, .minHeight = 343, .maxHeight = 6084};

struct ReadMap {
    Complaints complaints;
    Result<HeightMap> map;
    explicit ReadMap(const fs::path& file, const Terrain& terrain = kAndes)
        : map{readHeightMap(file, terrain, complaints)}
    {
    }
};

TEST(HeightMapFile, MeasuredGroundHasItsMetres)
{
    NEEDS_TEST_DATA();
    const ReadMap read{testData() / "heightmaps/andes-aconcagua-1024-u16.png"};
    ASSERT_TRUE(read.map) << read.map.error().text();
    EXPECT_EQ(read.map->size, glm::ivec2(1024));
    EXPECT_NEAR(read.map->min, 343, 0.1);
    EXPECT_NEAR(read.map->max, 6084, 0.1);
    EXPECT_EQ(read.map->metresPerTexel, 90);
    EXPECT_TRUE(read.map->contains(-100, -200));
    EXPECT_TRUE(read.complaints.empty());
}

TEST(HeightMapFile, SignedTiffIsMetres)
{
    NEEDS_TEST_DATA();
    const ReadMap read{testData() / "heightmaps/S33W071.tif"};
    ASSERT_TRUE(read.map) << read.map.error().text();
    EXPECT_EQ(read.map->size, glm::ivec2(1201));
    EXPECT_NEAR(read.map->max, 6929, 60); // Aconcagua, flattened a little by 90 m texels
    for (const float metres : read.map->read(read.map->texels()).metres)
        ASSERT_TRUE(metres > -500 && metres < 9000);
}

TEST(HeightMapFile, SixteenBitsComeBack)
{
    const TemporaryFolder folder;
    HeightGrid map{.size = {17, 5}};
    for (int i = 0; i < 17 * 5; ++i)
        map.metres.push_back(float(i) * 7);
    map.metres[3] = 9999; // above the highest
    ASSERT_TRUE(writeHeightMap16(folder / "h.png", map, -100, 600));
    const ReadMap read{folder / "h.png", {.minHeight = -100, .maxHeight = 600}};
    ASSERT_TRUE(read.map);
    EXPECT_EQ(read.map->size, map.size);
    EXPECT_NEAR(read.map->at(3, 0), 600, 1e-3);
    for (int i = 4; i < 17 * 5; ++i)
        EXPECT_NEAR(read.map->at(i % 17, i / 17), map.metres[std::size_t(i)], 700.0 / 65535);
}

TEST(HeightMapFile, VoidsTakeTheHeightAroundThem)
{
    const TemporaryFolder folder;
    Image image{.size = {32, 32}, .channels = 1, .type = PixelType::F32};
    image.bytes.resize(image.rowBytes() * 32);
    for (int z = 0; z < 32; ++z)
        for (int x = 0; x < 32; ++x)
            image.row<float>(z)[x] = float(100 + x);
    const float marks[] = {NAN, INFINITY, -INFINITY, -32768, -32767, -9999, 1e38f, -1e38f};
    for (int i = 0; i < 8; ++i)
        image.row<float>(10 + i)[15] = marks[i];
    ASSERT_TRUE(writeImage(folder / "h.exr", image));
    const ReadMap read{folder / "h.exr"};
    ASSERT_TRUE(read.map);
    for (int i = 0; i < 8; ++i)
        EXPECT_NEAR(read.map->at(15, 10 + i), 115, 0.6);
    EXPECT_EQ(read.map->min, 100);
    EXPECT_EQ(read.map->max, 131);
    ASSERT_EQ(read.complaints.size(), 1u);
    EXPECT_EQ(read.complaints[0].what, "8 heights are missing; filled from their neighbours");
}

TEST(HeightMapFile, LargeVoidsEndSmooth)
{
    const TemporaryFolder folder;
    Image image{.size = {64, 64}, .channels = 1, .type = PixelType::F32};
    image.bytes.resize(image.rowBytes() * 64);
    for (int z = 0; z < 64; ++z)
        for (int x = 0; x < 64; ++x)
            image.row<float>(z)[x] = x > 8 && x < 56 && z > 8 && z < 56 ? -9999 : float(x * 10);
    ASSERT_TRUE(writeImage(folder / "h.exr", image));
    const ReadMap read{folder / "h.exr"};
    ASSERT_TRUE(read.map);
    for (int z = 0; z < 64; ++z)
        for (int x = 1; x < 64; ++x)
            ASSERT_LT(std::abs(read.map->at(x, z) - read.map->at(x - 1, z)), 60) << x << " " << z;
}

TEST(HeightMapFile, EdgeCasesEndWell)
{
    NEEDS_TEST_DATA();
    const fs::path edge = testData() / "heightmaps/edge";
    const Terrain plain{.minHeight = 0, .maxHeight = 65535};
    EXPECT_EQ(ReadMap(edge / "u16-1x1.png").map.error().what, "a height map needs at least 2 x 2 pixels");
    EXPECT_FALSE(ReadMap(edge / "u16-257.r16").map); // raw numbers say nothing of their size
    EXPECT_FALSE(ReadMap(edge / "missing.png").map);
    EXPECT_EQ(ReadMap(edge / "float32-huge-1e38.tif").map.error().what, "a height map without a single height");
    for (const char* name :
         {"bigendian-u16.tif", "float32-inf.tif", "float32-nan-patch.tif", "float32-nodata-minus9999.tif",
          "float64.tif", "int16-void-32768.tif", "rgb-257.png", "u16-257.png", "u16-257x2.png", "u16-flat.png",
          "u16-nonsquare-257x200.png", "u8-257.png", "u8-jpeg-artifacts.jpg", "uint32.tif"}) {
        const ReadMap read{edge / name, plain};
        ASSERT_TRUE(read.map) << name << ": " << read.map.error().text();
        for (const float metres : read.map->read(read.map->texels()).metres)
            ASSERT_TRUE(std::isfinite(metres)) << name;
        EXPECT_LE(read.map->min, read.map->max);
    }
    EXPECT_EQ(listed(ReadMap(edge / "u16-257.png", plain).complaints), "");
    EXPECT_NE(listed(ReadMap(edge / "float32-nan-patch.tif", plain).complaints).find("heights are missing"),
              std::string::npos);
    EXPECT_NE(listed(ReadMap(edge / "rgb-257.png", plain).complaints).find("first channel"), std::string::npos);
    EXPECT_NE(listed(ReadMap(edge / "u8-257.png", plain).complaints).find("8 bits make steps of 257 m"),
              std::string::npos);
}

TEST(HeightMapFile, ByteOrderIsNoMatter)
{
    NEEDS_TEST_DATA();
    const fs::path edge = testData() / "heightmaps/edge";
    const ReadMap big{edge / "bigendian-u16.tif"}, little{edge / "u16-257.png"};
    ASSERT_TRUE(big.map && little.map);
    if (big.map->size == little.map->size) {
        EXPECT_TRUE(big.map->sameHeights(*little.map));
    }
}

} // namespace
} // namespace io
