#include "io/files/level_foliage.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace io::levels {
namespace {

constexpr std::uint32_t kFewestCards = 12;   // fewer are no foliage
constexpr float kTrianglesOfCard = 16;       // more in the mean are no cards
// Lengths grow by the kept share to this power. One half would keep the cards' area; a little less, as grown cards
// also reach out of the crown's outline.
constexpr float kGrowth = 0.45f;
constexpr float kLargestCard = 0.5f;         // radius of a grown card, as a share of the crown's middle extent
constexpr float kOverhang = 0.03f;           // of the crown's size; so far a grown card may leave its box
// A card's outline moves by (growth - 1) radii; but one outline among many that cross each other, inside a crown whose
// own outline stays, is hard to see: this share of it is as visible as a solid's outline moved by that much.
constexpr float kVisible = 0.15f;

// Bits of one of three interleaved numbers (Morton order).
std::uint32_t spread(std::uint32_t v)
{
    v &= 1023;
    v = (v | v << 16) & 0x030000ff;
    v = (v | v << 8) & 0x0300f00f;
    v = (v | v << 4) & 0x030c30c3;
    return (v | v << 2) & 0x09249249;
}

std::uint32_t mirrored(std::uint32_t v) // bit 0 becomes bit 31
{
    std::uint32_t result = 0;
    for (int bit = 0; bit < 32; ++bit)
        result |= (v >> bit & 1) << (31 - bit);
    return result;
}

std::uint32_t mortonCode(const Box& box, const glm::vec3& point)
{
    const glm::vec3 size = glm::max(box.max - box.min, glm::vec3{1e-9f});
    const glm::uvec3 cell{glm::clamp((point - box.min) / size, 0.0f, 1.0f) * 1023.0f};
    return spread(cell.x) | spread(cell.y) << 1 | spread(cell.z) << 2;
}

bool canBeFoliage(const Material& material)
{
    return material.alphaMode != AlphaMode::Opaque || material.doubleSided;
}

// How far to move a box of this middle and half size so that it stays in [min, max] as well as it can.
glm::vec3 pushInside(const glm::vec3& low, const glm::vec3& high, const glm::vec3& min, const glm::vec3& max)
{
    glm::vec3 shift{0};
    for (int axis = 0; axis < 3; ++axis) {
        if (high[axis] - low[axis] > max[axis] - min[axis])
            shift[axis] = (min[axis] + max[axis] - low[axis] - high[axis]) / 2;
        else
            shift[axis] = std::max(min[axis] - low[axis], 0.0f) - std::max(high[axis] - max[axis], 0.0f);
    }
    return shift;
}

float growthFor(float share)
{
    return std::pow(share, -kGrowth);
}

} // namespace

Foliage::Foliage(const Model& model, std::span<const std::uint32_t> places)
{
    for (std::uint32_t part = 0; part < model.parts.size(); ++part)
        if (canBeFoliage(model.materials[std::size_t(model.parts[part].material)])) takePart(model, part, places);
    if (m_cards.empty()) return;
    rankCards();
    for (const Card& card : m_cards) {
        m_area += card.area;
        m_cardRadius += card.area * card.radius;
    }
    m_cardRadius /= m_area;
}

bool Foliage::holds(std::uint32_t part) const
{
    return std::find(m_parts.begin(), m_parts.end(), part) != m_parts.end();
}

void Foliage::takePart(const Model& model, std::uint32_t part, std::span<const std::uint32_t> places)
{
    const std::vector<Corners> triangles = drawnTriangles(model, part);
    const std::vector<std::uint32_t> component = componentsOf(triangles, places, Joined::AtEdges);
    const std::uint32_t cards = component.empty() ? 0 : *std::max_element(component.begin(), component.end()) + 1;
    if (cards < kFewestCards || float(triangles.size()) > kTrianglesOfCard * float(cards)) return;

    std::vector<std::vector<Corners>> sorted(cards);
    for (std::size_t i = 0; i < triangles.size(); ++i)
        sorted[component[i]].push_back(triangles[i]);
    m_parts.push_back(part);
    for (const std::vector<Corners>& one : sorted) {
        Card card{.first = std::uint32_t(m_triangles.size()), .count = std::uint32_t(one.size())};
        Box box;
        for (const Corners& corners : one) {
            const SurfaceDistance::Triangle t = positionsOf(model, corners);
            card.area += areaOf(t);
            for (const glm::vec3& corner : t)
                box.add(corner);
        }
        card.centre = (box.min + box.max) * 0.5f;
        card.radius = glm::length(box.max - box.min) / 2;
        m_crown.add(box.min);
        m_crown.add(box.max);
        m_triangles.insert(m_triangles.end(), one.begin(), one.end());
        m_cards.push_back(card);
    }
}

// Along a curve that fills the crown, taken in bit-reversed order: every first so many of the ranks lie evenly in it.
void Foliage::rankCards()
{
    std::vector<std::uint32_t> along(m_cards.size());
    std::iota(along.begin(), along.end(), 0u);
    std::vector<std::uint32_t> code;
    for (const Card& card : m_cards)
        code.push_back(mortonCode(m_crown, card.centre));
    std::stable_sort(along.begin(), along.end(), [&](std::uint32_t a, std::uint32_t b) { return code[a] < code[b]; });
    std::vector<std::uint32_t> order(m_cards.size());
    std::iota(order.begin(), order.end(), 0u);
    std::sort(order.begin(), order.end(),
              [](std::uint32_t a, std::uint32_t b) { return mirrored(a) < mirrored(b); });
    for (std::uint32_t rank = 0; rank < order.size(); ++rank)
        m_cards[along[order[rank]]].rank = rank;
}

Piece Foliage::thinned(Model& model, float share) const
{
    Piece piece;
    if (m_cards.empty()) return piece;
    const glm::vec3 size = m_crown.max - m_crown.min;
    const float middle = std::max(std::min(size.x, size.y), std::min(std::max(size.x, size.y), size.z));
    const float most = std::max(1.0f, kLargestCard * middle / std::max(m_cardRadius, 1e-9f));
    share = std::max(share, std::pow(most, -1 / kGrowth));

    std::vector<const Card*> byRank(m_cards.size());
    for (const Card& card : m_cards)
        byRank[card.rank] = &card;
    std::size_t triangles = 0, kept = 0;
    float area = 0;
    while (kept < byRank.size() && float(triangles) < share * float(m_triangles.size())) {
        triangles += byRank[kept]->count;
        area += byRank[kept]->area;
        ++kept;
    }
    const float grown = growthFor(area / m_area);
    const glm::vec3 over = size * kOverhang;
    std::vector<std::uint32_t> fresh; // of one card: vertex of the model, its grown twin beside it
    for (const Card& card : m_cards) {
        if (card.rank >= kept) continue;
        glm::vec3 low{std::numeric_limits<float>::max()}, high{std::numeric_limits<float>::lowest()};
        const auto place = [&](std::uint32_t vertex) {
            return card.centre + (model.vertices[vertex].position - card.centre) * grown;
        };
        const std::span<const Corners> own{m_triangles.data() + card.first, card.count};
        for (const Corners& corners : own)
            for (const std::uint32_t vertex : corners.vertex) {
                low = glm::min(low, place(vertex));
                high = glm::max(high, place(vertex));
            }
        const glm::vec3 shift = pushInside(low, high, m_crown.min - over, m_crown.max + over);
        fresh.clear();
        for (const Corners& corners : own) {
            Corners made = corners;
            for (std::uint32_t& vertex : made.vertex) {
                std::size_t known = 0;
                while (known < fresh.size() && fresh[known] != vertex)
                    known += 2;
                if (known == fresh.size()) {
                    fresh.insert(fresh.end(), {vertex, std::uint32_t(model.vertices.size())});
                    Vertex twin = model.vertices[vertex];
                    twin.position = place(vertex) + shift;
                    model.vertices.push_back(twin);
                }
                vertex = fresh[known + 1];
            }
            piece.triangles.push_back(made);
        }
    }
    piece.error = kVisible * (grown - 1) * m_cardRadius;
    return piece;
}

} // namespace io::levels
