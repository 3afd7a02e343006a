#include "support.h"

#include "io/files/image_bytes.h"
#include "io/files/image_file.h"
#include "io/files/jpeg_file.h"
#include "io/files/png_file.h"
#include "io/files/shared_images.h"

#include <array>
#include <cstdlib>
#include <iterator>
#include <map>
#include <span>
#include <sstream>
#include <thread>

namespace io {
namespace {

using namespace std::string_literals;

template <class T> Image gradient(glm::ivec2 size, int channels, PixelType type, T step)
{
    Image image{.size = size, .channels = channels, .type = type};
    image.bytes.resize(image.rowBytes() * std::size_t(size.y));
    T* value = image.row<T>(0);
    for (int i = 0; i < size.x * size.y * channels; ++i)
        value[i] = T(T(i) * step);
    return image;
}

bool same(const Image& a, const Image& b)
{
    return a.size == b.size && a.channels == b.channels && a.type == b.type && a.bytes == b.bytes;
}

TEST(Image, PngKeepsEightAndSixteenBitsAndEveryChannelCount)
{
    for (int channels = 1; channels <= 4; ++channels) {
        const Image bytes = gradient<std::uint8_t>({13, 7}, channels, PixelType::U8, 3);
        const Image words = gradient<std::uint16_t>({5, 9}, channels, PixelType::U16, 257);
        for (const Image& image : {bytes, words}) {
            const Result<std::string> png = encodePng(image);
            ASSERT_TRUE(png) << png.error().text();
            const Result<Image> back = decodeImage(*png, "x");
            ASSERT_TRUE(back) << back.error().text();
            EXPECT_TRUE(same(*back, image)) << channels;
        }
    }
}

TEST(Image, AlphaDoesNotDarkenTheColour)
{
    Image image{.size = {1, 1}, .channels = 4, .type = PixelType::U8};
    for (const int value : {200, 100, 50, 0})
        image.bytes.push_back(std::byte(value));
    EXPECT_TRUE(same(*decodeImage(*encodePng(image), "x"), image));
}

TEST(Image, SameImageIsTheSameBytes)
{
    const Image image = gradient<std::uint8_t>({64, 64}, 3, PixelType::U8, 1);
    EXPECT_EQ(*encodePng(image), *encodePng(image));
}

TEST(Image, ExrKeepsFloatsAndJpegIsClose)
{
    const TemporaryFolder folder;
    const Image floats = gradient<float>({8, 4}, 3, PixelType::F32, 1000.5f);
    ASSERT_TRUE(writeImage(folder / "a.exr", floats));
    const Result<Image> exr = readImage(folder / "a.exr");
    ASSERT_TRUE(exr) << exr.error().text();
    EXPECT_TRUE(same(*exr, floats));

    const Image soft = gradient<std::uint8_t>({16, 16}, 1, PixelType::U8, 1);
    for (const char* name : {"a.jpg", "a.JPEG"}) {
        ASSERT_TRUE(writeImage(folder / name, soft));
        const Result<Image> jpeg = readImage(folder / name);
        ASSERT_TRUE(jpeg) << jpeg.error().text();
        for (std::size_t i = 0; i < soft.bytes.size(); ++i)
            ASSERT_NEAR(int(jpeg->bytes[i]), int(soft.bytes[i]), 6);
    }
}

TEST(Image, JpegQualityIsHonoured)
{
    const TemporaryFolder folder;
    const Image noisy = gradient<std::uint8_t>({128, 128}, 3, PixelType::U8, 37);
    ASSERT_TRUE(writeImage(folder / "low.jpg", noisy, 20));
    ASSERT_TRUE(writeImage(folder / "high.jpg", noisy, 98));
    EXPECT_LT(fs::file_size(folder / "low.jpg") * 2, fs::file_size(folder / "high.jpg"));
}

std::string jpegOf(const Image& image)
{
    const Result<std::string> jpeg = encodeJpeg(image, 90);
    EXPECT_TRUE(jpeg);
    return *jpeg;
}

TEST(Image, JpegKeepsOneChannelOrThreeAndLosesAlpha)
{
    for (int channels = 1; channels <= 4; ++channels) {
        Image image{.size = {16, 8}, .channels = channels, .type = PixelType::U8};
        for (int i = 0; i < 16 * 8; ++i)
            for (int c = 0; c < channels; ++c)
                image.bytes.push_back(std::byte(60 + 40 * c));
        const Result<Image> back = decodeImage(jpegOf(image), "x");
        ASSERT_TRUE(back) << back.error().text();
        ASSERT_EQ(back->channels, channels < 3 ? 1 : 3);
        for (std::size_t i = 0; i < back->bytes.size(); ++i)
            ASSERT_NEAR(int(back->bytes[i]), 60 + 40 * int(i % std::size_t(back->channels)), 3) << channels;
    }
}

// 8 x 8 pixels of (200, 100, 40) as inks, inverted and marked so, as Adobe's programs write them.
constexpr std::string_view kInks =
    "ffd8ffee000e41646f626500640000000002ffdb0043000302020302020303030304030304050805050404050a070706080c0a0c0c0b0a0b0b0d"
    "0e12100d0e110e0b0b1016101113141515150c0f171816141812141514ffdb00430103040405040509050509140d0b0d14141414141414141414"
    "14141414141414141414141414141414141414141414141414141414141414141414141414141414ffc000140800080008040111000211010311"
    "01041100ffc4001500010100000000000000000000000000000708ffc40014100100000000000000000000000000000000ffc400140101000000"
    "00000000000000000000000008ffc40014110100000000000000000000000000000000ffda000e040100021103110400003f002f28044580ffd9";

std::string fromHex(std::string_view digits)
{
    std::string bytes;
    for (std::size_t i = 0; i + 1 < digits.size(); i += 2)
        bytes += char(std::stoi(std::string{digits.substr(i, 2)}, nullptr, 16));
    return bytes;
}

TEST(Image, JpegOfInksBecomesColours)
{
    const Result<Image> image = decodeImage(fromHex(kInks), "x");
    ASSERT_TRUE(image) << image.error().text();
    ASSERT_EQ(image->channels, 3);
    ASSERT_EQ(image->size, glm::ivec2{8});
    for (std::size_t i = 0; i < image->bytes.size(); ++i)
        ASSERT_NEAR(int(image->bytes[i]), (std::array{200, 100, 40})[i % 3], 4);
}

TEST(Image, JpegThatEndsEarlyOrIsDamagedIsRefusedOrRead)
{
    const std::string good = jpegOf(gradient<std::uint8_t>({64, 48}, 3, PixelType::U8, 7));
    for (std::size_t size = 4; size + 2 < good.size(); size += 13) {
        const Result<Image> cut = decodeImage(good.substr(0, size), "a.jpg");
        ASSERT_FALSE(cut) << size << " of " << good.size();
        EXPECT_TRUE(cut.error().text().starts_with("a.jpg: ")) << cut.error().text();
    }
    EXPECT_EQ(decodeImage(good.substr(0, good.size() / 2), "a.jpg").error().text(), "a.jpg: damaged: the file ends early");
    for (std::size_t at = 2; at < good.size(); ++at) // whatever it says, it comes back
        for (const char value : {'\0', '\x7F', '\xFF'}) {
            std::string damaged = good;
            damaged[at] = value;
            (void)decodeImage(damaged, "x");
        }
}

TEST(Image, ModelsShareWhatTheyHoldAlike)
{
    const Image image = gradient<std::uint8_t>({8, 8}, 3, PixelType::U8, 5);
    const std::string png = *encodePng(image);
    auto first = *decodeShared(png, "a");
    EXPECT_EQ(*decodeShared(png, "b"), first);
    EXPECT_TRUE(same(*first, image));
    EXPECT_NE(*decodeShared(jpegOf(image), "c"), first);
    const std::weak_ptr<const Image> left = first;
    first.reset();
    EXPECT_TRUE(left.expired()) << "nobody needs it";
    EXPECT_TRUE(same(**decodeShared(png, "a"), image));
    EXPECT_EQ(decodeShared(png.substr(0, 40), "d").error().text(), decodeImage(png.substr(0, 40), "d").error().text());

    std::vector<std::shared_ptr<const Image>> together(8);
    {
        std::vector<std::jthread> threads;
        for (auto& one : together)
            threads.emplace_back([&] { one = *decodeShared(png, "e"); });
    }
    for (const auto& one : together)
        EXPECT_EQ(one, together.front());
}

TEST(Image, WritingRefusesWhatAFormatCannotHold)
{
    const TemporaryFolder folder;
    const Image floats = gradient<float>({2, 2}, 3, PixelType::F32, 1);
    EXPECT_FALSE(writeImage(folder / "a.png", floats));
    EXPECT_FALSE(writeImage(folder / "a.jpg", floats));
    EXPECT_FALSE(writeImage(folder / "a.gif", floats));
    EXPECT_FALSE(writeImage(folder / "a.exr", gradient<std::uint8_t>({2, 2}, 3, PixelType::U8, 1)));
    EXPECT_FALSE(encodePng(floats));
    EXPECT_TRUE(fs::is_empty(folder.path()));
}

TEST(Image, FormatIsToldByTheFirstBytesNotTheName)
{
    EXPECT_EQ(imageFormat("\x89PNG\r\n\x1a\n"), "png");
    EXPECT_EQ(imageFormat("\xFF\xD8\xFF\xE0"), "jpeg");
    EXPECT_EQ(imageFormat("MM\0*"s), "tiff");
    EXPECT_EQ(imageFormat("GIF89a"), "");
    EXPECT_EQ(imageFormat(""), "");
    EXPECT_EQ(decodeImage("BM stranger", "a.png").error().text(),
              "a.png: not an image that Wold reads (PNG, JPEG, TIFF, EXR, HDR, DDS)");
}

TEST(Image, MetadataIsLeftOutAndPixelsStay)
{
    const Image image = gradient<std::uint8_t>({4, 4}, 3, PixelType::U8, 5);
    std::string png = *encodePng(image);
    const std::string text = "\0\0\0\5tEXtab\0cdXXXX"s; // its checksum is wrong: a decoder would say so
    png.insert(33, text);                               // behind IHDR
    const std::string clean = withoutMetadata(png);
    EXPECT_EQ(clean.find("tEXt"), std::string::npos);
    EXPECT_TRUE(same(*decodeImage(png, "x"), image));

    const TemporaryFolder folder;
    ASSERT_TRUE(writeImage(folder / "a.jpg", image));
    std::string jpeg = get(folder / "a.jpg");
    jpeg.insert(2, "\xFF\xE1\0\7Exif!\xFF\xED\0\5abc\xFF\xFE\0\4hi"s);
    EXPECT_EQ(withoutMetadata(jpeg).find("Exif"), std::string::npos);
    EXPECT_TRUE(decodeImage(jpeg, "x"));
    for (std::size_t size = 0; size < jpeg.size(); ++size) // cut anywhere it is walked through safely
        EXPECT_LE(withoutMetadata(std::string_view{jpeg}.substr(0, size)).size(), size);
    for (std::size_t size = 0; size < png.size(); ++size)
        EXPECT_LE(withoutMetadata(std::string_view{png}.substr(0, size)).size(), size);
}

TEST(Image, SizesAreRefusedFromTheHeader)
{
    NEEDS_TEST_DATA();
    const fs::path bad = testData() / "corpus/images-bad/handmade";
    EXPECT_NE(readImage(bad / "png-60000x60000-nodata.png").error().what.find("a side may have at most 16384"),
              std::string::npos);
    EXPECT_NE(readImage(bad / "png16-20000x20000-zeros-bomb.png").error().what.find("a side may have at most"),
              std::string::npos);
    EXPECT_FALSE(readImage(bad / "tiff-100000x100000.tif"));
    EXPECT_FALSE(readImage(bad / "hdr-huge.hdr"));
    EXPECT_FALSE(readImage(bad / "empty.png"));
    EXPECT_TRUE(readImage(bad / "png16-ok.png"));
    EXPECT_TRUE(readImage(bad / "wrong-ext-tiff.png"));
}

// 2 x 2 pixels of 2 bits, a palette of three colours, alpha for two of them, Adam7: what no writer of ours makes.
TEST(Image, AnInterlacedPaletteOfFewBitsIsColours)
{
    const std::string png = fromHex("89504e470d0a1a0a0000000d494844520000000200000002020300000178dfd52100000009504c5445"
                                    "0a141e28323c46505a16ac84740000000274524e53ff80080fb36a0000000e49444154789c63606070"
                                    "60680000014600c1beefbde90000000049454e44ae426082");
    const Result<Image> image = decodeImage(png, "x");
    ASSERT_TRUE(image) << image.error().text();
    EXPECT_EQ(image->size, glm::ivec2(2));
    ASSERT_EQ(image->channels, 4);
    const std::vector<int> expected{10, 20, 30, 255, 40, 50, 60, 128, 70, 80, 90, 255, 10, 20, 30, 255};
    for (std::size_t i = 0; i < expected.size(); ++i)
        EXPECT_EQ(int(image->bytes[i]), expected[i]) << i;
    // Cut off within its pixels it is refused, in one line.
    const Result<Image> cut = decodeImage(png.substr(0, png.size() - 20), "x");
    ASSERT_FALSE(cut);
    EXPECT_EQ(cut.error().text(), "x: damaged: the file ends early");
}

// How far a process of its own gets through the files: one word for each, and no word for the one it died on. It says
// nothing beside that: what is wrong with an image is for the caller to say.
std::vector<std::string> readApart(std::span<const std::string> files)
{
    const TemporaryFolder folder;
    std::string list;
    for (const std::string& file : files)
        list += file + "\n";
    put(folder / "list", list);
    const std::string command = std::string{WOLD_READ_IMAGES} + " < " + (folder / "list").string() + " > " +
                                (folder / "words").string() + " 2> " + (folder / "said").string();
    (void)!std::system(command.c_str());
    EXPECT_EQ(get(folder / "said"), "");
    std::istringstream words{get(folder / "words")};
    return {std::istream_iterator<std::string>{words}, {}};
}

// Debian's decoders die on some of these when they see them whole. What our own walk over the bytes leaves out or
// refuses keeps them alive.
TEST(Image, DamagedFilesAreReadOrRefused)
{
    NEEDS_TEST_DATA();
    std::vector<std::string> files;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator{testData() / "corpus/images-bad"}) {
        const Result<std::string> bytes = readFile(entry.path());
        if (bytes && !imageFormat(*bytes).empty()) files.push_back(entry.path().string());
    }
    std::map<std::string, int> count;
    for (std::size_t next = 0; next < files.size();) {
        const std::vector<std::string> words = readApart(std::span{files}.subspan(next));
        for (const std::string& word : words)
            ++count[word];
        next += words.size();
        if (next == files.size()) break;
        ADD_FAILURE() << "died on " << files[next++];
    }
    EXPECT_GT(count["read"], 10);
    EXPECT_GT(count["refused"], 30);
}

} // namespace
} // namespace io
