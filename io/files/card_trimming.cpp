#include "io/files/card_trimming.h"

#include "io/files/cutout_outline.h"
#include "io/files/draw_order.h"
#include "io/files/level_parts.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <map>
#include <numeric>
#include <optional>
#include <tuple>

namespace io {
namespace {

using levels::Corners;

constexpr float kWorthwhile = 0.85f;    // a card that would keep more of its area stays whole
constexpr float kStray = 0.5f;          // of a level's error: how far what is cut may move
constexpr std::size_t kMostTriangles = 64; // of a card; what has more is none, and stays whole
constexpr std::size_t kMostOutlines = 256; // of a model: each takes a fraction of a millisecond
constexpr float kOnEdge = 1e-4f;        // of a texture: so far beyond its edge is still on it
constexpr float kFullMargin = 1 / 128.0f;  // of the texture around what is opaque: filters and small mips reach there
constexpr float kLevelMargin = 1 / 64.0f;  // the same where small mips are used more
constexpr float kFullCorner = 0.05f;       // what one more corner has to save, of the card's area
constexpr float kLevelCorner = 0.12f;      // the same where cards are small, and triangles weigh more

// A corner of a triangle, and where it lies in the part's base colour texture.
struct Corner {
    Vertex vertex;
    glm::vec2 uv{0};
};

struct Card {
    std::vector<std::array<Corner, 3>> triangles;
    std::vector<Corners> whole;
    glm::vec2 min{std::numeric_limits<float>::max()}, max{std::numeric_limits<float>::lowest()}; // of uv
    float area = 0;      // of uv
    bool front = false;  // uv turns the same way in all triangles: as in textures, or
    bool back = false;   // mirrored
};

// What to cut a list of triangles to.
struct Wanted {
    float margin = 0;
    float corner = 0; // share of the area that one has to save
    float stray = 0;  // m
};

float turn(const std::array<Corner, 3>& t)
{
    const glm::vec2 a = t[1].uv - t[0].uv, b = t[2].uv - t[0].uv;
    return a.x * b.y - a.y * b.x;
}

Vertex weighted(const std::array<Corner, 3>& t, const glm::vec3& weights)
{
    Vertex v = t[0].vertex;
    const auto mix = [&](auto field) {
        return field(t[0].vertex) * weights[0] + field(t[1].vertex) * weights[1] + field(t[2].vertex) * weights[2];
    };
    v.position = mix([](const Vertex& c) { return c.position; });
    v.uv0 = mix([](const Vertex& c) { return c.uv0; });
    v.uv1 = mix([](const Vertex& c) { return c.uv1; });
    v.colour = glm::u8vec4(glm::round(mix([](const Vertex& c) { return glm::vec4(c.colour); })));
    const glm::vec3 normal = mix([](const Vertex& c) { return c.normal; });
    const glm::vec3 tangent = mix([](const Vertex& c) { return glm::vec3(c.tangent); });
    if (glm::dot(normal, normal) > 1e-12f) v.normal = glm::normalize(normal);
    if (glm::dot(tangent, tangent) > 1e-12f) v.tangent = glm::vec4(glm::normalize(tangent), v.tangent.w);
    return v;
}

// Where `uv` lies in the triangle: weights of its corners, negative outside.
glm::vec3 weightsIn(const std::array<Corner, 3>& t, const glm::vec2& uv)
{
    const glm::vec2 a = t[1].uv - t[0].uv, b = t[2].uv - t[0].uv, p = uv - t[0].uv;
    const float whole = a.x * b.y - a.y * b.x;
    const float second = (p.x * b.y - p.y * b.x) / whole, third = (a.x * p.y - a.y * p.x) / whole;
    return {1 - second - third, second, third};
}

// On the card's surface; `uv` lies on one of its triangles, or as good as.
Vertex at(const Card& card, const glm::vec2& uv)
{
    const std::array<Corner, 3>* best = &card.triangles.front();
    glm::vec3 weights{0};
    float most = std::numeric_limits<float>::lowest();
    for (const auto& triangle : card.triangles) {
        const glm::vec3 own = weightsIn(triangle, uv);
        const float least = std::min({own.x, own.y, own.z});
        if (least > most) most = least, best = &triangle, weights = own;
    }
    return weighted(*best, weights);
}

// By vertex: those at one place of space and texture share a number.
std::vector<std::uint32_t> cornersOf(const Model& model)
{
    std::vector<std::uint32_t> order(model.vertices.size()), corner(order.size());
    std::iota(order.begin(), order.end(), 0u);
    const auto key = [&](std::uint32_t vertex) {
        const Vertex& v = model.vertices[vertex];
        return std::array{v.position.x, v.position.y, v.position.z, v.uv0.x, v.uv0.y, v.uv1.x, v.uv1.y};
    };
    const auto before = [&](std::uint32_t a, std::uint32_t b) {
        const auto left = key(a), right = key(b);
        return std::memcmp(left.data(), right.data(), sizeof left) < 0;
    };
    std::sort(order.begin(), order.end(), before);
    for (std::size_t i = 0; i < order.size(); ++i)
        corner[order[i]] = i > 0 && !before(order[i - 1], order[i]) ? corner[order[i - 1]] : order[i];
    return corner;
}

class Trimming {
public:
    explicit Trimming(Model& model) : m_model{model}, m_corners{cornersOf(model)} {}
    void trim(std::vector<std::uint32_t>& indices, std::vector<Part>& parts, const Wanted& wanted);
    bool changed() const { return m_changed; }

private:
    void trimPart(std::span<const std::uint32_t> indices, const Material& material, const Wanted& wanted,
                  std::vector<std::uint32_t>& result);
    const Polygon* outline(const Material& material, const glm::vec2& min, const glm::vec2& max, const Wanted& wanted);
    void addWhole(const Card& card, std::vector<std::uint32_t>& result) const;
    void trimCard(const Card& card, const Polygon& polygon, const Wanted& wanted, std::vector<std::uint32_t>& result);
    void addPolygon(const Card& card, const Polygon& polygon, std::vector<std::uint32_t>& result);
    std::uint32_t numberOf(const Vertex& vertex);

    using OutlineKey = std::tuple<const Image*, float, float, float, std::array<float, 4>>;
    Model& m_model;
    std::vector<std::uint32_t> m_corners; // of what the model held at first
    std::map<OutlineKey, Polygon> m_outlines;
    std::size_t m_firstOwn = 0; // of the card at hand: its new vertices begin here
    bool m_changed = false;
};

bool canBeTrimmed(const Model& model, const Material& material)
{
    const int image = material.baseColourTexture.image;
    if (material.alphaMode != AlphaMode::Mask || image < 0 || std::size_t(image) >= model.images.size()) return false;
    const auto& picture = model.images[std::size_t(image)];
    return picture && hasAlpha(*picture) && material.alphaCutoff > 0 && material.baseColour.a > 0;
}

glm::vec2 placeOn(const Vertex& vertex, const TextureUse& use)
{
    const glm::vec2 uv = use.scale * (use.uvSet == 1 ? vertex.uv1 : vertex.uv0);
    const float c = std::cos(use.rotation), s = std::sin(use.rotation);
    return use.offset + glm::vec2{c * uv.x + s * uv.y, c * uv.y - s * uv.x};
}

std::vector<Card> cardsOf(const Model& model, std::span<const std::uint32_t> indices, const TextureUse& use,
                          std::span<const std::uint32_t> corners)
{
    std::vector<Corners> triangles;
    for (std::size_t i = 0; i + 2 < indices.size(); i += 3)
        triangles.push_back({{indices[i], indices[i + 1], indices[i + 2]}});
    const std::vector<std::uint32_t> component = levels::componentsOf(triangles, corners, levels::Joined::AtEdges);
    std::vector<Card> cards(component.empty() ? 0 : *std::max_element(component.begin(), component.end()) + 1);
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        Card& card = cards[component[i]];
        std::array<Corner, 3> triangle;
        for (std::size_t c = 0; c < 3; ++c) {
            triangle[c].vertex = model.vertices[triangles[i].vertex[c]];
            triangle[c].uv = placeOn(triangle[c].vertex, use);
            card.min = glm::min(card.min, triangle[c].uv);
            card.max = glm::max(card.max, triangle[c].uv);
        }
        const float twice = turn(triangle);
        card.area += std::abs(twice) / 2;
        (twice < 0 ? card.back : card.front) = true;
        card.triangles.push_back(triangle);
        card.whole.push_back(triangles[i]);
    }
    return cards;
}

bool canBeTrimmed(const Card& card)
{
    const auto fine = [](const std::array<Corner, 3>& t) {
        const auto finite = [](const Corner& c) {
            const glm::vec3& p = c.vertex.position;
            return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
        };
        return std::abs(turn(t)) > 1e-12f && std::all_of(t.begin(), t.end(), finite);
    };
    return card.triangles.size() <= kMostTriangles && std::isfinite(card.area) &&
           std::all_of(card.triangles.begin(), card.triangles.end(), fine);
}

// What takes the card onto the texture's own square; nothing when it covers more than one of its repetitions.
std::optional<glm::vec2> shiftOntoTexture(const Card& card, const TextureUse& use)
{
    const auto along = [&](int axis, Wrap wrap) -> std::optional<float> {
        const float cell = wrap == Wrap::Repeat ? std::floor((card.min[axis] + card.max[axis]) / 2) : 0.0f;
        if (card.min[axis] < cell - kOnEdge || card.max[axis] > cell + 1 + kOnEdge) return {};
        return -cell;
    };
    const auto u = along(0, use.wrapU), v = along(1, use.wrapV);
    return u && v ? std::optional{glm::vec2{*u, *v}} : std::nullopt;
}

// Nothing when the model asked for too many.
const Polygon* Trimming::outline(const Material& material, const glm::vec2& min, const glm::vec2& max, const Wanted& wanted)
{
    const Image& image = *m_model.images[std::size_t(material.baseColourTexture.image)];
    // Far away the threshold is anywhere within half of the way to 0 or 1 (cutout.glsl).
    const float least = material.alphaCutoff - std::min(material.alphaCutoff, 1 - material.alphaCutoff) / 2;
    const OutlineRequest request{.min = glm::clamp(min, 0.0f, 1.0f),
                                 .max = glm::clamp(max, 0.0f, 1.0f),
                                 .cutoff = least / material.baseColour.a,
                                 .margin = wanted.margin,
                                 .corner = wanted.corner};
    const OutlineKey key{&image, request.cutoff, request.corner, request.margin,
                         {request.min.x, request.min.y, request.max.x, request.max.y}};
    const auto known = m_outlines.find(key);
    if (known != m_outlines.end()) return &known->second;
    if (m_outlines.size() == kMostOutlines) return nullptr;
    return &m_outlines.emplace(key, cutoutOutline(image, request)).first->second;
}

std::uint32_t Trimming::numberOf(const Vertex& vertex)
{
    std::vector<Vertex>& all = m_model.vertices;
    for (std::size_t i = m_firstOwn; i < all.size(); ++i)
        if (std::memcmp(&all[i], &vertex, sizeof vertex) == 0) return std::uint32_t(i);
    all.push_back(vertex);
    return std::uint32_t(all.size() - 1);
}

void Trimming::addWhole(const Card& card, std::vector<std::uint32_t>& result) const
{
    for (const Corners& corners : card.whole)
        result.insert(result.end(), corners.vertex.begin(), corners.vertex.end());
}

// How far the middle between two places of the texture lies from the middle of their places in space, m.
float bendBetween(const Card& card, const glm::vec2& a, const glm::vec2& b)
{
    return glm::length(at(card, (a + b) * 0.5f).position - (at(card, a).position + at(card, b).position) * 0.5f);
}

// Begins the polygon where the fan of triangles from there follows a bent card best.
void turnToBend(Polygon& polygon, const Card& card)
{
    std::size_t best = 0;
    float least = std::numeric_limits<float>::infinity();
    for (std::size_t first = 0; first < polygon.size(); ++first) {
        float sum = 0;
        for (std::size_t i = 2; i + 1 < polygon.size(); ++i)
            sum += bendBetween(card, polygon[first], polygon[(first + i) % polygon.size()]);
        if (sum >= least) continue;
        least = sum;
        best = first;
    }
    std::rotate(polygon.begin(), polygon.begin() + std::ptrdiff_t(best), polygon.end());
}

// Whether a card fills its part of the texture and bends so little that the polygon may stand for it: fewer triangles
// than each of its own cut. A quad may, as neither of its diagonals is the right one.
bool isOne(const Card& card, const Polygon& polygon, float stray)
{
    const glm::vec2 size = card.max - card.min;
    if (card.front == card.back || std::abs(card.area / (size.x * size.y) - 1) > kOnEdge) return false;
    if (card.triangles.size() <= 2) return true;
    for (const glm::vec2& a : polygon)
        for (const glm::vec2& b : polygon)
            if (bendBetween(card, a, b) > stray) return false;
    return true;
}

// What of a triangle lies in the polygon (Sutherland and Hodgman 1974). Triangles that share an edge cut it at the same
// places, to the bit.
Polygon cut(const std::array<Corner, 3>& triangle, const Polygon& polygon)
{
    Polygon left{triangle[0].uv, triangle[1].uv, triangle[2].uv};
    for (std::size_t i = 0; i < polygon.size() && !left.empty(); ++i) {
        const glm::vec2 from = polygon[i], along = polygon[(i + 1) % polygon.size()] - from;
        const auto inside = [&](const glm::vec2& p) { return along.x * (p.y - from.y) - along.y * (p.x - from.x); };
        Polygon next;
        for (std::size_t j = 0; j < left.size(); ++j) {
            glm::vec2 a = left[j], b = left[(j + 1) % left.size()];
            if (inside(a) >= 0) next.push_back(a);
            if ((inside(a) >= 0) == (inside(b) >= 0)) continue;
            if (a.x > b.x || (a.x == b.x && a.y > b.y)) std::swap(a, b);
            next.push_back(a + (b - a) * (inside(a) / (inside(a) - inside(b))));
        }
        left = std::move(next);
    }
    return left;
}

void Trimming::addPolygon(const Card& card, const Polygon& polygon, std::vector<std::uint32_t>& result)
{
    std::vector<std::uint32_t> corners;
    for (const glm::vec2& uv : polygon)
        corners.push_back(numberOf(at(card, uv)));
    for (std::size_t i = 2; i < corners.size(); ++i)
        if (corners[0] != corners[i - 1] && corners[i - 1] != corners[i] && corners[i] != corners[0])
            result.insert(result.end(), {corners[0], corners[i - 1], corners[i]});
}

void Trimming::trimCard(const Card& card, const Polygon& polygon, const Wanted& wanted, std::vector<std::uint32_t>& result)
{
    std::vector<Polygon> pieces;
    if (polygon.empty()) {
        // nothing of it is ever seen
    } else if (isOne(card, polygon, wanted.stray)) {
        pieces.push_back(polygon);
        turnToBend(pieces[0], card);
        if (card.back) std::reverse(pieces[0].begin(), pieces[0].end());
    } else {
        for (const auto& triangle : card.triangles)
            pieces.push_back(cut(triangle, polygon));
    }
    float area = 0;
    for (const Polygon& piece : pieces)
        area += std::abs(areaOf(piece));
    if (area > kWorthwhile * card.area) return addWhole(card, result);
    m_changed = true;
    m_firstOwn = m_model.vertices.size();
    for (const Polygon& piece : pieces)
        addPolygon(card, piece, result);
}

void Trimming::trimPart(std::span<const std::uint32_t> indices, const Material& material, const Wanted& wanted,
                        std::vector<std::uint32_t>& result)
{
    for (Card& card : cardsOf(m_model, indices, material.baseColourTexture, m_corners)) {
        const auto shift = canBeTrimmed(card) ? shiftOntoTexture(card, material.baseColourTexture) : std::nullopt;
        if (!shift) {
            addWhole(card, result);
            continue;
        }
        card.min += *shift;
        card.max += *shift;
        for (auto& triangle : card.triangles)
            for (Corner& corner : triangle)
                corner.uv += *shift;
        if (const Polygon* polygon = outline(material, card.min, card.max, wanted))
            trimCard(card, *polygon, wanted, result);
        else
            addWhole(card, result);
    }
}

void Trimming::trim(std::vector<std::uint32_t>& indices, std::vector<Part>& parts, const Wanted& wanted)
{
    std::vector<std::uint32_t> result;
    std::vector<Part> kept;
    for (const Part& part : parts) {
        const std::span<const std::uint32_t> own{indices.data() + part.firstIndex, part.indexCount};
        Part made{.firstIndex = std::uint32_t(result.size()), .material = part.material};
        const Material& material = m_model.materials[std::size_t(part.material)];
        if (canBeTrimmed(m_model, material))
            trimPart(own, material, wanted, result);
        else
            result.insert(result.end(), own.begin(), own.end());
        made.indexCount = std::uint32_t(result.size()) - made.firstIndex;
        if (made.indexCount > 0) kept.push_back(made);
    }
    if (result.empty()) return; // nothing of it is ever seen: it stays as it is, so that it can be found
    indices = std::move(result);
    parts = std::move(kept);
}

} // namespace

void trimCards(Model& model)
{
    const auto canBe = [&](const Part& part) { return canBeTrimmed(model, model.materials[std::size_t(part.material)]); };
    if (std::none_of(model.parts.begin(), model.parts.end(), canBe)) return; // most models: not even looked through
    Trimming trimming{model};
    const std::size_t untrimmed = model.triangles();
    trimming.trim(model.indices, model.parts, {.margin = kFullMargin, .corner = kFullCorner});
    for (Level& level : model.levels)
        trimming.trim(level.indices, level.parts,
                      {.margin = kLevelMargin, .corner = kLevelCorner, .stray = kStray * level.error});
    if (!trimming.changed()) return;
    model.untrimmed = untrimmed;
    renumberVertices(model);
}

} // namespace io
