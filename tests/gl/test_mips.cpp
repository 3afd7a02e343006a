// Mips of what is cut out by alpha: each lets through the share of texels that the largest does.
#include "renderer/pixels.h"
#include "renderer/shaders/shared/material.h"

#include <cmath>
#include <gtest/gtest.h>
#include <random>

namespace renderer {
namespace {

constexpr int kSide = 256;
constexpr float kCutoff = 0.5f;

// Leaves of some texels across, soft at their edges, over `share` of the image.
io::Image leaves(float share)
{
    io::Image image{.size = {kSide, kSide}, .channels = 4, .type = io::PixelType::U8};
    image.bytes.assign(image.rowBytes() * kSide, std::byte{0});
    std::mt19937 random{1};
    const int count = int(share * kSide * kSide / 120);
    for (int leaf = 0; leaf < count; ++leaf) {
        const int x0 = int(random() % kSide), y0 = int(random() % kSide);
        for (int y = -7; y <= 7; ++y)
            for (int x = -7; x <= 7; ++x) {
                const float edge = 7 - std::sqrt(float(x * x + y * y));
                auto& texel = image.row<glm::u8vec4>((y0 + y + kSide) % kSide)[(x0 + x + kSide) % kSide];
                texel.w = std::max(texel.w, glm::uint8(std::clamp(edge / 3, 0.0f, 1.0f) * 255));
            }
    }
    return image;
}

// The mean chance of a texel to pass, thresholds being spread as the shader spreads them.
double passing(const Pixels& pixels, int mip)
{
    const float spread = glsl::cutoutSpread(float(mip), kCutoff);
    double sum = 0;
    for (const glm::u8vec4& texel : pixels) {
        const float alpha = float(texel.w) / 255;
        sum += spread > 0 ? std::clamp((alpha - kCutoff) / spread + 0.5f, 0.0f, 1.0f) : float(alpha >= kCutoff);
    }
    return sum / double(pixels.size());
}

TEST(Mips, CutOutsKeepTheirShareDownToTheLast)
{
    for (const float share : {0.15f, 0.4f, 0.9f}) {
        const io::Image image = leaves(share);
        const std::vector<Pixels> mips = mipChain({&image, kSide, ColourSpace::Srgb, kCutoff});
        ASSERT_EQ(mips.size(), 9u);
        const double full = passing(mips[0], 0);
        ASSERT_GT(full, 0.05);
        for (std::size_t mip = 1; mip < mips.size(); ++mip)
            EXPECT_NEAR(passing(mips[mip], int(mip)), full, 0.03) << "mip " << mip << " of " << share;
    }
}

TEST(Mips, ManyComeInOrderAndAsOneByOne)
{
    std::vector<io::Image> images;
    for (int i = 0; i < 9; ++i)
        images.push_back(leaves(0.1f * float(i)));
    std::vector<MipRequest> requests;
    for (const io::Image& image : images)
        requests.push_back({&image, requests.size() % 2 ? kSide : kSide / 4, ColourSpace::Srgb, kCutoff});
    std::size_t next = 0;
    mipChains(requests, [&](std::size_t number, std::vector<Pixels>& mips) {
        EXPECT_EQ(number, next++);
        EXPECT_EQ(mips, mipChain(requests[number]));
    });
    EXPECT_EQ(next, requests.size());
    EXPECT_THROW(mipChains(requests, [](std::size_t, std::vector<Pixels>&) { throw std::bad_alloc{}; }), std::bad_alloc);
}

} // namespace
} // namespace renderer
