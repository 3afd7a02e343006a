#include "projects/make/noise.h"
#include "projects/make/terrain_forms.h"
#include "projects/make/valley.h"
#include "projects/make/valley_land.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace make {
namespace {

constexpr int kTrees = 2930;
constexpr int kFarTrees = 4200;

float smooth(float low, float high, float x)
{
    return glm::smoothstep(low, high, x);
}

float altitude(const Stage& stage, glm::vec2 p)
{
    return heightAt(stage.heights(), p);
}

// Where people look: trees are spent there first.
float nearness(glm::vec2 p)
{
    const float away = glm::length((p - glm::vec2{0, -70}) * glm::vec2{1.0f, 0.72f});
    return glm::mix(0.065f, 1.0f, smooth(640, 230, away));
}

struct Kind {
    std::string_view name;
    float room; // radius that no other trunk may be in, m
};

struct Site {
    glm::vec2 at;
    float forest;   // forestAt
    float altitude; // m
    float age;      // 0 young … 1 old, alike in a neighbourhood
    float wet;      // -1..1
};

Kind coniferOf(const Site& site, Random& random)
{
    const float age = site.age + 0.25f * random.bell();
    if (age < 0.24f) return {"fir_young", 1.5f};
    return age < 0.72f ? Kind{"fir", 2.3f} : Kind{"fir_old", 3.0f};
}

Kind broadleafOf(const Site& site, Random& random)
{
    const float age = site.age + 0.22f * random.bell();
    const bool autumn = noise(site.at / 85.0f, 81) + 0.35f * random.bell() > 0.36f;
    const bool edge = site.forest < 0.42f;
    const float kind = site.wet + 0.35f * random.bell();
    if ((edge && random.chance(0.55f)) || kind > 0.42f) {
        if (age < 0.22f) return {"birch_young", 1.4f};
        return autumn ? Kind{"birch_autumn", 2.2f} : age > 0.78f ? Kind{"birch_old", 2.7f} : Kind{"birch", 2.2f};
    }
    if (kind > -0.08f) {
        if (age < 0.22f) return {"beech_young", 1.7f};
        return autumn ? Kind{"beech_autumn", 3.4f} : age > 0.74f ? Kind{"beech_old", 4.6f} : Kind{"beech", 3.3f};
    }
    if (age < 0.22f) return {"oak_young", 1.7f};
    return autumn ? Kind{"oak_autumn", 3.6f} : age > 0.80f ? Kind{"oak_old", 5.2f} : Kind{"oak", 3.6f};
}

Kind treeFor(const Site& site, Random& random)
{
    const float firs = smooth(66, 118, site.altitude + 26 * noise(site.at / 110.0f, 82));
    const float pocket = smooth(0.38f, 0.6f, noise(site.at / 70.0f, 83)); // firs also gather in pockets below
    return random.chance(std::max(firs, pocket * 0.8f)) ? coniferOf(site, random) : broadleafOf(site, random);
}

// The rest of it, where a tree is to be considered.
void know(Site& site, const Stage& stage)
{
    site.altitude = altitude(stage, site.at);
    site.age = std::clamp(0.5f + 0.55f * noise(site.at / 65.0f, 84) + 0.30f * (site.forest - 0.5f), 0.0f, 1.0f);
    site.wet = noise(site.at / 130.0f, 85);
}

bool isTree(std::string_view name, const char* kind)
{
    return name.starts_with(kind);
}

// A few trees that a picture is composed about: they stand alone where the eye needs them.
void plantLandmarks(Stage& stage)
{
    struct Landmark {
        std::string_view what;
        glm::vec2 fromCamp;
        float scale;
    };
    const Landmark landmarks[] = {
        {"oak_old", {-13, 13.5f}, 1.05f}, {"birch_autumn", {13.5f, -12}, 1.0f}, {"birch", {16.5f, -14.5f}, 0.9f},
        {"beech_autumn", {-27, 4}, 1.0f}, {"oak_autumn", {-20, -27}, 1.0f},     {"fir_old", {-29, -19}, 1.0f},
        {"fir", {-28, -12}, 1.1f},        {"birch_old", {-22, 22}, 1.0f},       {"oak_old", {150, 190}, 1.1f},
        {"oak_old", {205, 330}, 1.15f},   {"oak_autumn", {128, 206}, 1.1f},     {"birch_autumn", {92, 60}, 1.05f},
        {"birch", {96, 66}, 1.0f},        {"birch_old", {89, 68}, 0.95f}};
    Random random{901};
    for (const Landmark& mark : landmarks) {
        const glm::vec2 at = kCamp + mark.fromCamp;
        if (streamDistance(at) < 11) continue;
        stage.put({.what = mark.what, .at = at, .scale = mark.scale}, random);
        stage.take(at, isTree(mark.what, "oak_old") ? 5.5f : 3.0f);
    }
}

} // namespace

float forestAt(const Stage& stage, glm::vec2 p)
{
    const float height = altitude(stage, p);
    const float slope = slopeAt(stage.heights(), p);
    const float patches = fbm(p / 190.0f, 71, {.count = 4}) + 0.10f * fbm(p / 28.0f, 77, {.count = 2});
    const float onHills = smooth(32.0f, 38, height + 4 * noise(p / 60.0f, 72));
    const float groves = fbm(p / 85.0f, 73, {.count = 3});
    const float plain = 0.75f * smooth(0.30f, 0.42f, groves); // groves on the plain
    const float treeline = 1 - smooth(150, 235, height + 35 * noise(p / 90.0f, 74));
    const float rooted = 1 - smooth(31, 40, slope);
    const float clearing =
        smooth(19, 34, glm::length((p - kCamp - glm::vec2{-4, -4}) * glm::vec2{0.9f, 1}) + 6 * noise(p / 14.0f, 75));
    const float banks = smooth(11, 24, streamDistance(p) + 4 * noise(p / 20.0f, 76));
    return std::clamp(std::max(plain, onHills * smooth(-0.16f, 0.06f, patches)), 0.0f, 1.0f) * treeline * rooted *
           clearing * banks;
}

void plantForest(Stage& stage)
{
    plantLandmarks(stage);
    Random random{903};
    int planted = 0;
    for (int attempt = 0; attempt < 400000 && planted < kTrees; ++attempt) {
        Site site{.at = {random.range(-1010, 1010), random.range(-1010, 1010)}};
        const float chance = random.unit();
        if (chance > nearness(site.at)) continue;
        site.forest = forestAt(stage, site.at);
        if (chance > site.forest * nearness(site.at) || site.forest < 0.05f) continue;
        know(site, stage);
        const Kind kind = treeFor(site, random);
        const float room = kind.room * glm::mix(0.95f, 0.57f, site.forest);
        if (!stage.isFree(site.at, room)) continue;
        stage.put({.what = kind.name, .at = site.at}, random);
        stage.take(site.at, room);
        ++planted;
    }
}

// Woods on the hills beyond what people walk through, as a scatter layer: nobody needs each of these trees by name.
void plantFarForest(Stage& stage)
{
    io::ScatterLayer layer{.name = "Far woods", .density = 0.02f, .spacing = 4.5f, .slope = {0, 36}, .altitude = {29, 235}};
    for (const char* tree : {"fir", "fir_old", "fir_young", "birch", "birch_autumn", "birch_old", "birch_young", "beech", "beech_autumn", "beech_old",
                             "beech_young", "oak", "oak_autumn", "oak_old", "oak_young"})
        layer.species.push_back({.templateName = tree});
    stage.addLayer(std::move(layer));
    Random random{951};
    int planted = 0;
    for (int attempt = 0; attempt < 400000 && planted < kFarTrees; ++attempt) {
        Site site{.at = {random.range(-1010, 1010), random.range(-1010, 1010)}};
        site.forest = forestAt(stage, site.at);
        if (!random.chance(site.forest * (1 - nearness(site.at))) || site.forest < 0.1f) continue;
        know(site, stage);
        const Kind kind = treeFor(site, random);
        const float room = kind.room * glm::mix(1.0f, 0.75f, site.forest);
        if (!stage.isFree(site.at, room)) continue;
        stage.plant({.what = kind.name, .at = site.at}, random);
        stage.take(site.at, room);
        ++planted;
    }
}

namespace {

// Puts up to `count` of something where `share` (0..1) allows it, within `reach` metres of `centre`.
struct Scatter {
    std::string_view what;
    int count;
    float room;
    glm::vec2 centre;
    float reach;
    std::uint64_t seed;
};

template <class Share> void scatter(Stage& stage, const Scatter& plan, Share share)
{
    Random random{plan.seed};
    int placed = 0;
    for (int attempt = 0; attempt < plan.count * 400 && placed < plan.count; ++attempt) {
        const float angle = random.range(0, 6.2831853f);
        const float away = plan.reach * std::sqrt(random.unit());
        const glm::vec2 at = plan.centre + away * glm::vec2{std::cos(angle), std::sin(angle)};
        if (std::abs(at.x) > 1010 || std::abs(at.y) > 1010 || !random.chance(share(at)) || !stage.isFree(at, plan.room))
            continue;
        stage.put({.what = plan.what, .at = at}, random);
        stage.take(at, plan.room);
        ++placed;
    }
}

float edgeAt(const Stage& stage, glm::vec2 p) // 1 where forest begins
{
    const float forest = forestAt(stage, p);
    return smooth(0.04f, 0.16f, forest) * (1 - smooth(0.35f, 0.6f, forest));
}

} // namespace

void plantUndergrowth(Stage& stage)
{
    const glm::vec2 middle = kCamp + glm::vec2{10, -20};
    const auto edge = [&](glm::vec2 p) { return edgeAt(stage, p) * nearness(p); };
    const auto inside = [&](glm::vec2 p) { return smooth(0.35f, 0.8f, forestAt(stage, p)) * nearness(p); };
    const auto bank = [&](glm::vec2 p) {
        return smooth(29.3f, 29.9f, altitude(stage, p)) * smooth(24, 14, streamDistance(p));
    };

    const auto meadow = [&](glm::vec2 p) { // thickets on the open plain
        return smooth(0.30f, 0.45f, noise(p / 38.0f, 92)) * (1 - smooth(0.1f, 0.4f, forestAt(stage, p))) *
               smooth(14, 20, streamDistance(p)) * smooth(24, 34, glm::length(p - kCamp)) *
               smooth(18, 8, slopeAt(stage.heights(), p));
    };

    const auto mantle = [&](glm::vec2 p) { // what crowds about the rim of a wood
        return edge(p) * smooth(-0.25f, 0.25f, noise(p / 24.0f, 93));
    };

    scatter(stage, {"oak_young", 40, 1.4f, middle, 380, 926}, mantle);
    scatter(stage, {"beech_young", 40, 1.4f, middle, 380, 927}, mantle);
    scatter(stage, {"birch_young", 50, 1.4f, middle, 420, 928}, mantle);
    scatter(stage, {"bush", 110, 0.9f, middle, 380, 929}, mantle);
    scatter(stage, {"bush_low", 80, 0.8f, middle, 330, 930}, mantle);
    scatter(stage, {"bush", 70, 1.0f, kCamp + glm::vec2{60, 120}, 300, 924}, meadow);
    scatter(stage, {"bush_low", 60, 0.9f, kCamp + glm::vec2{60, 120}, 300, 925}, meadow);
    scatter(stage, {"dead_tree", 46, 2.0f, middle, 620, 911}, inside);
    scatter(stage, {"dead_branch", 130, 0.9f, middle, 380, 912}, inside);
    scatter(stage, {"stump", 38, 0.9f, middle, 330, 913}, edge);
    scatter(stage, {"stump_broken", 34, 0.9f, middle, 420, 914}, inside);
    scatter(stage, {"bush", 100, 1.1f, middle, 420, 915}, edge);
    scatter(stage, {"bush_low", 70, 0.9f, middle, 330, 916}, edge);
    scatter(stage, {"bush", 60, 1.0f, middle, 380, 917}, bank);
    scatter(stage, {"fern", 170, 0.5f, middle, 260, 918}, inside);
}

namespace {

float steepAbove(const Stage& stage, glm::vec2 p) // steepness some metres uphill, degrees
{
    const auto normal = stage.heights().normal(p.x, p.y).value_or(glm::dvec3{0, 1, 0});
    const glm::vec2 uphill = -glm::vec2{float(normal.x), float(normal.z)};
    if (glm::length(uphill) < 0.05f) return 0;
    const glm::vec2 step = glm::normalize(uphill);
    return std::max(slopeAt(stage.heights(), p + step * 14.0f), slopeAt(stage.heights(), p + step * 26.0f));
}

} // namespace

void layRocks(Stage& stage)
{
    const glm::vec2 middle = kCamp + glm::vec2{0, -60};
    const auto cliff = [&](glm::vec2 p) { return smooth(40, 47, slopeAt(stage.heights(), p)) * nearness(p); };
    const auto scree = [&](glm::vec2 p) {
        return smooth(38, 44, steepAbove(stage, p)) * smooth(39, 31, slopeAt(stage.heights(), p)) * nearness(p);
    };
    const auto slope = [&](glm::vec2 p) { return smooth(14, 26, slopeAt(stage.heights(), p)) * 0.6f * nearness(p); };
    const auto bed = [&](glm::vec2 p) { return smooth(29.2f, 28.6f, altitude(stage, p)); };
    const auto meadow = [&](glm::vec2 p) {
        return smooth(12, 16, streamDistance(p)) * smooth(14, 5, slopeAt(stage.heights(), p)) *
               smooth(16, 24, glm::length(p - kCamp));
    };

    scatter(stage, {"rock_slab", 52, 3.0f, middle, 700, 931}, cliff);
    scatter(stage, {"boulder", 34, 2.4f, middle, 600, 932}, scree);
    scatter(stage, {"rock", 90, 1.2f, middle, 520, 933}, scree);
    scatter(stage, {"rock_small", 70, 0.5f, middle, 420, 934}, scree);
    scatter(stage, {"rock", 40, 1.3f, middle, 480, 935}, slope);
    scatter(stage, {"rock_mossy", 56, 1.5f, middle, 420, 936}, slope);
    scatter(stage, {"boulder", 13, 2.6f, middle, 420, 937}, bed);
    scatter(stage, {"rock", 46, 1.3f, middle, 330, 938}, bed);
    scatter(stage, {"rock_small", 150, 0.45f, kCamp, 210, 939}, bed);
    const auto bank = [&](glm::vec2 p) {
        return smooth(29.0f, 29.6f, altitude(stage, p)) * smooth(20, 10, streamDistance(p));
    };
    scatter(stage, {"rock_mossy", 16, 1.6f, middle, 260, 940}, meadow);
    scatter(stage, {"rock_mossy", 24, 1.3f, middle, 330, 941}, bank);
    scatter(stage, {"rock_small", 70, 0.5f, middle, 260, 942}, bank);
}

} // namespace make
