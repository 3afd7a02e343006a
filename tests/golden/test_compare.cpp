#include "tests/golden/compare.h"

#include <gtest/gtest.h>

namespace test {
namespace {

io::Image flat(std::uint8_t value)
{
    io::Image image{.size = {10, 10}, .channels = 3, .type = io::PixelType::U8};
    image.bytes.assign(300, std::byte{value});
    return image;
}

TEST(Compare, equalPicturesDoNotDiffer)
{
    const Difference d = compare(flat(90), flat(90));
    EXPECT_EQ(d.mean, 0);
    EXPECT_EQ(d.outliers, 0);
}

TEST(Compare, countsWhatIsOff)
{
    io::Image other = flat(90);
    other.row<std::uint8_t>(3)[4 * 3 + 1] = 190;
    const Difference d = compare(flat(90), other);
    EXPECT_DOUBLE_EQ(d.mean, 100.0 / 300);
    EXPECT_DOUBLE_EQ(d.outliers, 0.01);
    EXPECT_EQ(d.picture.row<std::uint8_t>(3)[4 * 3 + 1], 255);
    EXPECT_EQ(d.picture.row<std::uint8_t>(3)[4 * 3], 0);
}

TEST(Compare, aSlightShadeIsNoOutlier)
{
    const Difference d = compare(flat(90), flat(95));
    EXPECT_EQ(d.mean, 5);
    EXPECT_EQ(d.outliers, 0);
}

} // namespace
} // namespace test
