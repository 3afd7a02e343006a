#include "renderer/pixels.h"

#include "renderer/shaders/shared/material.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <thread>

namespace renderer {
namespace {

using Plane = std::vector<glm::vec4>; // linear; colour times alpha where a cutoff asks for it

float decode(float c)
{
    return c <= 0.04045f ? c / 12.92f : std::pow((c + 0.055f) / 1.055f, 2.4f);
}

const std::array<float, 256>& decodeTable()
{
    static const auto table = [] {
        std::array<float, 256> values{};
        for (int i = 0; i < 256; ++i)
            values[std::size_t(i)] = decode(float(i) / 255);
        return values;
    }();
    return table;
}

// Colours are stored as square roots of light, not as sRGB: shaders undo that with one product after filtering, and
// software GL filters plain bytes several times faster than sRGB ones. The steps are about as fine.
std::uint8_t encodeByte(float c)
{
    return std::uint8_t(std::sqrt(std::clamp(c, 0.0f, 1.0f)) * 255 + 0.5f);
}

float channel(const io::Image& image, int x, int y, int c, bool srgb)
{
    const std::size_t at = std::size_t(x) * image.channels + c;
    switch (image.type) {
    case io::PixelType::U8: {
        const std::uint8_t v = image.row<std::uint8_t>(y)[at];
        return srgb ? decodeTable()[v] : float(v) / 255;
    }
    case io::PixelType::U16: {
        const float v = float(image.row<std::uint16_t>(y)[at]) / 65535;
        return srgb ? decode(v) : v;
    }
    case io::PixelType::F32: { // floats are linear already
        const float v = image.row<float>(y)[at];
        return std::isfinite(v) ? std::clamp(v, 0.0f, 1.0f) : 0.0f;
    }
    }
    return 0;
}

// The common case, by table: eight bits, three or four channels.
bool isBytes(const io::Image& image)
{
    return image.type == io::PixelType::U8 && image.channels >= 3;
}

class ByteTexels {
public:
    ByteTexels(const io::Image& image, bool srgb) : m_image{image}, m_colour{srgb ? decodeTable() : linear()} {}

    glm::vec4 at(const std::uint8_t* from) const
    {
        return {m_colour[from[0]], m_colour[from[1]], m_colour[from[2]], m_image.channels == 4 ? linear()[from[3]] : 1.0f};
    }
    const std::uint8_t* row(int y) const { return m_image.row<std::uint8_t>(y); }
    int channels() const { return m_image.channels; }
    glm::ivec2 size() const { return m_image.size; }

private:
    static const std::array<float, 256>& linear()
    {
        static const auto table = [] {
            std::array<float, 256> values{};
            for (int i = 0; i < 256; ++i)
                values[std::size_t(i)] = float(i) / 255;
            return values;
        }();
        return table;
    }

    const io::Image& m_image;
    const std::array<float, 256>& m_colour;
};

Plane planeOfBytes(const ByteTexels& texels)
{
    Plane plane(std::size_t(texels.size().x) * texels.size().y);
    const std::uint8_t* from = texels.row(0);
    for (glm::vec4& texel : plane) {
        texel = texels.at(from);
        from += texels.channels();
    }
    return plane;
}

Plane planeOf(const io::Image& image, ColourSpace space)
{
    if (isBytes(image)) return planeOfBytes({image, space == ColourSpace::Srgb});
    const bool srgb = space == ColourSpace::Srgb;
    const bool grey = image.channels < 3;
    const bool alpha = image.channels == 2 || image.channels == 4;
    Plane plane(std::size_t(image.size.x) * image.size.y);
    for (int y = 0; y < image.size.y; ++y)
        for (int x = 0; x < image.size.x; ++x) {
            glm::vec4& texel = plane[std::size_t(y) * image.size.x + x];
            for (int c = 0; c < 3; ++c)
                texel[c] = channel(image, x, y, grey ? 0 : c, srgb);
            texel.w = alpha ? channel(image, x, y, image.channels - 1, false) : 1.0f;
        }
    return plane;
}

glm::vec4 weighedByAlpha(const glm::vec4& texel)
{
    const float weight = std::max(texel.w, 1 / 512.0f); // fully clear texels keep a trace of their colour
    return {glm::vec3{texel} * weight, texel.w};
}

Plane halved(const Plane& from, glm::ivec2 size)
{
    const glm::ivec2 to = glm::max(size / 2, glm::ivec2{1});
    Plane result(std::size_t(to.x) * to.y);
    for (int y = 0; y < to.y; ++y)
        for (int x = 0; x < to.x; ++x) {
            const int x0 = std::min(2 * x, size.x - 1), x1 = std::min(2 * x + 1, size.x - 1);
            const std::size_t row0 = std::size_t(std::min(2 * y, size.y - 1)) * size.x;
            const std::size_t row1 = std::size_t(std::min(2 * y + 1, size.y - 1)) * size.x;
            result[std::size_t(y) * to.x + x] = (from[row0 + x0] + from[row0 + x1] + from[row1 + x0] + from[row1 + x1]) * 0.25f;
        }
    return result;
}

// halved(planeOfBytes(…)) of a square with an even side, without the large plane between.
Plane halvedBytes(const ByteTexels& texels, bool weighed)
{
    const int side = texels.size().x / 2;
    const int channels = texels.channels();
    Plane result(std::size_t(side) * side);
    glm::vec4* to = result.data();
    for (int y = 0; y < side; ++y) {
        const std::uint8_t* row0 = texels.row(2 * y);
        const std::uint8_t* row1 = texels.row(2 * y + 1);
        for (int x = 0; x < side; ++x, row0 += 2 * channels, row1 += 2 * channels) {
            glm::vec4 sum{0};
            for (const std::uint8_t* from : {row0, row0 + channels, row1, row1 + channels})
                sum += weighed ? weighedByAlpha(texels.at(from)) : texels.at(from);
            *to++ = sum * 0.25f;
        }
    }
    return result;
}

// Bilinear; the caller has halved until it is within a factor of two.
Plane resized(const Plane& from, glm::ivec2 size, int side)
{
    Plane result(std::size_t(side) * side);
    const glm::vec2 scale = glm::vec2{size} / float(side);
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) {
            const glm::vec2 at = glm::max((glm::vec2{x, y} + 0.5f) * scale - 0.5f, glm::vec2{0});
            const glm::ivec2 low = glm::min(glm::ivec2{at}, size - 1);
            const glm::ivec2 high = glm::min(low + 1, size - 1);
            const glm::vec2 f = at - glm::vec2{low};
            const auto texel = [&](int tx, int ty) { return from[std::size_t(ty) * size.x + tx]; };
            result[std::size_t(y) * side + x] = glm::mix(glm::mix(texel(low.x, low.y), texel(high.x, low.y), f.x),
                                                         glm::mix(texel(low.x, high.y), texel(high.x, high.y), f.x), f.y);
        }
    return result;
}

float passing(const ByteTexels& texels, float cutoff)
{
    if (texels.channels() < 4) return 1;
    const std::size_t count = std::size_t(texels.size().x) * texels.size().y;
    const std::uint8_t* alpha = texels.row(0) + 3;
    std::size_t passed = 0;
    for (std::size_t i = 0; i < count; ++i)
        passed += float(alpha[i * 4]) / 255 >= cutoff;
    return float(passed) / float(count);
}

float passing(const Plane& plane, float cutoff)
{
    const auto count = std::ranges::count_if(plane, [&](const glm::vec4& t) { return t.w >= cutoff; });
    return float(count) / float(plane.size());
}

// The factor on alpha with which `share` of the texels pass: where there is one threshold, by their order.
float factorByRank(std::vector<float> alphas, float share, float cutoff)
{
    constexpr std::size_t kFewest = 16; // texels; of fewer none stands for a share
    if (alphas.size() < kFewest) return 1;
    const auto rank = alphas.begin() + std::ptrdiff_t((1 - share) * float(alphas.size() - 1));
    std::ranges::nth_element(alphas, rank);
    return *rank > 1e-3f ? std::clamp(cutoff / *rank, 0.5f, 4.0f) : 1.0f;
}

// The same where thresholds lie within `spread` around the cutoff: with which the mean of the chances to pass is the share.
float factorByChance(const std::vector<float>& alphas, float share, float cutoff, float spread)
{
    float low = 0.25f, high = 16;
    for (int step = 0; step < 12; ++step) {
        const float factor = std::sqrt(low * high);
        float passing = 0;
        for (const float alpha : alphas)
            passing += std::clamp((std::min(alpha * factor, 1.0f) - cutoff) / spread + 0.5f, 0.0f, 1.0f);
        (passing < share * float(alphas.size()) ? low : high) = factor;
    }
    return std::sqrt(low * high);
}

float alphaFactor(const Plane& plane, float share, float cutoff, float mip)
{
    if (share <= 0 || share >= 1) return 1;
    std::vector<float> alphas(plane.size());
    std::ranges::transform(plane, alphas.begin(), [](const glm::vec4& t) { return t.w; });
    const float spread = glsl::cutoutSpread(mip, cutoff);
    return spread > 0 ? factorByChance(alphas, share, cutoff, spread) : factorByRank(std::move(alphas), share, cutoff);
}

Pixels bytesOf(const Plane& plane, ColourSpace space, bool weighed, float alphaScale)
{
    Pixels pixels(plane.size());
    for (std::size_t i = 0; i < plane.size(); ++i) {
        glm::vec4 texel = plane[i];
        if (weighed) texel = {glm::vec3{texel} / std::max(texel.w, 1 / 512.0f), texel.w * alphaScale};
        for (int c = 0; c < 3; ++c)
            pixels[i][c] = space == ColourSpace::Srgb ? encodeByte(texel[c])
                                                      : std::uint8_t(std::clamp(texel[c], 0.0f, 1.0f) * 255 + 0.5f);
        pixels[i].w = std::uint8_t(std::clamp(texel.w, 0.0f, 1.0f) * 255 + 0.5f);
    }
    return pixels;
}

// What bytesOf() makes of a plane that was not changed.
Pixels recoded(const io::Image& image, ColourSpace space)
{
    static const auto roots = [] {
        std::array<std::uint8_t, 256> values{};
        for (std::size_t i = 0; i < values.size(); ++i)
            values[i] = encodeByte(decodeTable()[i]);
        return values;
    }();
    const auto* from = reinterpret_cast<const std::uint8_t*>(image.bytes.data());
    Pixels pixels(std::size_t(image.size.x) * image.size.y);
    for (glm::u8vec4& texel : pixels) {
        texel = {from[0], from[1], from[2], image.channels == 4 ? from[3] : std::uint8_t(255)};
        if (space == ColourSpace::Srgb) texel = {roots[texel.x], roots[texel.y], roots[texel.z], texel.w};
        from += image.channels;
    }
    return pixels;
}

// The mips below the largest, from the plane of the second on. `share` of the texels pass the cutoff.
void addSmaller(std::vector<Pixels>& mips, Plane plane, const MipRequest& request, float share)
{
    const bool cut = request.alphaCutoff >= 0;
    for (int side = request.side / 2;; side /= 2) {
        const float factor = cut ? alphaFactor(plane, share, request.alphaCutoff, float(mips.size())) : 1;
        mips.push_back(bytesOf(plane, request.space, cut, factor));
        if (side == 1) return;
        plane = halved(plane, glm::ivec2{side});
    }
}

// Chains made out of order and taken in order. Makers stay `ahead` of what was taken: mips are large.
class MipQueue {
public:
    MipQueue(std::span<const MipRequest> requests, std::size_t ahead)
        : m_requests{requests}, m_made(requests.size()), m_ahead{ahead}, m_end{requests.size()}
    {
    }

    void makeAll() // what is left, on a thread of its own
    {
        std::unique_lock lock{m_mutex};
        for (;;) {
            m_changed.wait(lock, [&] { return m_next >= m_end || mayMake(); });
            if (m_next >= m_end) return;
            makeNext(lock);
        }
    }
    std::vector<Pixels> get() // the next in order; makes others while it would wait
    {
        std::unique_lock lock{m_mutex};
        while (m_made[m_taken].empty()) {
            if (m_fault) std::rethrow_exception(m_fault);
            if (mayMake())
                makeNext(lock);
            else
                m_changed.wait(lock);
        }
        std::vector<Pixels> mips = std::move(m_made[m_taken++]);
        m_changed.notify_all();
        return mips;
    }
    void close() // makers stop
    {
        const std::lock_guard lock{m_mutex};
        m_end = 0;
        m_changed.notify_all();
    }

private:
    bool mayMake() const { return m_next < std::min(m_taken + m_ahead, m_end); }
    void makeNext(std::unique_lock<std::mutex>& lock)
    {
        const std::size_t number = m_next++;
        lock.unlock();
        std::vector<Pixels> mips;
        std::exception_ptr fault; // want of memory is told by get(), not died of here
        try {
            mips = mipChain(m_requests[number]);
        } catch (...) {
            fault = std::current_exception();
        }
        lock.lock();
        if (fault) m_fault = fault;
        m_made[number] = std::move(mips);
        m_changed.notify_all();
    }

    std::span<const MipRequest> m_requests;
    std::vector<std::vector<Pixels>> m_made;
    std::size_t m_ahead, m_end, m_next = 0, m_taken = 0;
    std::exception_ptr m_fault;
    std::mutex m_mutex;
    std::condition_variable m_changed;
};

} // namespace

int textureSide(glm::ivec2 size, int largest)
{
    const unsigned longest = unsigned(std::max({size.x, size.y, 1}));
    return int(std::min(std::bit_ceil(longest), unsigned(largest)));
}

std::vector<Pixels> mipChain(const MipRequest& request)
{
    const auto& [source, side, space, alphaCutoff] = request;
    const io::Image& image = *source;
    const bool cut = alphaCutoff >= 0;
    if (isBytes(image) && image.size == glm::ivec2{side} && side > 1) { // of most textures the largest mip is as it is
        const ByteTexels texels{image, space == ColourSpace::Srgb};
        std::vector<Pixels> mips{recoded(image, space)};
        addSmaller(mips, halvedBytes(texels, cut), request, cut ? passing(texels, alphaCutoff) : 0);
        return mips;
    }
    Plane plane = planeOf(image, space);
    if (cut) std::ranges::transform(plane, plane.begin(), weighedByAlpha);
    glm::ivec2 size = image.size;
    while (size.x >= 2 * side && size.y >= 2 * side) {
        plane = halved(plane, size);
        size = glm::max(size / 2, glm::ivec2{1});
    }
    if (size != glm::ivec2{side}) plane = resized(plane, size, side);

    std::vector<Pixels> mips{bytesOf(plane, space, cut, 1)};
    if (side > 1) addSmaller(mips, halved(plane, glm::ivec2{side}), request, cut ? passing(plane, alphaCutoff) : 0);
    return mips;
}

void mipChains(std::span<const MipRequest> requests,
               const std::function<void(std::size_t, std::vector<Pixels>&)>& take)
{
    const std::size_t threads = std::max(1u, std::thread::hardware_concurrency());
    MipQueue queue{requests, threads + 1};
    std::vector<std::jthread> others;
    for (std::size_t i = 1; i < std::min(threads, requests.size()); ++i)
        others.emplace_back([&] { queue.makeAll(); });
    try {
        for (std::size_t i = 0; i < requests.size(); ++i) {
            std::vector<Pixels> mips = queue.get();
            take(i, mips);
        }
    } catch (...) {
        queue.close();
        throw;
    }
}

io::Image checkerboard()
{
    constexpr int kSide = 64;
    io::Image image{.size = {kSide, kSide}, .channels = 4, .type = io::PixelType::U8};
    image.bytes.resize(std::size_t(kSide) * kSide * 4);
    for (int y = 0; y < kSide; ++y)
        for (int x = 0; x < kSide; ++x) {
            const bool light = ((x / 8) ^ (y / 8)) & 1;
            const glm::u8vec4 texel = light ? glm::u8vec4{230, 60, 210, 255} : glm::u8vec4{40, 40, 44, 255};
            image.row<glm::u8vec4>(y)[x] = texel;
        }
    return image;
}

} // namespace renderer
