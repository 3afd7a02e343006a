#include "tests/unit/editor/worlds.h"

#include "editor/alpha_test.h"
#include "editor/arrange.h"
#include "editor/picker.h"

#include <algorithm>
#include <ctime>
#include <gtest/gtest.h>

using namespace editor;

namespace {

struct Expected {
    io::ObjectId id = io::ObjectId::None;
    double distance = 1e30;
    bool doubtful = false; // within a hair of an edge or of the alpha's cutoff, where floats may differ
};

void bruteForce(const io::Object& object, const io::Model& model, const io::Ray& ray, Expected& best)
{
    const glm::dmat4 matrix = io::worldFromModel(object.transform);
    const io::Material& material = model.materials[0];
    for (std::size_t i = 0; i < model.indices.size(); i += 3) {
        const auto corner = [&](std::size_t k) {
            return glm::dvec3{matrix * glm::dvec4{model.vertices[model.indices[i + k]].position, 1}};
        };
        const glm::dvec3 a = corner(0), e1 = corner(1) - a, e2 = corner(2) - a;
        const glm::dvec3 p = glm::cross(ray.direction, e2);
        const double det = glm::dot(e1, p);
        if (det == 0) continue;
        const double mirrored = glm::determinant(glm::dmat3{matrix}) < 0 ? -1 : 1;
        if (!material.doubleSided && glm::dot(glm::cross(e1, e2), ray.direction) * mirrored >= 0) continue;
        const glm::dvec3 s = ray.origin - a;
        const double u = glm::dot(s, p) / det;
        const glm::dvec3 q = glm::cross(s, e1);
        const double v = glm::dot(ray.direction, q) / det;
        const double t = glm::dot(e2, q) / det;
        const double edge = std::min({u, v, 1 - u - v});
        if (edge < -1e-4 || t < 0 || t >= best.distance) continue;
        const auto seen = [&](double du, double dv) {
            const bool cut = material.baseColourTexture.image >= 0;
            AlphaMips mips{cut ? model.images[0] : nullptr, material.alphaCutoff};
            return seenAt({.model = &model, .material = &material, .mips = cut ? &mips : nullptr}, i / 3,
                          {float(u + du), float(v + dv)});
        };
        const bool here = seen(0, 0);
        const bool sure = edge > 1e-4 && here == seen(1e-3, 0) && here == seen(0, 1e-3) && here == seen(-1e-3, -1e-3);
        if (!sure) best.doubtful = true;
        if (here && edge >= 0) best = {object.id, t, best.doubtful};
    }
}

// Rays towards what stands about, from a little outside.
io::Ray randomRay(Random& random)
{
    const glm::dvec3 from{random.in(-260, 260), random.in(5, 80), random.in(-260, 260)};
    const glm::dvec3 to{random.in(-200, 200), random.in(0, 25), random.in(-200, 200)};
    return {.origin = from, .direction = glm::normalize(to - from)};
}

// By the sphere around its box; most objects are far from a ray.
bool near(const io::WorldBox& box, const io::Ray& ray)
{
    const glm::dvec3 away = box.centre() - ray.origin;
    const double along = std::max(0.0, glm::dot(away, ray.direction));
    return glm::distance(away, ray.direction * along) <= glm::length(box.size()) / 2 + 1e-3;
}

void compareWithBruteForce(const Document& document, const Picker& picker, int rays, std::uint64_t seed)
{
    Random random{seed};
    int hits = 0, doubtful = 0;
    for (int i = 0; i < rays; ++i) {
        const io::Ray ray = randomRay(random);
        Expected expected;
        for (const io::Object& object : document.scene().objects())
            if (const io::Model* model = document.assets().model(object.templateId);
                model && near(io::worldBounds(document.assets(), object), ray))
                bruteForce(object, *model, ray, expected);
        if (expected.doubtful) {
            ++doubtful;
            continue;
        }
        const PickHit hit = picker.pick(ray, {.terrain = false});
        ASSERT_EQ(io::number(hit.id), io::number(expected.id)) << "ray " << i;
        if (!hit) continue;
        ++hits;
        EXPECT_NEAR(hit.distance, expected.distance, 1e-3);
        EXPECT_LT(glm::dot(hit.normal, ray.direction), 1e-6);
        EXPECT_EQ(hit.templateId, document.scene().at(hit.id).templateId);
    }
    EXPECT_GT(hits, rays / 5);
    EXPECT_LT(doubtful, rays / 10);
}

} // namespace

TEST(Picker, FindsWhatEveryTriangleTestedAloneSays)
{
    const auto document = test::forest(500, 3);
    Picker picker;
    compareWithBruteForce(*document, test::followed(picker, *document), 1500, 8);
}

TEST(Picker, FollowsMovesDeletesUndoAndNewTemplates)
{
    const auto document = test::forest(300, 4);
    Picker picker;
    test::followed(picker, *document);
    Random random{5};
    for (int round = 0; round < 6; ++round) {
        for (int i = 0; i < 40; ++i) {
            const auto objects = document->scene().objects();
            const std::vector one{objects[std::size_t(random.unit() * double(objects.size()))].id};
            switch (random.bits() % 5) {
            case 0:
                removeObjects(*document, "Delete", one);
                break;
            case 1:
                duplicate(*document, one, {random.in(-50, 50), 0, 10});
                break;
            case 2:
                edit(*document, "Assign", one,
                     [&](io::Object& o) { o.templateId = io::TemplateId(1 + random.bits() % 4); });
                break;
            case 3:
                edit(*document, "Mirror", one, [&](io::Object& o) { o.transform.scale.x *= -1; });
                break;
            default:
                moveBy(*document, "Move", one, {random.in(-30, 30), 1, 0});
            }
        }
        if (round % 2)
            for (int i = 0; i < 20; ++i)
                document->undo();
        compareWithBruteForce(*document, test::followed(picker, *document), 150, std::uint64_t(round));
    }
    document->goTo(0);
    compareWithBruteForce(*document, test::followed(picker, *document), 150, 99);
}

namespace {

// Some of what a person does, to one or to very many.
void editAtRandom(Document& document, Random& random)
{
    const auto objects = document.scene().objects();
    const auto any = [&] { return objects[std::size_t(random.unit() * double(objects.size()))].id; };
    const std::vector one{any()};
    std::vector<io::ObjectId> many;
    for (int i = 0; i < 400; ++i)
        many.push_back(any());
    std::ranges::sort(many);
    many.erase(std::unique(many.begin(), many.end()), many.end());
    switch (random.bits() % 40) {
    case 0:
        return removeObjects(document, "Delete", many);
    case 1:
        return moveBy(document, "Move", many, {random.in(-90, 90), 0, random.in(-90, 90)});
    case 2:
        return void(duplicate(document, many, {random.in(-9, 9), 0, random.in(-9, 9)}));
    case 3:
    case 4:
    case 5:
        return void(document.undo());
    case 6:
    case 7:
        return removeObjects(document, "Delete", one);
    case 8:
        return edit(document, "Assign", one,
                    [&](io::Object& o) { o.templateId = io::TemplateId(1 + random.bits() % 4); });
    default:
        return moveBy(document, "Move", one, {random.in(-30, 30), 1, random.in(-30, 30)});
    }
}

} // namespace

// Enough objects for many tiles, enough edits that the tiles are filled, thinned out and joined.
TEST(Picker, ItsTilesSayTheSameAfterHundredsOfEdits)
{
    const auto document = test::forest(17'000, 12, false);
    Picker picker;
    document->takeChanges();
    picker.update(document->scene(), document->assets(), {.everything = true});
    compareWithBruteForce(*document, picker, 800, 13);
    Random random{14};
    for (int i = 1; i <= 500; ++i) {
        editAtRandom(*document, random);
        test::followed(picker, *document);
        if (i % 7 == 0) picker.pick(randomRay(random));
        if (i == 200) picker.prepare();
        if (i % 100 == 0) compareWithBruteForce(*document, picker, 100, std::uint64_t(i));
    }
    compareWithBruteForce(*document, picker, 800, 15);
    document->goTo(0);
    compareWithBruteForce(*document, test::followed(picker, *document), 200, 16);
}

// Too scattered for a tile of their own, they join tiles whose rays did not come near so far.
TEST(Picker, WhatComesFarFromAllIsHitThere)
{
    const auto document = test::forest(6000, 19, false);
    Picker picker;
    test::followed(picker, *document).prepare();
    const auto at = [](int i) { return glm::dvec3{(i % 2 ? 1 : -1) * (600.0 + 15 * i), 0, 11.0 * i}; };
    std::vector<io::Object> blobs;
    for (int i = 0; i < 200; ++i)
        blobs.push_back({.id = document->freshId(), .templateId = io::TemplateId{2}, .transform = {.position = at(i)}});
    addObjects(*document, "Add", blobs);
    test::followed(picker, *document);
    for (int i = 0; i < 200; ++i)
        EXPECT_EQ(picker.pick({.origin = at(i) + glm::dvec3{0.1, 50, 0.1}, .direction = {0, -1, 0}}).id,
                  blobs[std::size_t(i)].id);
}

// Also what no ray has met yet, what lies behind the eye, and rectangles that lie outside of the picture in part.
TEST(Picker, TheBoxTakesWhatLookingAtEachSays)
{
    const auto document = test::forest(4000, 17, false);
    Picker picker;
    document->takeChanges();
    picker.update(document->scene(), document->assets(), {.everything = true});
    Random random{18};
    for (int i = 0; i < 60; ++i) {
        if (i % 3 == 0) editAtRandom(*document, random);
        test::followed(picker, *document);
        const View view{.camera = {.eye = {random.in(-200, 200), random.in(1, 90), random.in(-200, 200)},
                                   .yaw = float(random.in(-180, 180)),
                                   .pitch = float(random.in(-80, 30))},
                        .size = {640, 360}};
        const glm::dvec2 a{random.in(-50, 690), random.in(-50, 400)}, b{random.in(-50, 690), random.in(-50, 400)};
        std::vector<io::ObjectId> expected;
        for (const io::ObjectId id : document->scene().sortedIds()) {
            const auto pixel = project(view, picker.bounds(id).centre());
            if (!pixel || picker.bounds(id).empty()) continue;
            const glm::dvec2 low = glm::min(a, b), high = glm::max(a, b);
            if (pixel->x >= low.x && pixel->y >= low.y && pixel->x <= high.x && pixel->y <= high.y)
                expected.push_back(id);
        }
        EXPECT_EQ(picker.pickBox(view, {a, b}), expected);
    }
}

TEST(Picker, ALeafIsHitWhereItIsSeenOnly)
{
    const auto document = test::forest(0, 1, false);
    addObjects(*document, "Add", {{.id = document->freshId(), .templateId = io::TemplateId{3}}});
    Picker picker;
    test::followed(picker, *document);
    const auto at = [&](double x, double y) {
        return bool(picker.pick({.origin = {x, y, 10}, .direction = {0, 0, -1}}));
    };
    EXPECT_TRUE(at(0.1, 4));
    EXPECT_TRUE(at(2, 5));
    EXPECT_FALSE(at(3.8, 0.2)); // the corner of the card is see-through
    EXPECT_FALSE(at(-3.5, 7.5));
    EXPECT_FALSE(at(0.1, 0.1));
}

// Stripes a texel wide are seen one by one from near, and as one blurred leaf from where a pixel covers many.
TEST(Picker, FarAwayALeafIsAsSolidAsItIsDrawn)
{
    auto stripes = std::make_shared<io::Image>();
    stripes->size = {64, 64};
    stripes->bytes.resize(64 * 64 * 4, std::byte{255});
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 64; x += 2)
            stripes->row<std::uint8_t>(y)[x * 4 + 3] = 0;
    io::Model card = test::leafCard(8);
    card.images = {stripes};
    io::World world;
    world.scene.exchange(world.scene.templateSlot("card"), io::Template{.name = "card"});
    io::Assets assets;
    assets.models.push_back(std::make_shared<const io::Model>(std::move(card)));
    Document document{std::move(world), std::move(assets)};
    addObjects(document, "Add", {{.id = document.freshId(), .templateId = io::TemplateId{1}}});
    Picker picker;
    test::followed(picker, document);

    const auto hits = [&](double distance) { // of rays across the card, as a camera at that distance sends them
        const View view{.camera = {.eye = {0.01, 4, distance}}, .size = {1280, 720}};
        int count = 0;
        for (int i = 0; i < 200; ++i) {
            const glm::dvec3 aim{-3.9 + 0.035 * i, 4.1, 0};
            count += bool(picker.pick(view, *project(view, aim)));
        }
        return count;
    };
    EXPECT_NEAR(hits(5), 100, 20);
    EXPECT_EQ(hits(300), 200);
}

TEST(AlphaMips, DoNotThinOut)
{
    auto image = std::make_shared<io::Image>();
    image->size = {256, 128};
    image->bytes.resize(std::size_t(256) * 128 * 4);
    Random random{2};
    for (int y = 0; y < 128; ++y)
        for (int x = 0; x < 256; ++x) // spots of 4 x 4 texels, a fifth of them opaque
            image->row<std::uint8_t>(y)[x * 4 + 3] = Random{std::uint64_t(y / 4 * 1000 + x / 4)}.unit() < 0.2 ? 255 : 0;
    AlphaMips mips{image, 0.5f};
    for (const float lod : {0.0f, 1.0f, 2.0f, 3.0f, 4.0f}) {
        int passing = 0;
        for (int i = 0; i < 5000; ++i)
            passing += mips.sample({.image = 0}, {float(random.unit()), float(random.unit())}, lod) >= 0.5f;
        EXPECT_GE(passing, 750) << lod;                    // never thinner
        EXPECT_LE(passing, lod <= 2 ? 1250 : 2500) << lod; // beyond, a texel mixes spots and many share one alpha
    }
    EXPECT_GE(mips.sample({.image = 0}, {0.5f, 0.5f}, 1e9f), 0);
    EXPECT_GE(mips.sample({.image = 0}, {NAN, 0.5f}, NAN), 0);
}

TEST(Picker, BackFacesOfSingleSidedThingsAreLookedThrough)
{
    const auto document = test::forest(0, 1, false);
    addObjects(*document, "Add",
               {{.id = document->freshId(), .templateId = io::TemplateId{1}, .transform = {.rotation = {0, 30, 0}}}});
    Picker picker;
    test::followed(picker, *document);
    EXPECT_TRUE(picker.pick({.origin = {0, 20, 0.1}, .direction = {0, -1, 0}}));
    EXPECT_FALSE(picker.pick({.origin = {0, 2, 0.1}, .direction = {0, 1, 0}})); // from inside
    edit(*document, "Mirror", std::vector{io::ObjectId{1}}, [](io::Object& o) { o.transform.scale.x = -1; });
    test::followed(picker, *document);
    EXPECT_TRUE(picker.pick({.origin = {0, 20, 0.1}, .direction = {0, -1, 0}}));
    EXPECT_FALSE(picker.pick({.origin = {0, 2, 0.1}, .direction = {0, 1, 0}}));
}

TEST(Picker, TheNearerOfGroundAndObjectWins)
{
    const auto document = test::forest(200, 2);
    Picker picker;
    test::followed(picker, *document);
    Random random{1};
    int ground = 0, object = 0;
    for (int i = 0; i < 500; ++i) {
        const io::Ray ray = randomRay(random);
        const PickHit both = picker.pick(ray), onlyGround = picker.pick(ray, {.objects = false}),
                      onlyObjects = picker.pick(ray, {.terrain = false});
        const double nearest =
            std::min(onlyGround ? onlyGround.distance : 1e30, onlyObjects ? onlyObjects.distance : 1e30);
        EXPECT_EQ(bool(both), nearest < 1e29);
        EXPECT_DOUBLE_EQ(both ? both.distance : 1e30, nearest);
        ground += both.surface == Surface::Terrain;
        object += both.surface == Surface::Object;
    }
    EXPECT_GT(ground, 50);
    EXPECT_GT(object, 50);
}

TEST(Picker, AllAlongTheRayNearToFarAndEachOnce)
{
    const auto document = test::forest(0, 1);
    std::vector<io::Object> row;
    for (int i = 0; i < 5; ++i)
        row.push_back({.id = document->freshId(),
                       .templateId = io::TemplateId{2},
                       .transform = {.position = {0, 50, -20.0 * i}}});
    addObjects(*document, "Add", row);
    Picker picker;
    test::followed(picker, *document);
    const io::Ray ray{.origin = {0, 54, 30}, .direction = glm::normalize(glm::dvec3{0, -0.03, -1})};
    const auto hits = picker.pickAll(ray);
    ASSERT_GE(hits.size(), 5u);
    for (std::uint32_t i = 0; i < 5; ++i)
        EXPECT_EQ(io::number(hits[i].id), i + 1);
    EXPECT_EQ(picker.pickAll(ray, 2).size(), 2u);
    EXPECT_EQ(io::number(picker.pick(ray, {.skip = std::vector{io::ObjectId{2}, io::ObjectId{1}}}).id), 3u);

    ClickCycle cycle;
    EXPECT_EQ(io::number(cycle.next(hits, {100, 100}).id), 1u);
    EXPECT_EQ(io::number(cycle.next(hits, {101, 100}).id), 2u);
    EXPECT_EQ(io::number(cycle.next(hits, {100, 101}).id), 3u);
    EXPECT_EQ(io::number(cycle.next(hits, {150, 100}).id), 1u);
    for (int i = 0; i < 4; ++i)
        cycle.next(hits, {150, 100});
    EXPECT_EQ(io::number(cycle.next(hits, {150, 100}).id), 1u); // round again
    EXPECT_FALSE(cycle.next({}, {150, 100}));
}

TEST(Picker, BoxesOnlyAnswersByTheBoxAround)
{
    const auto document = test::forest(0, 1, false);
    addObjects(*document, "Add", {{.id = document->freshId(), .templateId = io::TemplateId{1}}});
    Picker picker;
    test::followed(picker, *document);
    const io::Ray pastTheTip{.origin = {2.9, 5.9, 20}, .direction = {0, 0, -1}};
    EXPECT_FALSE(picker.pick(pastTheTip));
    picker.setBoxesOnly(true);
    EXPECT_TRUE(picker.pick(pastTheTip));
    duplicate(*document, std::vector{io::ObjectId{1}}, {10, 0, 0});
    test::followed(picker, *document);
    EXPECT_TRUE(picker.pick({.origin = {12.9, 5.9, 20}, .direction = {0, 0, -1}}));
    picker.setBoxesOnly(false);
    EXPECT_FALSE(picker.pick(pastTheTip));
}

TEST(Picker, ANewModelOfATemplateIsWhatIsHit)
{
    const auto document = test::forest(0, 1, false);
    addObjects(*document, "Add", {{.id = document->freshId(), .templateId = io::TemplateId{4}}});
    Picker picker;
    test::followed(picker, *document);
    const io::Ray high{.origin = {0.1, 7, 20}, .direction = {0, 0, -1}};
    EXPECT_FALSE(picker.pick(high));
    io::Template marker = *document->scene().find(io::TemplateId{4});
    marker.markerSize = glm::vec3{10};
    setTemplate(*document, "Size", io::TemplateId{4}, marker);
    EXPECT_TRUE(test::followed(picker, *document).pick(high));
    document->undo();
    EXPECT_FALSE(test::followed(picker, *document).pick(high));
}

TEST(Picker, FarFromTheOriginItIsStillExact)
{
    const auto document = test::forest(0, 1, false);
    const glm::dvec3 at{80'000.123, 250.5, -60'000.456};
    addObjects(*document, "Add",
               {{.id = document->freshId(), .templateId = io::TemplateId{4}, .transform = {.position = at}}});
    Picker picker;
    document->takeChanges();
    picker.update(document->scene(), document->assets(), {.everything = true});
    const PickHit top = picker.pick({.origin = at + glm::dvec3{0.3, 100, 0.4}, .direction = {0, -1, 0}});
    ASSERT_TRUE(top);
    EXPECT_NEAR(top.position.y, at.y + 2, 1e-5);
    const PickHit side = picker.pick({.origin = at + glm::dvec3{50, 1, 0}, .direction = {-1, 0, 0}});
    ASSERT_TRUE(side);
    EXPECT_NEAR(side.position.x, at.x + 1, 1e-5);
    // A float at 80 km is good for 8 mm; the edges are where they are to a millimetre.
    for (const double x : {-0.999, 0.999})
        for (const double z : {-0.999, 0.999}) {
            EXPECT_TRUE(picker.pick({.origin = at + glm::dvec3{x, 100, z}, .direction = {0, -1, 0}}));
            EXPECT_FALSE(picker.pick({.origin = at + glm::dvec3{x * 1.002, 100, z}, .direction = {0, -1, 0}}));
            EXPECT_FALSE(picker.pick({.origin = at + glm::dvec3{x, 100, z * 1.002}, .direction = {0, -1, 0}}));
        }
}

TEST(Picker, TheBoxTakesWhatLiesInIt)
{
    const auto document = test::forest(300, 6);
    Picker picker;
    test::followed(picker, *document);
    const View view{.camera = {.eye = {0, 60, 250}, .pitch = -12}, .size = {640, 360}};
    const auto all = picker.pickBox(view, {{0, 0}, {640, 360}});
    const auto left = picker.pickBox(view, {{320, 360}, {0, 0}});
    EXPECT_GT(left.size(), 50u);
    EXPECT_LT(left.size(), all.size());
    for (const io::ObjectId id : left) {
        const auto pixel = project(view, picker.bounds(id).centre());
        ASSERT_TRUE(pixel.has_value());
        EXPECT_LE(pixel->x, 320);
    }
    const std::uint32_t seen[] = {7, 0, 7, 9, 0xffffffffu, 4711};
    EXPECT_EQ(picker.pickBox(view, {}, seen), (std::vector{io::ObjectId{7}, io::ObjectId{9}}));
}

// The tree over all objects is new after a move, the trees of the meshes are not: a blob of 200,000 triangles moved
// 300 times would otherwise take far longer.
TEST(Picker, AMoveDoesNotBuildAMeshAgain)
{
    io::World world;
    world.scene.exchange(world.scene.templateSlot("big"), io::Template{.name = "big"});
    io::Assets assets;
    assets.models.push_back(std::make_shared<const io::Model>(test::blob(4, 225)));
    Document document{std::move(world), std::move(assets)};
    addObjects(document, "Add", {{.id = document.freshId(), .templateId = io::TemplateId{1}}});
    Picker picker;
    test::followed(picker, document);
    const std::clock_t begun = std::clock(); // of this process alone, however busy the machine is
    for (int i = 0; i < 300; ++i) {
        moveBy(document, "Move", std::vector{io::ObjectId{1}}, {0.001, 0, 0});
        EXPECT_TRUE(test::followed(picker, document).pick({.origin = {0, 20, 0}, .direction = {0, -1, 0}}));
    }
    EXPECT_LT(double(std::clock() - begun) / CLOCKS_PER_SEC, 4);
}
