// Height maps read and written in bands: nothing depends on where a band or a tile ends.
#include "support.h"

#include "io/files/height_map_file.h"
#include "io/files/image_file.h"
#include "io/files/image_rows.h"
#include "io/files/void_filling.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <fstream>
#include <random>
#include <zlib.h>

namespace io {
namespace {

const Terrain kHills{.metresPerTexel = 2, .origin = {-7, 9}, .minHeight = -80, .maxHeight = 1940.5};

template <class T> Image noise(glm::ivec2 size, PixelType type, int channels = 1)
{
    std::mt19937 random{7};
    Image image{.size = size, .channels = channels, .type = type};
    image.bytes.resize(image.rowBytes() * std::size_t(size.y));
    for (int z = 0; z < size.y; ++z)
        for (int i = 0; i < size.x * channels; ++i)
            image.row<T>(z)[i] = type == PixelType::F32 ? T(float(random() % 100000) * 0.037f) : T(random());
    return image;
}

float nan()
{
    return std::numeric_limits<float>::quiet_NaN();
}

bool isMark(float m)
{
    return !std::isfinite(m) || std::abs(m) > 1e5f || m == -32768 || m == -32767 || m == -9999;
}

// What a height map is by the words of its header, from the picture as a whole.
std::vector<float> metresOf(const Image& image)
{
    std::vector<float> metres;
    for (int z = 0; z < image.size.y; ++z)
        for (int x = 0; x < image.size.x; ++x) {
            const std::size_t at = std::size_t(x) * std::size_t(image.channels);
            const double span = kHills.maxHeight - kHills.minHeight;
            if (image.type == PixelType::U8) metres.push_back(float(kHills.minHeight + span / 255 * image.row<std::uint8_t>(z)[at]));
            if (image.type == PixelType::U16) metres.push_back(float(kHills.minHeight + span / 65535 * image.row<std::uint16_t>(z)[at]));
            if (image.type == PixelType::F32) metres.push_back(isMark(image.row<float>(z)[at]) ? nan() : image.row<float>(z)[at]);
        }
    return metres;
}

// Voids filled the plain way, every list and every field of the map's size.
std::size_t fillPlainly(std::vector<float>& metres, glm::ivec2 size)
{
    const auto mean = [&](const std::vector<float>& from, int x, int z) {
        float sum = 0;
        int count = 0;
        for (int row = std::max(z - 1, 0); row <= std::min(z + 1, size.y - 1); ++row)
            for (int column = std::max(x - 1, 0); column <= std::min(x + 1, size.x - 1); ++column) {
                const float m = from[std::size_t(row) * size.x + column];
                if ((column == x && row == z) || std::isnan(m)) continue;
                sum += m;
                ++count;
            }
        return count == 0 ? nan() : sum / float(count);
    };
    const std::vector<float> given = metres;
    const auto each = [&](bool onlyVoids) {
        const std::vector<float> before = metres;
        for (int z = 0; z < size.y; ++z)
            for (int x = 0; x < size.x; ++x) {
                const std::size_t at = std::size_t(z) * size.x + x;
                if (std::isnan(given[at]) && (!onlyVoids || std::isnan(before[at]))) metres[at] = mean(before, x, z);
            }
    };
    while (std::ranges::any_of(metres, [](float m) { return std::isnan(m); }))
        each(true);
    const auto voids = std::size_t(std::ranges::count_if(given, [](float m) { return std::isnan(m); }));
    for (int pass = 0; voids > 0 && pass < 32; ++pass)
        each(false);
    return voids;
}

void expectReads(const fs::path& file, const Image& image)
{
    std::vector<float> metres = metresOf(image);
    const std::size_t voids = fillPlainly(metres, image.size);
    Complaints complaints;
    const Result<HeightMap> map = readHeightMap(file, kHills, complaints);
    ASSERT_TRUE(map) << map.error().text();
    ASSERT_EQ(map->size, image.size);
    EXPECT_EQ(map->metresPerTexel, 2);
    EXPECT_EQ(map->origin, glm::dvec2(-7, 9));
    EXPECT_EQ(map->shares, image.type != PixelType::F32);
    const std::vector<float> read = map->field().read(map->texels());
    EXPECT_EQ(std::memcmp(read.data(), metres.data(), metres.size() * sizeof(float)), 0) << file;
    EXPECT_EQ(map->min, *std::ranges::min_element(metres));
    EXPECT_EQ(map->max, *std::ranges::max_element(metres));
    EXPECT_EQ(*map, HeightMap(HeightGrid{image.size, metres, 2, {-7, 9}}));
    const std::string said = std::to_string(voids) + " heights are missing; filled from their neighbours";
    EXPECT_EQ(listed(complaints).find(said) != std::string::npos, voids > 0) << listed(complaints);
}

void writeTiff(const fs::path& file, const Image& image)
{
    const auto rows = [&](int first, int count, std::byte* to) {
        std::memcpy(to, image.row<std::byte>(first), image.rowBytes() * std::size_t(count));
    };
    const Result<std::string> tiff = encodeFloatRows(".tif", {image.size, image.channels, image.type}, rows);
    ASSERT_TRUE(tiff) << tiff.error().text();
    put(file, *tiff);
}

// One band, several, several tiles; narrower and wider than whole ones.
const glm::ivec2 kSizes[] = {{2, 2}, {31, 700}, {513, 17}, {700, 1025}, {5000, 450}};

TEST(LargeHeights, BandsMakeWhatTheWholePictureHolds)
{
    const TemporaryFolder folder;
    for (const glm::ivec2 size : kSizes) {
        const Image bytes = noise<std::uint8_t>(size, PixelType::U8), words = noise<std::uint16_t>(size, PixelType::U16),
                    colours = noise<std::uint16_t>(size, PixelType::U16, 3), floats = noise<float>(size, PixelType::F32);
        const std::pair<const char*, const Image&> files[] = {{"8.png", bytes}, {"16.png", words}, {"rgb.png", colours}, {"f.exr", floats}};
        for (const auto& [name, image] : files) {
            ASSERT_TRUE(writeImage(folder / name, image));
            expectReads(folder / name, image);
        }
        writeTiff(folder / "f.tif", floats);
        expectReads(folder / "f.tif", floats);
    }
}

TEST(LargeHeights, VoidsAcrossBandsAndTilesAreFilledAsInOne)
{
    const TemporaryFolder folder;
    Image image = noise<float>({1100, 1300}, PixelType::F32);
    const auto clear = [&](glm::ivec2 low, glm::ivec2 high, float mark) {
        for (int z = low.y; z < high.y; ++z)
            for (int x = low.x; x < high.x; ++x)
                image.row<float>(z)[x] = mark;
    };
    clear({490, 500}, {560, 530}, -9999); // across four tiles
    clear({0, 0}, {20, 3}, NAN);          // a corner
    clear({1090, 900}, {1100, 1300}, -32768);
    clear({700, 511}, {701, 512}, INFINITY);
    clear({900, 1020}, {1000, 1029}, 1e38f);
    ASSERT_TRUE(writeImage(folder / "f.exr", image));
    expectReads(folder / "f.exr", image);
    writeTiff(folder / "f.tif", image);
    expectReads(folder / "f.tif", image);
    // A single height is known.
    Image small{.size = {40, 30}, .channels = 1, .type = PixelType::F32};
    small.bytes.resize(small.rowBytes() * 30);
    std::fill_n(small.row<float>(0), 1200, -9999.0f);
    small.row<float>(29)[39] = 12.5f;
    ASSERT_TRUE(writeImage(folder / "f.exr", small));
    expectReads(folder / "f.exr", small);
}

TEST(LargeHeights, ReportsWithinEvery512RowsAndStopsWhenToldTo)
{
    const TemporaryFolder folder;
    ASSERT_TRUE(writeImage(folder / "h.png", noise<std::uint16_t>({64, 2600}, PixelType::U16)));
    std::vector<float> told;
    Complaints complaints;
    const Progress listen = [&](float fraction, std::string_view step) {
        EXPECT_EQ(step, "h.png");
        told.push_back(fraction);
        return true;
    };
    ASSERT_TRUE(readHeightMap(folder / "h.png", kHills, complaints, listen));
    ASSERT_GE(told.size(), 6u);
    EXPECT_TRUE(std::ranges::is_sorted(told));
    for (std::size_t i = 1; i < told.size(); ++i)
        EXPECT_LE(told[i] - told[i - 1], 512.0f / 2600 + 1e-4f);

    int calls = 0;
    const Result<HeightMap> stopped = readHeightMap(folder / "h.png", kHills, complaints, [&](float, std::string_view) { return ++calls < 3; });
    ASSERT_FALSE(stopped);
    EXPECT_EQ(stopped.error().what, "reading was cancelled");
    EXPECT_EQ(calls, 3);
    EXPECT_EQ(listed(complaints), "");
}

TEST(LargeHeights, FillingStopsWhenToldTo)
{
    const TemporaryFolder folder;
    Image image = noise<float>({300, 300}, PixelType::F32);
    for (int z = 100; z < 200; ++z)
        std::fill_n(image.row<float>(z) + 100, 100, NAN);
    HeightMapBuilder map{image.size};
    for (int z = 0; z < 300; ++z)
        map.addRow({image.row<float>(z), 300});
    std::vector<float> told;
    EXPECT_FALSE(fillVoids(map, [&](float fraction, std::string_view) { return told.push_back(fraction), told.size() < 9; }, "h"));
    ASSERT_EQ(told.size(), 9u);
    EXPECT_GT(told.back(), 0.2f); // within the rings: it is 1 when what was filled settles
    EXPECT_LT(told.back(), 0.5f);
}

void appendChunk(std::string& png, const std::string& kind, const std::string& data)
{
    const auto word = [&](std::uint32_t value) {
        for (int shift = 24; shift >= 0; shift -= 8)
            png += char(value >> shift);
    };
    word(std::uint32_t(data.size()));
    const std::string body = kind + data;
    png += body;
    word(std::uint32_t(crc32(0, reinterpret_cast<const Bytef*>(body.data()), uInt(body.size()))));
}

std::string pngHeader(glm::uvec2 size, int depth = 16, int colours = 0, bool interlaced = false)
{
    std::string png = "\x89PNG\r\n\x1a\n", header;
    for (const std::uint32_t side : {size.x, size.y})
        header += {char(side >> 24), char(side >> 16), char(side >> 8), char(side)};
    appendChunk(png, "IHDR", header + char(depth) + char(colours) + std::string(2, '\0') + char(interlaced ? 1 : 0));
    return png;
}

std::string packed(const std::string& bytes)
{
    uLongf size = compressBound(bytes.size());
    std::string packed(size, '\0');
    EXPECT_EQ(compress(reinterpret_cast<Bytef*>(packed.data()), &size, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size()), Z_OK);
    return packed.substr(0, size);
}

// Any bytes are a picture, whatever their filters: each row has the next one of five.
std::string randomPng(glm::ivec2 size, int depth, int colours, std::size_t chunk, const std::string& transparent = {}, int filters = 5)
{
    const int channels = colours == 2 ? 3 : 1;
    std::mt19937 random{3};
    std::string rows;
    for (int z = 0; z < size.y; ++z) {
        rows += char(z % filters);
        for (int i = 0; i < (size.x * channels * depth + 7) / 8; ++i)
            rows += char(random());
    }
    std::string png = pngHeader(size, depth, colours);
    appendChunk(png, "tEXt", "Comment\0is passed over");
    if (!transparent.empty()) appendChunk(png, "tRNS", transparent);
    const std::string data = packed(rows);
    for (std::size_t at = 0; at < data.size(); at += chunk)
        appendChunk(png, "IDAT", data.substr(at, chunk));
    appendChunk(png, "IDAT", ""); // allowed
    appendChunk(png, "IEND", "");
    return png;
}

TEST(LargeHeights, EveryKindOfPngIsReadAsLibpngReadsIt)
{
    const TemporaryFolder folder;
    const auto compare = [&](const std::string& png) {
        put(folder / "h.png", png);
        const Result<Image> whole = readImage(folder / "h.png");
        ASSERT_TRUE(whole) << whole.error().text();
        expectReads(folder / "h.png", *whole);
    };
    for (const glm::ivec2 size : {glm::ivec2{2, 11}, {333, 41}, {300, 1300}}) {
        for (const int depth : {1, 2, 4, 8, 16})
            compare(randomPng(size, depth, 0, 5000));
        compare(randomPng(size, 8, 0, 100000, std::string{"\0\7", 2}));
        compare(randomPng(size, 16, 2, 3));
    }
}

TEST(LargeHeights, DamagedPngsAreRefused)
{
    const TemporaryFolder folder;
    const std::string whole = randomPng({200, 90}, 16, 0, 4096);
    const auto fault = [&](const std::string& png) {
        put(folder / "h.png", png);
        Complaints complaints;
        const Result<HeightMap> map = readHeightMap(folder / "h.png", kHills, complaints);
        const bool alike = bool(map) == bool(readImage(folder / "h.png")) && complaints.empty();
        return alike ? map ? "" : map.error().what : "otherwise than the whole picture";
    };
    EXPECT_EQ(fault(whole), "");
    for (std::size_t length = 150; length + 24 < whole.size(); length += 3001)
        EXPECT_EQ(fault(whole.substr(0, length)), "damaged: the file ends early") << length;
    EXPECT_EQ(fault(randomPng({200, 90}, 16, 0, 4096, {}, 6)), "damaged: bad adaptive filter value");
    for (std::size_t at = 150; at < whole.size() - 60; at += 2777) {
        std::string bad = whole;
        bad[at] = char(bad[at] ^ 0x10);
        EXPECT_NE(fault(bad).find("damaged: "), std::string::npos) << at << " " << fault(bad);
    }
    std::string shorter = pngHeader({200, 90});
    appendChunk(shorter, "IDAT", packed(std::string(401 * 60, '\0'))); // of 90 rows
    appendChunk(shorter, "IEND", "");
    EXPECT_EQ(fault(shorter), "damaged: IDAT: not enough image data");
}

std::size_t peakMemory() // bytes that this process has had at most
{
    std::ifstream status{"/proc/self/status"};
    for (std::string word; status >> word;)
        if (word == "VmHWM:") return status >> word, std::size_t(std::stoul(word)) << 10;
    return 0;
}

TEST(LargeHeights, AHeaderAloneTakesNoMemory)
{
    const TemporaryFolder folder;
    const std::string row = packed(std::string(16385 * 2 + 1, '\0'));
    std::string png = pngHeader({16385, 16385});
    appendChunk(png, "IDAT", row);
    put(folder / "h.png", png);
    const std::size_t before = peakMemory();
    Complaints complaints;
    const Result<HeightMap> map = readHeightMap(folder / "h.png", kHills, complaints);
    ASSERT_FALSE(map);
    EXPECT_NE(map.error().what.find("damaged: "), std::string::npos) << map.error().what;
    EXPECT_LT(peakMemory() - before, std::size_t(64) << 20);

    put(folder / "h.png", pngHeader({16386, 2}));
    EXPECT_NE(readHeightMap(folder / "h.png", kHills, complaints).error().what.find("a side may have at most 16385"), std::string::npos);
    png = pngHeader({16385, 16385}, 16, 0, true); // decoded only whole
    appendChunk(png, "IDAT", row);
    put(folder / "h.png", png);
    EXPECT_NE(readHeightMap(folder / "h.png", kHills, complaints).error().what.find("a side may have at most 16384"), std::string::npos);
    EXPECT_EQ(listed(complaints), "");
}

TEST(LargeHeights, ATiffOfOneHugeTileTakesNoMemory)
{
    // Tags: width, height, bits, compression (deflate), photometric, samples, tile width and length, offset, bytes, float.
    const std::pair<std::uint16_t, std::uint32_t> tags[] = {{256, 16384}, {257, 8192}, {258, 32}, {259, 8}, {262, 1}, {277, 1},
                                                            {322, 16384}, {323, 8192}, {324, 160}, {325, 32}, {339, 3}};
    std::string tiff{"II*\0\x08\0\0\0", 8};
    const auto append = [&](std::uint32_t value, int bytes) {
        for (int i = 0; i < bytes; ++i)
            tiff += char(value >> (8 * i));
    };
    append(std::size(tags), 2);
    for (const auto& [tag, value] : tags) {
        append(tag, 2);
        append(4, 2);
        append(1, 4);
        append(value, 4);
    }
    append(0, 4);
    tiff.resize(1024);
    const TemporaryFolder folder;
    put(folder / "h.tif", tiff);
    const std::size_t before = peakMemory();
    Complaints complaints;
    const Result<HeightMap> map = readHeightMap(folder / "h.tif", kHills, complaints);
    ASSERT_FALSE(map);
    EXPECT_EQ(map.error().what, "too small for the tiles that it says it holds");
    EXPECT_LT(peakMemory() - before, std::size_t(96) << 20);
}

TEST(LargeHeights, AreSavedAsTheWholePictureIs)
{
    const TemporaryFolder folder;
    for (const glm::ivec2 size : kSizes) {
        const Image floats = noise<float>(size, PixelType::F32);
        const HeightMap map{HeightGrid{size, {floats.row<float>(0), floats.row<float>(0) + std::size_t(size.x) * size.y}}};
        Terrain terrain{.heightMap = "h.png", .minHeight = 0, .maxHeight = 4000};
        const Result<std::string> png = encodeHeightMap(map, terrain);
        ASSERT_TRUE(png);
        Image words{.size = size, .channels = 1, .type = PixelType::U16};
        words.bytes.resize(words.rowBytes() * std::size_t(size.y));
        for (int z = 0; z < size.y; ++z)
            for (int x = 0; x < size.x; ++x)
                words.row<std::uint16_t>(z)[x] = std::uint16_t(std::lround(std::clamp(double(map.at(x, z)) / 4000, 0.0, 1.0) * 65535));
        ASSERT_TRUE(writeImage(folder / "whole.png", words));
        EXPECT_TRUE(*png == get(folder / "whole.png")) << size.x;

        terrain.heightMap = "h.exr";
        const Result<std::string> exr = encodeHeightMap(map, terrain);
        ASSERT_TRUE(exr);
        put(folder / "h.exr", *exr);
        Complaints complaints;
        const Result<HeightMap> back = readHeightMap(folder / "h.exr", kHills, complaints);
        ASSERT_TRUE(back) << back.error().text();
        EXPECT_TRUE(back->sameHeights(map));
    }
}

} // namespace
} // namespace io
