#include "io/files/void_filling.h"

#include <bit>
#include <cmath>
#include <limits>

namespace io {
namespace {

constexpr int kSmoothings = 32;

// A bit for each texel of a rectangle.
class Mask {
public:
    explicit Mask(const TexelRect& rect)
        : m_low{rect.low}, m_words{(std::size_t(rect.high.x - rect.low.x) + 63) / 64}, m_bits(m_words * std::size_t(rect.high.y - rect.low.y)),
          m_counts(std::size_t(rect.high.y - rect.low.y)), m_rect{rect}
    {
    }
    bool has(int x, int z) const
    {
        const bool inside = x >= m_rect.low.x && z >= m_rect.low.y && x < m_rect.high.x && z < m_rect.high.y;
        return inside && (m_bits[word(x, z)] >> (std::size_t(x - m_low.x) & 63) & 1);
    }
    void add(int x, int z) // inside, and not there yet
    {
        m_bits[word(x, z)] |= std::uint64_t(1) << (std::size_t(x - m_low.x) & 63);
        ++m_counts[std::size_t(z - m_low.y)];
        ++m_count;
    }
    void clear()
    {
        for (std::size_t row = 0; row < m_counts.size(); ++row)
            if (std::exchange(m_counts[row], 0) > 0) std::fill_n(m_bits.begin() + std::ptrdiff_t(row * m_words), m_words, 0);
        m_count = 0;
    }
    std::size_t count() const { return m_count; }
    bool hasRow(int z) const { return z >= m_rect.low.y && z < m_rect.high.y && m_counts[std::size_t(z - m_low.y)] > 0; }
    template <class Visit> void eachOf(int z, Visit&& visit) const // visit(x) from left to right
    {
        const std::size_t first = std::size_t(z - m_low.y) * m_words;
        for (std::size_t i = 0; i < m_words; ++i)
            for (std::uint64_t bits = m_bits[first + i]; bits != 0; bits &= bits - 1)
                visit(int(m_low.x) + int(i * 64) + std::countr_zero(bits));
    }
    template <class Visit> void each(Visit&& visit) const // visit(x, z), row by row
    {
        for (int z = int(m_rect.low.y); z < m_rect.high.y; ++z)
            if (hasRow(z)) eachOf(z, [&](int x) { visit(x, z); });
    }

private:
    std::size_t word(int x, int z) const { return std::size_t(z - m_low.y) * m_words + std::size_t(x - m_low.x) / 64; }

    Texel m_low;
    std::size_t m_words; // of a row
    std::vector<std::uint64_t> m_bits;
    std::vector<int> m_counts; // of each row
    std::size_t m_count = 0;
    TexelRect m_rect;
};

// visit(x, z) for each of the eight neighbours that are on the map.
template <class Visit> void eachNeighbour(glm::ivec2 size, int x, int z, Visit&& visit)
{
    for (int row = std::max(z - 1, 0); row <= std::min(z + 1, size.y - 1); ++row)
        for (int column = std::max(x - 1, 0); column <= std::min(x + 1, size.x - 1); ++column)
            if (column != x || row != z) visit(column, row);
}

// The mean of the neighbours that heightAt(x, z) knows (not NaN).
template <class HeightAt> float meanAround(glm::ivec2 size, int x, int z, const HeightAt& heightAt)
{
    float sum = 0;
    int count = 0;
    eachNeighbour(size, x, z, [&](int column, int row) {
        const float height = heightAt(column, row);
        if (std::isnan(height)) return;
        sum += height;
        ++count;
    });
    return sum / float(count);
}

// Voids next to what is known.
Mask firstRing(const HeightMapBuilder& map)
{
    Mask ring{map.voidRect()};
    const TexelRect& rect = map.voidRect();
    for (int z = int(rect.low.y); z < rect.high.y; ++z)
        for (int x = int(rect.low.x); x < rect.high.x; ++x) {
            if (!std::isnan(map.at(x, z))) continue;
            bool known = false;
            eachNeighbour(map.size(), x, z, [&](int column, int row) { known = known || !std::isnan(map.at(column, row)); });
            if (known) ring.add(x, z);
        }
    return ring;
}

// Each takes the mean of what is around it now, not of what becomes of it: rows are kept as they were until nothing needs them.
void smooth(HeightMapBuilder& map, const Mask& filled)
{
    const TexelRect& rect = map.voidRect();
    const int low = std::max(int(rect.low.x) - 1, 0), high = std::min(int(rect.high.x) + 1, map.size().x);
    std::vector<float> above(std::size_t(high - low)), here = above;
    for (int z = int(rect.low.y); z < rect.high.y; ++z) {
        if (!filled.hasRow(z)) continue;
        std::swap(above, here);
        if (!filled.hasRow(z - 1) && z > 0) // the swapped one is another row's
            for (int x = low; x < high; ++x)
                above[std::size_t(x - low)] = map.at(x, z - 1);
        for (int x = low; x < high; ++x)
            here[std::size_t(x - low)] = map.at(x, z);
        const auto before = [&](int x, int row) { return row < z ? above[std::size_t(x - low)] : row == z ? here[std::size_t(x - low)] : map.at(x, row); };
        filled.eachOf(z, [&](int x) { map.set(x, z, meanAround(map.size(), x, z, before)); });
    }
}

} // namespace

bool fillVoids(HeightMapBuilder& map, const Progress& progress, std::string_view step)
{
    if (map.voids() == 0) return true;
    Mask ring = firstRing(map), filled{map.voidRect()}, next{map.voidRect()};
    const std::size_t total = map.voids();
    while (ring.count() > 0) {
        if (!report(progress, float(filled.count()) / float(total), step)) return false;
        const auto known = [&](int x, int z) { return ring.has(x, z) ? kVoid : map.at(x, z); };
        ring.each([&](int x, int z) { map.set(x, z, meanAround(map.size(), x, z, known)); });
        ring.each([&](int x, int z) {
            filled.add(x, z);
            eachNeighbour(map.size(), x, z, [&](int column, int row) {
                if (std::isnan(map.at(column, row)) && !next.has(column, row)) next.add(column, row);
            });
        });
        ring.clear();
        std::swap(ring, next);
    }
    for (int pass = 0; pass < kSmoothings; ++pass) {
        if (!report(progress, 1, step)) return false;
        smooth(map, filled);
    }
    return true;
}

std::optional<std::size_t> fillVoids(glm::ivec2 size, std::vector<float>& rows)
{
    HeightMapBuilder map{size};
    for (int z = 0; z < size.y; ++z)
        map.addRow({rows.data() + std::ptrdiff_t(z) * size.x, std::size_t(size.x)});
    if (map.voids() == 0) return 0;
    if (map.voids() == rows.size()) return std::nullopt;
    fillVoids(map, {}, {});
    const TexelRect filled = map.voidRect();
    for (int z = int(filled.low.y); z < filled.high.y; ++z)
        for (int x = int(filled.low.x); x < filled.high.x; ++x)
            rows[std::size_t(z) * std::size_t(size.x) + std::size_t(x)] = map.at(x, z);
    return map.voids();
}

} // namespace io
