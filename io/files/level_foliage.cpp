#include "io/files/level_foliage.h"

#include <algorithm>
#include <cmath>
#include <meshoptimizer.h>
#include <numeric>

namespace io::levels {
namespace {

constexpr std::uint32_t kFewestCards = 12;   // fewer are no foliage
constexpr float kTrianglesOfCard = 16;       // more in the mean are no cards
constexpr float kGrowth = 0.5f;              // lengths that grow by the kept share to this power keep the cards' area
constexpr float kSparser = 0.12f;            // so much less of the power: a crown is many leaves deep, and stays full
constexpr float kStraightened = 0.02f;       // of the crown's size; so far a simpler card may stray
constexpr std::size_t kSpreadCards = 4000;    // the way that spreads best takes the square of the cards
constexpr float kPulled = 0.75f;             // of what a card at the outline grew outwards, it moves inwards
constexpr float kWorthwhile = 0.8f;          // simpler cards have at most this share of the triangles
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

// The card as two triangles, or as few as it lets.
std::vector<Corners> straightened(const Model& model, const std::vector<Corners>& card)
{
    if (card.size() <= 2) return card;
    std::vector<std::uint32_t> indices, vertexOf;
    std::vector<glm::vec3> positions;
    for (const Corners& corners : card)
        for (const std::uint32_t vertex : corners.vertex) {
            const auto known = std::find(vertexOf.begin(), vertexOf.end(), vertex);
            indices.push_back(std::uint32_t(known - vertexOf.begin()));
            if (known != vertexOf.end()) continue;
            vertexOf.push_back(vertex);
            positions.push_back(model.vertices[vertex].position);
        }
    std::vector<std::uint32_t> made(indices.size());
    const std::size_t count = meshopt_simplify(made.data(), indices.data(), indices.size(), &positions[0].x,
                                               positions.size(), sizeof(glm::vec3), 6, 1.0f, 0, nullptr);
    std::vector<Corners> result;
    for (std::size_t i = 0; i + 2 < count; i += 3)
        result.push_back({{vertexOf[made[i]], vertexOf[made[i + 1]], vertexOf[made[i + 2]]}, card[0].part});
    return result;
}

// The farthest that a corner of the full card lies from the simple one, in m.
float strayed(const Model& model, const std::vector<Corners>& full, const std::vector<Corners>& simple)
{
    float farthest = 0;
    for (const Corners& corners : full)
        for (const glm::vec3& corner : positionsOf(model, corners)) {
            float nearest = std::numeric_limits<float>::max();
            for (const Corners& own : simple)
                nearest = std::min(nearest, squaredDistance(positionsOf(model, own), corner));
            farthest = std::max(farthest, nearest);
        }
    return std::sqrt(farthest);
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
    simplifyCards(model);
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

    m_parts.push_back(part);
    const std::size_t before = m_cards.size();
    m_cards.resize(before + cards);
    for (std::size_t i = 0; i < triangles.size(); ++i)
        m_cards[before + component[i]].full.push_back(triangles[i]);
    for (Card& card : std::span{m_cards}.subspan(before)) {
        Box box;
        for (const Corners& corners : card.full) {
            const SurfaceDistance::Triangle t = positionsOf(model, corners);
            card.area += areaOf(t);
            for (const glm::vec3& corner : t)
                box.add(corner);
        }
        card.centre = box.centre();
        card.radius = glm::length(box.size()) / 2;
        m_crown.add(box);
    }
    m_full += triangles.size();
}

void Foliage::simplifyCards(const Model& model)
{
    const glm::vec3 size = m_crown.size();
    const float farthest = kStraightened * std::max({size.x, size.y, size.z});
    for (Card& card : m_cards) {
        card.simple = straightened(model, card.full);
        const float error = card.simple.empty() ? farthest * 2 : strayed(model, card.full, card.simple);
        if (error > farthest)
            card.simple = card.full;
        else
            m_simpleError = std::max(m_simpleError, error);
        m_simple += card.simple.size();
    }
}

void Foliage::rankCards()
{
    if (m_cards.size() <= kSpreadCards)
        spreadCards();
    else
        sortCards();
}

// Each next one is the farthest from those before (farthest point sampling, Gonzalez 1985), which begins at the crown's
// tips: its outline stays.
void Foliage::spreadCards()
{
    std::vector<float> distance(m_cards.size(), std::numeric_limits<float>::max());
    std::vector<bool> taken(m_cards.size());
    glm::vec3 last = m_crown.centre();
    for (std::uint32_t rank = 0; rank < m_cards.size(); ++rank) {
        std::size_t farthest = m_cards.size();
        for (std::size_t i = 0; i < m_cards.size(); ++i) {
            if (taken[i]) continue;
            const glm::vec3 way = m_cards[i].centre - last;
            distance[i] = rank == 1 ? glm::dot(way, way) : std::min(distance[i], glm::dot(way, way));
            if (farthest == m_cards.size() || distance[i] > distance[farthest]) farthest = i;
        }
        taken[farthest] = true;
        m_cards[farthest].rank = rank;
        last = m_cards[farthest].centre;
    }
}

// Along a curve that fills the crown, taken in bit-reversed order: every first so many of the ranks lie evenly in it.
void Foliage::sortCards()
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
    const glm::vec3 size = m_crown.size();
    const float middle = std::max(std::min(size.x, size.y), std::min(std::max(size.x, size.y), size.z));
    const float most = std::max(1.0f, kLargestCard * middle / std::max(m_cardRadius, 1e-9f));
    const bool simple = float(m_simple) <= kWorthwhile * float(m_full);
    const float all = float(simple ? m_simple : m_full);
    const float triangles = std::max(share * float(m_full), all * std::pow(most, -1 / kGrowth));

    std::vector<const Card*> byRank(m_cards.size());
    for (const Card& card : m_cards)
        byRank[card.rank] = &card;
    std::size_t count = 0, kept = 0;
    float area = 0;
    while (kept < byRank.size() && float(count) < triangles) {
        count += simple ? byRank[kept]->simple.size() : byRank[kept]->full.size();
        area += byRank[kept]->area;
        ++kept;
    }
    const float grown = kept == byRank.size() ? 1.0f : std::pow(area / m_area, kSparser - kGrowth);
    for (const Card& card : m_cards)
        if (card.rank < kept) grow(model, card, simple ? card.simple : card.full, grown, piece);
    const float seen = kept == byRank.size() ? 1.0f : growthFor(area / m_area); // as if all of the area were kept
    piece.error = kVisible * (seen - 1) * m_cardRadius + (simple ? m_simpleError : 0);
    return piece;
}

// About its centre, but near the crown's outline inwards from its outer end, so that the outline stays.
void Foliage::grow(Model& model, const Card& card, std::span<const Corners> triangles, float grown, Piece& piece) const
{
    if (grown == 1) {
        piece.triangles.insert(piece.triangles.end(), triangles.begin(), triangles.end());
        return;
    }
    const glm::vec3 out = (card.centre - m_crown.centre()) / glm::max(m_crown.size() * 0.5f, glm::vec3{1e-9f});
    const float outward = std::min(glm::length(out), 1.0f); // 0 in the middle of the crown, 1 at its outline
    const glm::vec3 from = card.centre - m_crown.centre();
    const glm::vec3 direction = from / std::max(glm::length(from), 1e-9f);
    glm::vec3 low{std::numeric_limits<float>::max()}, high{std::numeric_limits<float>::lowest()};
    float reach = 0; // m, of the card outwards from its centre
    for (const Corners& corners : card.full)
        for (const std::uint32_t vertex : corners.vertex) {
            const glm::vec3 arm = model.vertices[vertex].position - card.centre;
            reach = std::max(reach, glm::dot(arm, direction));
            low = glm::min(low, arm * grown);
            high = glm::max(high, arm * grown);
        }
    const glm::vec3 over = m_crown.size() * kOverhang;
    glm::vec3 centre = card.centre - direction * (reach * (grown - 1) * outward * kPulled);
    centre += pushInside(centre + low, centre + high, m_crown.min - over, m_crown.max + over);

    std::vector<std::array<std::uint32_t, 2>> twins; // vertex of the model, its grown twin
    for (Corners corners : triangles) {
        for (std::uint32_t& vertex : corners.vertex) {
            auto known = std::find_if(twins.begin(), twins.end(), [&](const auto& twin) { return twin[0] == vertex; });
            if (known == twins.end()) {
                twins.push_back({vertex, std::uint32_t(model.vertices.size())});
                known = twins.end() - 1;
                Vertex twin = model.vertices[vertex];
                twin.position = centre + (twin.position - card.centre) * grown;
                model.vertices.push_back(twin);
            }
            vertex = (*known)[1];
        }
        piece.triangles.push_back(corners);
    }
}

} // namespace io::levels
