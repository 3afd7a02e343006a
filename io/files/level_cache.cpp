#include "io/files/level_cache.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <fmt/format.h>
#include <meshoptimizer.h>

namespace io::levels {
namespace {

constexpr char kMagic[8] = {'W', 'O', 'L', 'D', 'L', 'V', 'L', 'S'};
constexpr std::uint32_t kFormat = 1;
constexpr std::uint32_t kAlgorithm = 3; // counts up with every change of what makeLevels makes
constexpr std::uint32_t kMostLevels = 16;

struct Header {
    char magic[8];
    std::uint32_t format;
    std::uint32_t levels;
    Key key;
    std::uint32_t order, added, indices, unused; // counts
    Key checksum;                                // of all that follows
};
struct LevelHeader {
    float error;
    std::uint32_t indices, parts;
};
struct PartHeader {
    std::uint32_t firstIndex, indexCount;
    std::int32_t material;
};
static_assert(sizeof(Header) == 64 && sizeof(LevelHeader) == 12 && sizeof(PartHeader) == 12 && sizeof(Vertex) == 60,
              "written as bytes: no padding");

template <class T> void put(std::string& bytes, const T* values, std::size_t count)
{
    bytes.append(reinterpret_cast<const char*>(values), count * sizeof(T));
}

class Reader {
public:
    explicit Reader(std::string_view bytes) : m_rest{bytes} {}
    template <class T> bool read(T* values, std::size_t count)
    {
        if (count > m_rest.size() / sizeof(T)) return false;
        if (count > 0) std::memcpy(static_cast<void*>(values), m_rest.data(), count * sizeof(T));
        m_rest.remove_prefix(count * sizeof(T));
        return true;
    }
    template <class T> bool read(std::vector<T>& values, std::size_t count)
    {
        if (count > m_rest.size() / sizeof(T)) return false; // before the memory is asked for
        values.resize(count);
        return read(values.data(), count);
    }
    std::string_view rest() const { return m_rest; }

private:
    std::string_view m_rest;
};

bool allBelow(const std::vector<std::uint32_t>& numbers, std::size_t limit)
{
    return std::all_of(numbers.begin(), numbers.end(), [limit](std::uint32_t number) { return number < limit; });
}

bool sound(const Vertex& vertex)
{
    const auto* numbers = &vertex.position.x;
    return std::all_of(numbers, numbers + 3, [](float number) { return std::isfinite(number); });
}

bool readParts(Reader& reader, Level& level, std::uint32_t count, const Model& model)
{
    std::uint32_t next = 0; // parts follow each other without a gap
    for (std::uint32_t i = 0; i < count; ++i) {
        PartHeader part;
        if (!reader.read(&part, 1)) return false;
        const bool fits = part.firstIndex == next && part.indexCount > 0 && part.indexCount % 3 == 0 &&
                          part.indexCount <= level.indices.size() - next;
        if (!fits || part.material < 0 || std::size_t(part.material) >= model.materials.size()) return false;
        next += part.indexCount;
        level.parts.push_back({part.firstIndex, part.indexCount, part.material});
    }
    return next == level.indices.size();
}

bool readLevel(Reader& reader, Made& made, const Model& model)
{
    LevelHeader header;
    if (!reader.read(&header, 1)) return false;
    const float before = made.levels.empty() ? 0 : made.levels.back().error;
    if (!std::isfinite(header.error) || header.error <= before || header.indices > model.indices.size()) return false;
    Level level{.error = header.error};
    if (header.parts > model.parts.size() || !reader.read(level.indices, header.indices)) return false;
    if (!allBelow(level.indices, made.order.size() + made.added.size())) return false;
    if (!readParts(reader, level, header.parts, model)) return false;
    made.levels.push_back(std::move(level));
    return true;
}

} // namespace

Key keyOf(const Model& model)
{
    ContentHash hash;
    hash.add(kAlgorithm);
    hash.add(std::uint32_t(MESHOPTIMIZER_VERSION));
    hash.add(model.vertices);
    hash.add(model.indices);
    for (const Part& part : model.parts) {
        const Material& material = model.materials[std::size_t(part.material)];
        hash.add(part.firstIndex);
        hash.add(part.indexCount);
        hash.add(part.material);
        hash.add(material.alphaMode);
        hash.add(std::uint8_t(material.doubleSided));
    }
    return hash.key();
}

std::string fileName(const Key& key)
{
    return fmt::format("{:016x}{:016x}.levels", key[0], key[1]);
}

std::string encode(const Key& key, const Made& made)
{
    Header header{.format = kFormat,
                  .levels = std::uint32_t(made.levels.size()),
                  .key = key,
                  .order = std::uint32_t(made.order.size()),
                  .added = std::uint32_t(made.added.size()),
                  .indices = std::uint32_t(made.indices.size())};
    std::memcpy(header.magic, kMagic, sizeof kMagic);
    std::string bytes(sizeof header, '\0');
    put(bytes, made.order.data(), made.order.size());
    put(bytes, made.added.data(), made.added.size());
    put(bytes, made.indices.data(), made.indices.size());
    for (const Level& level : made.levels) {
        const LevelHeader own{level.error, std::uint32_t(level.indices.size()), std::uint32_t(level.parts.size())};
        put(bytes, &own, 1);
        put(bytes, level.indices.data(), level.indices.size());
        for (const Part& part : level.parts) {
            const PartHeader range{part.firstIndex, part.indexCount, part.material};
            put(bytes, &range, 1);
        }
    }
    header.checksum = contentKey(std::string_view{bytes}.substr(sizeof header));
    std::memcpy(bytes.data(), &header, sizeof header);
    return bytes;
}

std::optional<Made> decode(std::string_view bytes, const Key& key, const Model& model)
{
    Reader reader{bytes};
    Header header;
    if (!reader.read(&header, 1) || std::memcmp(header.magic, kMagic, sizeof kMagic) != 0) return {};
    if (header.format != kFormat || header.key != key || header.checksum != contentKey(reader.rest())) return {};
    if (header.levels > kMostLevels || header.indices != model.indices.size()) return {};
    if (header.order > model.vertices.size()) return {};
    Made made;
    if (!reader.read(made.order, header.order) || !allBelow(made.order, model.vertices.size())) return {};
    if (!reader.read(made.added, header.added) || !std::all_of(made.added.begin(), made.added.end(), sound)) return {};
    if (!reader.read(made.indices, header.indices) || !allBelow(made.indices, made.order.size())) return {};
    for (std::uint32_t i = 0; i < header.levels; ++i)
        if (!readLevel(reader, made, model)) return {};
    if (!reader.rest().empty()) return {};
    return made;
}

void apply(Made made, Model& model)
{
    std::vector<Vertex> vertices;
    vertices.reserve(made.order.size() + made.added.size());
    for (const std::uint32_t old : made.order)
        vertices.push_back(model.vertices[old]);
    vertices.insert(vertices.end(), made.added.begin(), made.added.end());
    model.vertices = std::move(vertices);
    model.indices = std::move(made.indices);
    model.levels = std::move(made.levels);
}

} // namespace io::levels
