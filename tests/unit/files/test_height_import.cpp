// Height maps of other programs: what is read of them, what is guessed, and what is refused.
#include "support.h"

#include "io/files/geo_tiff.h"
#include "io/files/height_export.h"
#include "io/files/height_import.h"
#include "io/files/image_file.h"
#include "io/files/png_file.h"

#include <cmath>
#include <cstring>
#include <random>

namespace io {
namespace {

struct Imported {
    Complaints complaints;
    Result<HeightSource> source;
    Result<ImportedGround> ground;

    explicit Imported(const fs::path& file, const HeightMeasures& measures = {}, const RawLayout& layout = {}, const Scene& scene = {})
        : source{readHeightSource(file, layout, complaints)},
          ground{source ? groundFrom(*source, measures, scene, complaints) : Result<ImportedGround>{source.error()}}
    {
    }
    std::string fault() const { return ground ? "" : ground.error().text(); }
};

template <class T> std::string bytesOf(const std::vector<T>& values)
{
    return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T)};
}

std::vector<std::uint16_t> someSamples(glm::ivec2 size)
{
    std::mt19937 random{7};
    std::vector<std::uint16_t> samples;
    for (int i = 0; i < size.x * size.y; ++i)
        samples.push_back(std::uint16_t(random()));
    samples[0] = 0;
    samples[1] = 65535;
    return samples;
}

template <class T> Image imageOf(glm::ivec2 size, PixelType type, int channels, const std::vector<T>& values)
{
    Image image{.size = size, .channels = channels, .type = type};
    const std::string bytes = bytesOf(values);
    image.bytes.resize(bytes.size());
    std::memcpy(image.bytes.data(), bytes.data(), bytes.size());
    return image;
}

std::vector<float> someMetres(glm::ivec2 size)
{
    std::mt19937 random{11};
    std::vector<float> metres;
    for (int i = 0; i < size.x * size.y; ++i)
        metres.push_back(float(int(random() % 4'000'000) - 400'000) / 1000.f);
    return metres;
}

Terrain terrainOf(const ImportedGround& ground)
{
    return {.metresPerTexel = ground.grid.metresPerTexel, .origin = ground.grid.origin, .minHeight = ground.minHeight, .maxHeight = ground.maxHeight};
}

HeightMap mapOf(const ImportedGround& ground)
{
    HeightMap map{ground.grid};
    map.shares = ground.shares;
    return map;
}

constexpr glm::ivec2 kSize{37, 23};
const HeightMeasures kHills{.metresPerTexel = 30, .heights = glm::dvec2{-20, 1400}};

TEST(HeightImport, SixteenBitsComeBackToTheBit)
{
    const TemporaryFolder folder;
    const auto samples = someSamples(kSize);
    put(folder / "a.png", *encodePng(imageOf(kSize, PixelType::U16, 1, samples)));
    put(folder / "a.r16", bytesOf(samples));
    for (const char* from : {"a.png", "a.r16"})
        for (const char* to : {"b.png", "b.r16"}) {
            const Imported in{folder / from, kHills, {.size = holdsRawSamples(from) ? std::optional{kSize} : std::nullopt}};
            ASSERT_TRUE(in.ground) << in.fault();
            EXPECT_TRUE(in.ground->shares);
            EXPECT_EQ(in.ground->minHeight, -20);
            EXPECT_EQ(in.ground->maxHeight, 1400);
            EXPECT_EQ(in.ground->grid.metresPerTexel, 30);
            EXPECT_EQ(in.ground->grid.origin, glm::dvec2(-540, -330)); // around the world's middle
            EXPECT_EQ(in.ground->grid.metres[0], -20);
            EXPECT_EQ(in.ground->grid.metres[1], 1400);
            const auto out = exportHeights(folder / to, mapOf(*in.ground), terrainOf(*in.ground));
            ASSERT_TRUE(out) << out.error().text();
            const Imported again{folder / to, kHills};
            ASSERT_TRUE(again.source) << again.fault();
            EXPECT_EQ(again.source->size, kSize); // .r16: by its header
            EXPECT_TRUE(std::ranges::equal(again.source->values, samples, [](float a, std::uint16_t b) { return a == float(b); })) << from << " " << to;
            EXPECT_TRUE(in.complaints.empty()) << listed(in.complaints);
        }
}

TEST(HeightImport, FloatsComeBackToTheBit)
{
    const TemporaryFolder folder;
    const auto metres = someMetres(kSize);
    HeightMap map{HeightGrid{.size = kSize, .metres = metres, .metresPerTexel = 0.5}};
    for (const char* to : {"b.exr", "b.tif", "b.r32"}) {
        ASSERT_TRUE(exportHeights(folder / to, map, {.metresPerTexel = 0.5}));
        const Imported again{folder / to};
        ASSERT_TRUE(again.ground) << again.fault();
        EXPECT_EQ(again.ground->grid.metres, metres) << to;
        EXPECT_FALSE(again.ground->shares);
        EXPECT_LE(again.ground->minHeight, map.min);
        EXPECT_GE(again.ground->maxHeight, map.max);
    }
    // Through 16 bits at most half a level is lost.
    const auto out = exportHeights(folder / "b.png", map, {});
    ASSERT_TRUE(out);
    const Imported again{folder / "b.png", {.heights = glm::dvec2{out->minHeight, out->maxHeight}}};
    ASSERT_TRUE(again.ground) << again.fault();
    const double level = (out->maxHeight - out->minHeight) / 65535;
    for (std::size_t i = 0; i < metres.size(); ++i)
        ASSERT_NEAR(again.ground->grid.metres[i], metres[i], level * 0.51);
}

TEST(HeightImport, ARawFileSaysWhatItNeeds)
{
    const TemporaryFolder folder;
    const auto samples = someSamples({64, 64});
    put(folder / "square.raw", bytesOf(samples));
    const Imported square{folder / "square.raw", kHills};
    ASSERT_TRUE(square.ground) << square.fault();
    EXPECT_EQ(square.source->size, glm::ivec2(64));
    EXPECT_EQ(square.source->sizeFrom, KnownFrom::Values);

    put(folder / "odd.raw", bytesOf(samples) + "x");
    EXPECT_NE(Imported(folder / "odd.raw").fault().find("odd.raw: 8193 bytes are no square of samples, so the size cannot be guessed"), std::string::npos);
    const Imported wrong{folder / "square.raw", {}, {.size = glm::ivec2{64, 63}}};
    EXPECT_NE(wrong.fault().find("8192 bytes are not 64 x 63 samples of 16 bits, which take 8064"), std::string::npos) << wrong.fault();
    EXPECT_TRUE(Imported(folder / "square.raw", {}, {.size = glm::ivec2{128, 32}}).ground);
    EXPECT_EQ(Imported(folder / "square.raw", {}, {.size = glm::ivec2{128, 64}}).source->sample, HeightSample::U8);
    EXPECT_FALSE(Imported(folder / "square.raw", {}, {.size = glm::ivec2{20000, 2}}).ground);
    EXPECT_FALSE(Imported(folder / "square.raw", {}, {.size = glm::ivec2{-64, -64}}).ground);
    put(folder / "empty.raw", "");
    EXPECT_FALSE(Imported(folder / "empty.raw").ground);

    std::vector<float> metres(64 * 64, 120.5f);
    put(folder / "floats.raw", bytesOf(metres));
    EXPECT_EQ(Imported(folder / "floats.raw").source->sample, HeightSample::F32);
}

TEST(HeightImport, ByteOrderIsAChoice)
{
    const TemporaryFolder folder;
    std::string little, big;
    for (int i = 0; i < 64 * 64; ++i) {
        const int height = 300 + i % 64 * 3;
        little += char(height & 255), little += char(height >> 8);
        big += char(height >> 8), big += char(height & 255);
    }
    put(folder / "little.raw", little);
    put(folder / "big.raw", big);
    const Imported a{folder / "little.raw", {}, {.sample = HeightSample::I16}}, b{folder / "big.raw", {}, {.sample = HeightSample::I16, .bigEndian = true}};
    ASSERT_TRUE(a.ground && b.ground) << a.fault() << b.fault();
    EXPECT_EQ(a.ground->grid.metres, b.ground->grid.metres);
    EXPECT_EQ(a.ground->grid.metres[1], 303);
    EXPECT_TRUE(a.complaints.empty());
    EXPECT_NE(listed(Imported(folder / "big.raw").complaints).find("smoother in the other byte order"), std::string::npos);
}

// Big-endian 16-bit rows of a tile with voids at its corner and in its middle.
std::string hgt(int side)
{
    std::string bytes;
    for (int z = 0; z < side; ++z)
        for (int x = 0; x < side; ++x) {
            const bool isVoid = (x < 2 && z < 2) || (x == 600 && z > 599 && z < 610);
            const auto metres = std::uint16_t(isVoid ? -32768 : 1000 + x);
            bytes += char(metres >> 8);
            bytes += char(metres & 255);
        }
    return bytes;
}

TEST(HeightImport, SrtmTilesTellTheirMeasures)
{
    const TemporaryFolder folder;
    put(folder / "N46E008.hgt", hgt(1201));
    const Imported in{folder / "N46E008.hgt"};
    ASSERT_TRUE(in.ground) << in.fault();
    EXPECT_EQ(in.source->size, glm::ivec2(1201));
    EXPECT_EQ(in.source->voids, 14u);
    EXPECT_EQ(in.ground->grid.metres[600], 1600);
    EXPECT_NEAR(in.ground->grid.metres[605 * 1201 + 600], 1600, 0.6);
    EXPECT_NEAR(in.ground->grid.metres[0], 1002, 1.1);
    EXPECT_NEAR(in.ground->grid.metresPerTexel, std::sqrt(92.6 * 63.9), 0.3); // 3 arc-seconds at 46.5 degrees north
    EXPECT_EQ(in.ground->metresFrom, KnownFrom::Name);
    EXPECT_NE(listed(in.complaints).find("14 heights are missing"), std::string::npos);
    EXPECT_FALSE(in.ground->shares);

    put(folder / "somewhere.hgt", hgt(1201));
    const Imported nowhere{folder / "somewhere.hgt"};
    EXPECT_EQ(nowhere.ground->metresFrom, KnownFrom::Usual);
    EXPECT_NE(listed(nowhere.complaints).find("tells no latitude"), std::string::npos);
    put(folder / "N46E009.hgt", hgt(1201).substr(1000));
    EXPECT_NE(Imported(folder / "N46E009.hgt").fault().find("no SRTM tile"), std::string::npos);
    std::string nothing;
    for (int i = 0; i < 1201 * 1201; ++i)
        nothing += std::string{"\x80\x00", 2};
    put(folder / "S01E001.hgt", nothing);
    EXPECT_NE(Imported(folder / "S01E001.hgt").fault().find("without a single height"), std::string::npos);
}

TEST(HeightImport, GapsAreFilledAndCountedAndNothingButGapsIsRefused)
{
    const TemporaryFolder folder;
    std::vector<float> metres(32 * 32, 50);
    metres[40] = NAN;
    metres[41] = INFINITY;
    put(folder / "few.r32", bytesOf(metres));
    const Imported few{folder / "few.r32"};
    ASSERT_TRUE(few.ground) << few.fault();
    EXPECT_EQ(few.source->voids, 2u);
    EXPECT_EQ(few.ground->grid.metres, std::vector<float>(32 * 32, 50));
    EXPECT_NE(listed(few.complaints).find("2 heights are missing"), std::string::npos);

    put(folder / "all.r32", bytesOf(std::vector<float>(32 * 32, NAN)));
    EXPECT_NE(Imported(folder / "all.r32").fault().find("all.r32: a height map without a single height"), std::string::npos);
    std::vector<float> most(32 * 32, 1e30f);
    most[5] = most[6] = 3;
    put(folder / "most.r32", bytesOf(most));
    EXPECT_NE(Imported(folder / "most.r32").fault().find("1022 of 1024 heights are missing"), std::string::npos);
}

TEST(HeightImport, ColoursAreRefusedAndGreysAreNot)
{
    const TemporaryFolder folder;
    std::vector<std::uint16_t> grey, colour;
    for (const std::uint16_t sample : someSamples({16, 16}))
        for (int channel = 0; channel < 3; ++channel) {
            grey.push_back(sample);
            colour.push_back(std::uint16_t(sample / (channel + 1)));
        }
    put(folder / "grey.png", *encodePng(imageOf({16, 16}, PixelType::U16, 3, grey)));
    put(folder / "colour.png", *encodePng(imageOf({16, 16}, PixelType::U16, 3, colour)));
    EXPECT_TRUE(Imported(folder / "grey.png").ground);
    const std::string fault = Imported(folder / "colour.png").fault();
    EXPECT_NE(fault.find("colour.png: a picture of 3 channels that differ is no height map; save it as grey"), std::string::npos) << fault;
}

TEST(HeightImport, MeasuresThatMakeNoGroundAreRefused)
{
    const TemporaryFolder folder;
    put(folder / "a.png", *encodePng(imageOf(kSize, PixelType::U16, 1, someSamples(kSize))));
    for (const double metres : {0.0, -1.0, double(NAN), double(INFINITY), 1e-9, 1e9}) {
        const std::string fault = Imported(folder / "a.png", {.metresPerTexel = metres}).fault();
        EXPECT_NE(fault.find("a.png: "), std::string::npos) << metres;
        EXPECT_NE(fault.find("metres per texel; say 0.001 to 10000"), std::string::npos) << fault;
    }
    for (const glm::dvec2 heights : {glm::dvec2{5, 5}, {10, -10}, {0, NAN}, {-1e9, 0}, {0, INFINITY}})
        EXPECT_NE(Imported(folder / "a.png", {.heights = heights}).fault().find("say the lower one first"), std::string::npos) << heights.x;
    put(folder / "m.r32", bytesOf(someMetres({32, 32})));
    EXPECT_NE(Imported(folder / "m.r32", kHills).fault().find("are metres already; leave the heights out"), std::string::npos);
    put(folder / "one.png", *encodePng(imageOf({1, 1}, PixelType::U16, 1, std::vector<std::uint16_t>{7})));
    EXPECT_NE(Imported(folder / "one.png").fault().find("at least 2 x 2"), std::string::npos);
    EXPECT_FALSE(Imported(folder / "a.png", {}, {.size = glm::ivec2{5, 5}}).ground); // an image has its own size
    EXPECT_FALSE(Imported(folder / "missing.png").ground);
}

TEST(HeightImport, SharesAsFloatsTakeHeights)
{
    const TemporaryFolder folder;
    std::vector<float> shares(32 * 32, 0.5f);
    shares[0] = 0, shares[1] = 1;
    put(folder / "s.r32", bytesOf(shares));
    const Imported in{folder / "s.r32", kHills};
    ASSERT_TRUE(in.ground) << in.fault();
    EXPECT_EQ(in.ground->grid.metres[0], -20);
    EXPECT_EQ(in.ground->grid.metres[1], 1400);
    EXPECT_EQ(in.ground->grid.metres[2], 690);
    const Imported plain{folder / "s.r32"};
    EXPECT_EQ(plain.ground->grid.metres, shares);
    EXPECT_NE(listed(plain.complaints).find("between 0 and 1 m"), std::string::npos);
}

TEST(HeightImport, WhatIsNotSaidIsTakenFromTheGroundOrGuessed)
{
    const TemporaryFolder folder;
    put(folder / "a.png", *encodePng(imageOf(kSize, PixelType::U16, 1, someSamples(kSize))));
    const Imported alone{folder / "a.png"};
    EXPECT_EQ(alone.ground->metresFrom, KnownFrom::Usual);
    EXPECT_EQ(alone.ground->heightsFrom, KnownFrom::Usual);

    Scene scene;
    HeightMap there{HeightGrid{.size = kSize, .metres = std::vector<float>(37 * 23, 1), .metresPerTexel = 4, .origin = {7, 8}}};
    there.shares = true;
    scene.exchange(Terrain{.heightMap = "terrain/h.png", .metresPerTexel = 4, .origin = {7, 8}, .minHeight = -5, .maxHeight = 300});
    scene.exchange(std::make_shared<const HeightMap>(there));
    const Imported beside{folder / "a.png", {}, {}, scene};
    EXPECT_EQ(beside.ground->grid.metresPerTexel, 4);
    EXPECT_EQ(beside.ground->minHeight, -5);
    EXPECT_EQ(beside.ground->maxHeight, 300);
    EXPECT_EQ(beside.ground->heightsFrom, KnownFrom::Ground);
    EXPECT_EQ(beside.ground->grid.origin, glm::dvec2(7, 8)); // a ground of the same measures stays where it is

    put(folder / "a.pgw", "12.5\n0\n0\n-12.5\n0\n0\n");
    EXPECT_EQ(Imported(folder / "a.png").ground->grid.metresPerTexel, 12.5);
    std::vector<std::uint16_t> whole(16 * 16, 1234);
    put(folder / "m.png", *encodePng(imageOf({16, 16}, PixelType::U16, 1, whole)));
    const Imported metres{folder / "m.png"};
    EXPECT_EQ(metres.ground->heightsFrom, KnownFrom::Values);
    EXPECT_EQ(metres.ground->grid.metres[0], 1234);
    EXPECT_FALSE(metres.ground->shares); // kept as floats: 16 bits over 65 km would be steps of a metre
}

TEST(HeightImport, HeadersBesideRawFilesAreRead)
{
    const RawHeader header = readRawHeader("nrows 12\r\nNCOLS   34\nNBITS 16\nPIXELTYPE SIGNEDINT\nBYTEORDER M\nXDIM 2.5\nNODATA -999\nHEIGHTS -3 40\n");
    EXPECT_EQ(header.layout.size, glm::ivec2(34, 12));
    EXPECT_EQ(header.layout.sample, HeightSample::I16);
    EXPECT_EQ(header.layout.bigEndian, true);
    EXPECT_EQ(header.cellSize, 2.5);
    EXPECT_EQ(header.nodata, -999);
    EXPECT_EQ(header.heights, glm::dvec2(-3, 40));
    const RawHeader again = readRawHeader(rawHeaderText({5, 6}, HeightSample::F32, 0.25, {1, 2}, std::nullopt));
    EXPECT_EQ(again.layout.size, glm::ivec2(5, 6));
    EXPECT_EQ(again.layout.sample, HeightSample::F32);
    EXPECT_EQ(again.layout.bigEndian, false);
    EXPECT_EQ(again.cellSize, 0.25);
    EXPECT_FALSE(readRawHeader("NROWS -3\nNCOLS 1e99\nNBITS\n").layout.size);
}

TEST(HeightImport, LargeGroundIsAllowedAndTexturesAreNot)
{
    const TemporaryFolder folder;
    const Image image = imageOf({16385, 2}, PixelType::U16, 1, std::vector<std::uint16_t>(16385 * 2, 9));
    put(folder / "wide.png", *encodePng(image));
    EXPECT_TRUE(readHeightSource(folder / "wide.png", {}, *std::make_unique<Complaints>()));
    EXPECT_FALSE(readImage(folder / "wide.png"));
}

TEST(HeightImport, MeasuredGroundComesBackToTheBit)
{
    NEEDS_TEST_DATA();
    const TemporaryFolder folder;
    for (const auto& [name, low, high] : {std::tuple{"andes-aconcagua", 343, 6084}, {"vancouver-coast-mountains", -17, 2552}, {"brindabella-act", 55, 1604}}) {
        const fs::path file = testData() / "heightmaps" / (name + std::string{"-1024-u16.png"});
        const Imported in{file, {.metresPerTexel = 90, .heights = glm::dvec2{low, high}}};
        ASSERT_TRUE(in.ground) << in.fault();
        for (const char* to : {"out.png", "out.r16", "out.exr", "out.tif", "out.r32"}) {
            const auto out = exportHeights(folder / to, mapOf(*in.ground), terrainOf(*in.ground));
            ASSERT_TRUE(out) << out.error().text();
            const Imported again{folder / to, out->metres ? HeightMeasures{} : HeightMeasures{.heights = glm::dvec2{low, high}}};
            ASSERT_TRUE(again.ground) << again.fault();
            EXPECT_EQ(again.ground->grid.metres, in.ground->grid.metres) << name << " " << to;
        }
        const auto before = readImage(file), after = readImage(folder / "out.png");
        EXPECT_EQ(before->bytes, after->bytes) << name;
    }
}

TEST(HeightImport, AMeasuredGeoTiffTellsItsTexelsAndItsVoids)
{
    NEEDS_TEST_DATA();
    const Imported in{testData() / "heightmaps/S33W071.tif"};
    ASSERT_TRUE(in.ground) << in.fault();
    EXPECT_EQ(in.ground->metresFrom, KnownFrom::File);
    EXPECT_NEAR(in.ground->grid.metresPerTexel, 85.07, 0.1); // 3 arc-seconds at 32.5 degrees south
    EXPECT_NE(listed(in.complaints).find("not square"), std::string::npos);
    const auto bytes = readFile(testData() / "heightmaps/S33W071.tif");
    EXPECT_TRUE(geoTiffOf(*bytes).nodata.has_value());
}

TEST(HeightImport, EdgeCasesEndWell)
{
    NEEDS_TEST_DATA();
    for (const fs::directory_entry& entry : fs::directory_iterator{testData() / "heightmaps/edge"}) {
        const Imported in{entry.path()};
        const std::string name = entry.path().filename().string();
        const bool refused = name == "float32-huge-1e38.tif" || name == "u16-1x1.png" || name == "u16-257-oddsize.raw" || name == "uint32.tif";
        EXPECT_EQ(bool(in.ground), !refused) << name << " " << in.fault();
        if (!in.ground) continue;
        for (const float metres : in.ground->grid.metres)
            ASSERT_TRUE(std::isfinite(metres)) << name;
        EXPECT_LT(in.ground->minHeight, in.ground->maxHeight) << name;
    }
}

} // namespace
} // namespace io
