#include "tests/gl/support/test_world.h"

#include <array>
#include <fstream>

// Enough of PNG to look at a picture: stored, not compressed.
namespace test {
namespace {

std::uint32_t crc(std::string_view bytes)
{
    std::uint32_t c = 0xffffffffu;
    for (const char byte : bytes) {
        c ^= std::uint8_t(byte);
        for (int bit = 0; bit < 8; ++bit)
            c = c & 1 ? 0xedb88320u ^ (c >> 1) : c >> 1;
    }
    return ~c;
}

std::string big(std::uint32_t v)
{
    return {char(v >> 24), char(v >> 16), char(v >> 8), char(v)};
}

std::string chunk(std::string_view name, const std::string& data)
{
    const std::string body = std::string{name} + data;
    return big(std::uint32_t(data.size())) + body + big(crc(body));
}

std::string stored(const std::string& raw)
{
    std::string out{"\x78\x01", 2};
    std::uint32_t a = 1, b = 0;
    for (std::size_t at = 0; at < raw.size(); at += 65535) {
        const std::string part = raw.substr(at, 65535);
        const auto n = std::uint16_t(part.size());
        out += char(at + 65535 >= raw.size());
        out += {char(n), char(n >> 8), char(~n), char(~n >> 8)};
        out += part;
    }
    for (const char c : raw) {
        a = (a + std::uint8_t(c)) % 65521;
        b = (b + a) % 65521;
    }
    return out + big(b << 16 | a);
}

} // namespace

void writePng(const std::string& file, const io::Image& image)
{
    std::string raw;
    for (int y = 0; y < image.size.y; ++y) {
        raw += '\0';
        raw.append(reinterpret_cast<const char*>(image.bytes.data() + image.rowBytes() * std::size_t(y)), image.rowBytes());
    }
    const std::string header = big(std::uint32_t(image.size.x)) + big(std::uint32_t(image.size.y)) +
                               std::string{8, image.channels == 4 ? '\6' : '\2', 0, 0, 0};
    std::ofstream{file, std::ios::binary} << "\x89PNG\r\n\x1a\n" << chunk("IHDR", header) << chunk("IDAT", stored(raw)) << chunk("IEND", "");
}

} // namespace test
