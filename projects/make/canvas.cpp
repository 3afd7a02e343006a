#include "projects/make/canvas.h"

#include <algorithm>
#include <cmath>

namespace make {
namespace {

std::byte quantised(float value, int step)
{
    const float level = std::round(std::clamp(value, 0.0f, 1.0f) * 255 / float(step)) * float(step);
    return std::byte(std::uint8_t(std::min(level, 255.0f)));
}

io::Image blank(int side, int channels)
{
    io::Image image;
    image.size = {side, side};
    image.channels = channels;
    image.bytes.resize(std::size_t(side) * side * channels);
    return image;
}

} // namespace

glm::vec3 rgb(int hex)
{
    return glm::vec3{(hex >> 16) & 255, (hex >> 8) & 255, hex & 255} / 255.0f;
}

Canvas halved(const Canvas& canvas)
{
    Canvas half{canvas.side() / 2, {}};
    for (int y = 0; y < half.side(); ++y)
        for (int x = 0; x < half.side(); ++x) {
            Texel sum{.alpha = 0};
            for (int corner = 0; corner < 4; ++corner) {
                const Texel& from = canvas.at(2 * x + (corner & 1), 2 * y + (corner >> 1));
                sum.colour += from.colour * (from.alpha + 1e-4f);
                sum.alpha += from.alpha;
                sum.height += from.height / 8; // a texel is now twice as wide
            }
            sum.colour /= sum.alpha + 4e-4f;
            sum.alpha /= 4;
            half.at(x, y) = sum;
        }
    return half;
}

void bleedColour(Canvas& canvas)
{
    if (canvas.side() == 1) return;
    Canvas smaller = halved(canvas);
    for (int y = 0; y < smaller.side(); ++y)
        for (int x = 0; x < smaller.side(); ++x)
            smaller.at(x, y).alpha = std::min(1.0f, smaller.at(x, y).alpha * 4);
    bleedColour(smaller);
    for (int y = 0; y < canvas.side(); ++y)
        for (int x = 0; x < canvas.side(); ++x) {
            Texel& texel = canvas.at(x, y);
            texel.colour = glm::mix(smaller.at(x / 2, y / 2).colour, texel.colour, std::min(1.0f, texel.alpha * 4));
        }
}

Picture colourPicture(const Canvas& canvas, bool withAlpha, int step)
{
    const int channels = withAlpha ? 4 : 3;
    io::Image image = blank(canvas.side(), channels);
    for (int y = 0; y < canvas.side(); ++y)
        for (int x = 0; x < canvas.side(); ++x) {
            const Texel& texel = canvas.at(x, y);
            std::byte* out = image.row<std::byte>(y) + x * channels;
            for (int c = 0; c < 3; ++c)
                out[c] = quantised(texel.colour[c], step);
            if (withAlpha) out[3] = quantised(texel.alpha, 17); // 255 is a multiple; a mask asks for no more
        }
    return std::make_shared<const io::Image>(std::move(image));
}

Picture normalPicture(const Canvas& canvas, float strength, int step)
{
    const int side = canvas.side();
    io::Image image = blank(side, 3);
    const auto height = [&](int x, int y) { return canvas.at(x & (side - 1), y & (side - 1)).height; };
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) {
            const float right = height(x + 1, y) - height(x - 1, y);
            const float down = height(x, y + 1) - height(x, y - 1);
            const glm::vec3 normal = glm::normalize(glm::vec3{-right * strength, down * strength, 2});
            std::byte* out = image.row<std::byte>(y) + x * 3;
            const glm::vec3 byteNormal = normal * 127.5f + 127.5f;
            for (int c = 0; c < 2; ++c) // steps about 128, so that flat stays flat
                out[c] = std::byte(std::uint8_t(
                    std::clamp(128 + step * int(std::round((byteNormal[c] - 127.5f) / float(step))), 0, 255)));
            out[2] = quantised(normal.z * 0.5f + 0.5f, step);
        }
    return std::make_shared<const io::Image>(std::move(image));
}

} // namespace make
