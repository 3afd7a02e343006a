#include "io/files/instances_file.h"

#include <bit>
#include <cmath>
#include <concepts>
#include <cstring>
#include <zlib.h>

namespace io {
namespace {

constexpr std::string_view kMagic = "WOLDINST";
constexpr std::uint32_t kVersion = 1;
constexpr std::size_t kSummed = 16; // the checksum is of what begins there
constexpr std::size_t kHeader = 24, kTileHeader = 16, kRecord = 20, kErasedRows = kInstanceTile;
constexpr std::uint32_t kHasErased = 1; // of a tile
constexpr int kFarthestTile = 160'000;  // a little more than 1e7 m
constexpr float kLeastScale = 1e-6f, kMostScale = 1e6f;

// Little endian, whatever the machine is.
template <std::integral T> void put(std::string& out, T value)
{
    for (std::size_t i = 0; i < sizeof(T); ++i)
        out += char(std::uint64_t(value) >> (8 * i));
}

class Bytes {
public:
    explicit Bytes(std::string_view bytes) : m_bytes{bytes} {}
    std::size_t left() const { return m_bytes.size() - m_at; }
    template <std::integral T> T take() // there are as many
    {
        std::uint64_t value = 0;
        for (std::size_t i = 0; i < sizeof(T); ++i)
            value |= std::uint64_t(std::uint8_t(m_bytes[m_at + i])) << (8 * i);
        m_at += sizeof(T);
        return T(value);
    }

private:
    std::string_view m_bytes;
    std::size_t m_at = 0;
};

std::uint32_t checksum(std::string_view bytes)
{
    return std::uint32_t(crc32_z(0, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size()));
}

void put(std::string& out, const Instance& instance)
{
    put(out, instance.x);
    put(out, instance.z);
    put(out, instance.y);
    for (const std::int16_t turn : instance.rotation)
        put(out, turn);
    put(out, instance.species);
    put(out, instance.flags);
    put(out, std::bit_cast<std::uint32_t>(instance.scale));
}

Instance takeInstance(Bytes& in)
{
    Instance instance;
    instance.x = in.take<std::uint16_t>();
    instance.z = in.take<std::uint16_t>();
    instance.y = in.take<std::int32_t>();
    for (std::int16_t& turn : instance.rotation)
        turn = in.take<std::int16_t>();
    instance.species = in.take<std::uint8_t>();
    instance.flags = in.take<std::uint8_t>();
    instance.scale = std::bit_cast<float>(in.take<std::uint32_t>());
    return instance;
}

Error damaged(std::string what)
{
    return {{}, std::move(what) + "; bring the file back from a copy or from version control"};
}

// One tile, whose bytes are all there or said to be missing.
class TileReader {
public:
    TileReader(Bytes& in, std::size_t species, ReadInstances& out) : m_in{in}, m_species{species}, m_out{out} {}

    Status read()
    {
        if (m_in.left() < kTileHeader) return damaged("it ends too early");
        const int x = m_in.take<std::int32_t>(), z = m_in.take<std::int32_t>();
        const auto count = m_in.take<std::uint32_t>(), parts = m_in.take<std::uint32_t>();
        const glm::ivec2 place{x, z};
        if (std::max(std::abs(std::int64_t(x)), std::abs(std::int64_t(z))) > kFarthestTile) return damaged("a tile lies outside of the world");
        if (!m_out.tiles.empty() && !TileOrder{}(std::prev(m_out.tiles.end())->first, place)) return damaged("its tiles are out of order");
        if (parts > kHasErased) return damaged("a tile has parts that this version does not know");
        if (m_in.left() < count * std::uint64_t(kRecord) + (parts ? kErasedRows * 8 : 0)) return damaged("it ends too early");
        InstanceTile tile;
        tile.instances.reserve(count);
        for (std::uint32_t i = 0; i < count; ++i) {
            const Instance instance = takeInstance(m_in);
            if (!(instance.scale >= kLeastScale && instance.scale <= kMostScale)) return damaged("an instance has an impossible scale");
            if (instance.species < m_species) tile.instances.push_back(instance);
            else ++m_out.strangers;
        }
        for (std::size_t row = 0; parts && row < kErasedRows; ++row)
            tile.erased.push_back(m_in.take<std::uint64_t>());
        if (!tile.empty()) m_out.tiles.emplace_hint(m_out.tiles.end(), place, std::make_shared<const InstanceTile>(std::move(tile)));
        return {};
    }

private:
    Bytes& m_in;
    std::size_t m_species;
    ReadInstances& m_out;
};

} // namespace

std::string instancesFile(std::string_view sceneFile, ScatterId layer)
{
    constexpr std::string_view kEnding = ".scene.json";
    if (sceneFile.ends_with(kEnding)) sceneFile.remove_suffix(kEnding.size());
    return std::string{sceneFile} + "." + std::to_string(number(layer)) + ".scatter";
}

std::string encodeInstances(const InstanceTiles& tiles)
{
    std::string body;
    body.reserve(8 + tiles.size() * kTileHeader + instanceCount(tiles) * kRecord);
    put(body, std::uint32_t(tiles.size()));
    put(body, std::uint32_t(instanceCount(tiles)));
    for (const auto& [place, tile] : tiles) {
        put(body, std::int32_t(place.x));
        put(body, std::int32_t(place.y));
        put(body, std::uint32_t(tile->instances.size()));
        put(body, tile->erased.empty() ? 0u : kHasErased);
        for (const Instance& instance : tile->instances)
            put(body, instance);
        for (const std::uint64_t row : tile->erased)
            put(body, row);
    }
    std::string bytes{kMagic};
    bytes.reserve(kSummed + body.size());
    put(bytes, kVersion);
    put(bytes, checksum(body));
    return bytes += body;
}

Result<ReadInstances> decodeInstances(std::string_view bytes, std::size_t species)
{
    if (bytes.size() < kHeader || !bytes.starts_with(kMagic)) return damaged("is no file of instances, or is cut off");
    Bytes in{bytes.substr(kMagic.size())};
    if (const auto version = in.take<std::uint32_t>(); version != kVersion)
        return Error{{}, "version " + std::to_string(version) + " was written by a newer Wold; this one reads " + std::to_string(kVersion) + ": update Wold"};
    if (in.take<std::uint32_t>() != checksum(bytes.substr(kSummed))) return damaged("its bytes are not those that were written");
    const auto tiles = in.take<std::uint32_t>(), instances = in.take<std::uint32_t>();
    ReadInstances read;
    TileReader reader{in, species, read};
    for (std::uint32_t i = 0; i < tiles; ++i)
        if (const Status tile = reader.read(); !tile) return tile.error();
    if (in.left() > 0) return damaged("there is more in it than its tiles");
    if (instanceCount(read.tiles) + read.strangers != instances) return damaged("it does not hold as many instances as it says");
    return read;
}

} // namespace io
