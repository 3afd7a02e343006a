// A model's picture stands for it where it is small: the same shape, light and id, at the price of two triangles.
#include "io/files/model_file.h"
#include "tests/gl/support/shared_renderer.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace {

constexpr glm::ivec2 kSize{72, 72};
constexpr float kFov = 7; // degrees: as far away as in a usual picture of 720 lines

std::shared_ptr<const io::Model> shipped(const std::string& name)
{
    const std::filesystem::path root = WOLD_SOURCE_DIR "/projects/valley";
    io::Complaints complaints;
    io::Result<io::Model> model = io::readModel(root / "models" / (name + ".glb"), root, complaints);
    return model ? std::make_shared<const io::Model>(std::move(*model)) : nullptr;
}

// One copy in an even light of sky and sun.
struct Lone {
    test::TestWorld world;
    io::ObjectId object = io::ObjectId::None;
    glm::dvec3 centre{0};
    double radius = 0;

    Lone(std::shared_ptr<const io::Model> model, const io::Transform& transform, float azimuth = 150, float elevation = 40)
    {
        io::Template what{.name = "it", .model = "models/it.glb", .impostor = true};
        const io::TemplateId id = test::addTemplate(world, what.name, model);
        world.scene.exchange(id, what);
        object = test::addObject(world, id, transform);
        world.scene.exchange(test::plainEnvironment(azimuth, elevation));
        centre = glm::dvec3{io::worldFromModel(transform) * glm::dvec4{model->bounds.centre(), 1}};
        const glm::vec3 size = glm::abs(transform.scale);
        radius = glm::length(model->bounds.size()) / 2 * std::max({size.x, size.y, size.z});
        test::load(world);
    }
    io::Camera camera(float yaw, float pitch, double pixels = 60) const // across the sphere, as where impostors come
    {
        io::Camera result{.yaw = yaw, .pitch = pitch, .fov = kFov};
        result.eye = centre - io::forward(result) * (radius / std::tan(glm::radians(kFov / 2.0)) * kSize.y / pixels);
        return result;
    }
};

struct Seen {
    std::vector<bool> covered;
    glm::dvec3 light{0}; // mean of what is covered, linear
    double luminance() const { return glm::dot(light, glm::dvec3{0.2126, 0.7152, 0.0722}); }
    int count() const { return int(std::ranges::count(covered, true)); }
};

Seen look(const Lone& lone, const io::Camera& camera, bool impostor)
{
    renderer::FrameInput in = test::frame(kSize, camera);
    in.settings.lod = impostor;
    in.settings.lodPixels = 2; // beyond all fading
    test::shared().render(in);
    const std::vector<std::uint32_t> ids = test::shared().readIds({0, 0}, kSize);
    const io::Image radiance = test::shared().readRadiance();
    Seen seen;
    for (int y = 0; y < kSize.y; ++y)
        for (int x = 0; x < kSize.x; ++x) {
            seen.covered.push_back(ids[std::size_t(y) * kSize.x + x] == io::number(lone.object));
            if (seen.covered.back()) seen.light += glm::dvec3{radiance.row<glm::vec3>(y)[x]};
        }
    seen.light /= std::max(seen.count(), 1);
    return seen;
}

bool at(const std::vector<bool>& mask, int x, int y)
{
    return x >= 0 && y >= 0 && x < kSize.x && y < kSize.y && mask[std::size_t(y) * kSize.x + x];
}

// `value` wherever a pixel or one beside it has it.
std::vector<bool> spread(const std::vector<bool>& mask, bool value)
{
    std::vector<bool> result = mask;
    for (int y = 0; y < kSize.y; ++y)
        for (int x = 0; x < kSize.x; ++x)
            for (int i = 0; i < 9; ++i)
                if (at(mask, x + i % 3 - 1, y + i / 3 - 1) == value) result[std::size_t(y) * kSize.x + x] = value;
    return result;
}

// Outlines: holes of a pixel or two are filled. Those of a crown this small are chance: the mesh itself, moved by a third
// of a pixel, has but three quarters to nine tenths of them again.
Seen outline(const Seen& seen)
{
    Seen result = seen;
    result.covered = spread(spread(seen.covered, true), false);
    return result;
}

double overlap(const Seen& a, const Seen& b)
{
    double both = 0, any = 0;
    for (std::size_t i = 0; i < a.covered.size(); ++i) {
        both += a.covered[i] && b.covered[i];
        any += a.covered[i] || b.covered[i];
    }
    return any > 0 ? both / any : 0;
}

struct Likeness {
    double overlap = 0, least = 1, light = 0, cover = 0, red = 0, blue = 0; // means; ratios are of impostor to mesh
};

Likeness compare(const Lone& lone)
{
    Likeness mean;
    constexpr int kViews = 24;
    for (int view = 0; view < kViews; ++view) {
        const io::Camera camera = lone.camera(float(view) * 360 / kViews * 5, view % 4 == 3 ? -38 : float(view % 4) * -9 + 3);
        const Seen mesh = look(lone, camera, false);
        const Seen impostor = look(lone, camera, true);
        EXPECT_EQ(test::shared().stats().trianglesDrawn, 2u);
        const double same = overlap(outline(mesh), outline(impostor));
        mean.overlap += same / kViews;
        mean.least = std::min(mean.least, same);
        mean.light += impostor.luminance() / mesh.luminance() / kViews;
        mean.cover += double(impostor.count()) / mesh.count() / kViews;
        mean.red += impostor.light.r / mesh.light.r / kViews;
        mean.blue += impostor.light.b / mesh.light.b / kViews;
    }
    std::printf("overlap %.3f (least %.3f), light %.3f, cover %.3f, red %.3f, blue %.3f\n", mean.overlap, mean.least,
                mean.light, mean.cover, mean.red, mean.blue);
    return mean;
}

void expectAlike(const Likeness& likeness, double overlap = 0.88, double cover = 0.08)
{
    EXPECT_GE(likeness.overlap, overlap - 0.04); // grain of far leaves
    EXPECT_NEAR(likeness.light, 1, 0.1); // they stand in shadows that impostors cast
    EXPECT_NEAR(likeness.cover, 1, cover + 0.05);
    EXPECT_NEAR(likeness.blue / likeness.red, 1, 0.08);
}

class Impostors : public testing::Test {
protected:
    void SetUp() override { ASSERT_TRUE(test::haveContext()); }
    void TearDown() override
    {
        EXPECT_TRUE(test::shared().shaderFaults().empty());
        EXPECT_EQ(test::shared().glErrors(), 0u);
    }
};

TEST_F(Impostors, LookLikeTheirTree)
{
    struct Tree {
        const char* name;
        double overlap, cover;
    };
    for (const Tree& tree : {Tree{"beech", 0.88, 0.08}, {"oak_old", 0.9, 0.08}, {"fir", 0.8, 0.14}, {"birch_old", 0.8, 0.1}}) {
        SCOPED_TRACE(tree.name);
        const auto model = shipped(tree.name);
        ASSERT_TRUE(model);
        expectAlike(compare(Lone{model, {}}), tree.overlap, tree.cover);
    }
}

TEST_F(Impostors, LookLikeTheirRock)
{
    const auto model = shipped("rock_mossy");
    ASSERT_TRUE(model);
    expectAlike(compare(Lone{model, {}}), 0.92);
}

TEST_F(Impostors, AreLitAsTheyAreTurned)
{
    for (const char* name : {"beech", "rock_mossy"})
        for (const glm::vec3 turn : {glm::vec3{0, 90, 0}, {0, 215, 0}, {9, 20, 6}}) {
            SCOPED_TRACE(name);
            expectAlike(compare(Lone{shipped(name), {.position = {4000, 20, -2500}, .rotation = turn}}), 0.86);
        }
}

TEST_F(Impostors, MayBeMirroredAndStretched)
{
    for (const glm::vec3 scale : {glm::vec3{-1, 1, 1}, {1.4f, 1.4f, -1.4f}, {0.8f, 1.3f, 1}, {-0.7f, 0.7f, 0.7f}})
        expectAlike(compare(Lone{shipped("oak_young"), {.rotation = {0, 40, 0}, .scale = scale}}), 0.83);
}

TEST_F(Impostors, AreSelectedAndFoundLikeMeshes)
{
    const Lone lone{shipped("rock"), {}};
    renderer::FrameInput in = test::frame(kSize, lone.camera(20, -10));
    in.settings.lodPixels = 2;
    test::shared().render(in);
    const io::Image plain = test::shared().readRadiance();
    const io::ObjectId selection[] = {lone.object};
    in.selection = selection;
    test::shared().render(in);
    const io::Image tinted = test::shared().readRadiance();
    const std::vector<std::uint32_t> ids = test::shared().readIds({0, 0}, kSize);
    EXPECT_EQ(ids[std::size_t(kSize.y) / 2 * kSize.x + kSize.x / 2], io::number(lone.object));
    for (std::size_t i = 0; i < ids.size(); ++i) {
        EXPECT_TRUE(ids[i] == 0 || ids[i] == io::number(lone.object));
        const bool differs = plain.row<glm::vec3>(0)[i] != tinted.row<glm::vec3>(0)[i];
        EXPECT_EQ(differs, ids[i] != 0) << i;
    }
}

// While they fade into one another each pixel shows the one or the other: half of each at half way, and no holes.
TEST_F(Impostors, FadeInWithoutHoles)
{
    const auto model = shipped("rock");
    const Lone lone{model, {}};
    renderer::FrameInput in = test::frame(kSize, lone.camera(20, -10));
    const Seen mesh = look(lone, in.camera, false);
    const io::Image ofMesh = test::shared().readRadiance();
    look(lone, in.camera, true);
    const io::Image ofImpostor = test::shared().readRadiance();
    double evenest = 1;
    for (float pixels = 0.5f; pixels < 2; pixels *= 1.01f) {
        in.settings.lodPixels = pixels;
        test::shared().render(in);
        const io::Image picture = test::shared().readRadiance();
        const std::vector<std::uint32_t> ids = test::shared().readIds({0, 0}, kSize);
        const auto covered = std::ranges::count(ids, io::number(lone.object));
        EXPECT_NEAR(double(covered) / mesh.count(), 1, 0.06) << pixels;
        if (test::shared().stats().trianglesDrawn != model->triangles() + 2) continue;
        double fromMesh = 0, fromImpostor = 0;
        for (std::size_t i = 0; i < ids.size(); ++i) {
            const glm::vec3 here = picture.row<glm::vec3>(0)[i], a = ofMesh.row<glm::vec3>(0)[i], b = ofImpostor.row<glm::vec3>(0)[i];
            fromMesh += here == a && a != b;
            fromImpostor += here == b && a != b;
        }
        evenest = std::min(evenest, std::abs(fromMesh - fromImpostor) / (fromMesh + fromImpostor));
    }
    EXPECT_LT(evenest, 0.2);
}

TEST_F(Impostors, ManyFarOnesAreOneCommandAndTwoTrianglesEach)
{
    Lone lone{shipped("beech"), {}};
    const io::TemplateId id = lone.world.scene.at(lone.object).templateId;
    for (int i = 0; i < 20000; ++i)
        test::addObject(lone.world, id, {.position = {(i % 200 - 100) * 6, 0, -1500 - i / 200 * 6}});
    test::load(lone.world);
    renderer::FrameInput in = test::frame({320, 180}, {.eye = {0, 60, 0}, .fov = 70});
    in.settings.shadows = false;
    in.settings.culling = false; // those too small to be seen too
    lone.world.scene.exchange(lone.object, std::nullopt);
    test::shared().update(lone.world.scene, lone.world.assets, {.objects = {lone.object}});
    test::shared().render(in); // all pictures are taken
    test::shared().render(in);
    const renderer::FrameStats with = test::shared().stats();
    test::TestWorld empty;
    empty.scene.exchange(test::plainEnvironment(150, 40));
    test::load(empty);
    test::shared().render(in);
    EXPECT_GT(with.instancesDrawn, 15000u);
    EXPECT_LE(with.drawCalls - test::shared().stats().drawCalls, 2u);
    EXPECT_EQ(with.trianglesDrawn, 2 * with.instancesDrawn);
}

TEST_F(Impostors, OnlyOfTemplatesThatAskAndOnlyWhereLevelsAreUsed)
{
    Lone lone{shipped("beech"), {}};
    const io::TemplateId id = lone.world.scene.at(lone.object).templateId;
    renderer::FrameInput in = test::frame(kSize, lone.camera(0, 0));
    in.settings.lodPixels = 2;
    const auto triangles = [&] {
        test::shared().render(in);
        return test::shared().stats().trianglesDrawn;
    };
    EXPECT_EQ(triangles(), 2u);
    in.settings.lod = false;
    EXPECT_GT(triangles(), 1000u);
    in.settings.lod = true;
    io::Template what = *lone.world.scene.find(id);
    what.impostor = false;
    lone.world.scene.exchange(id, what);
    test::shared().update(lone.world.scene, lone.world.assets, {.templates = {id}});
    EXPECT_GT(triangles(), 1000u);
    what.impostor = true;
    lone.world.scene.exchange(id, what);
    lone.world.assets.models[0] = shipped("rock"); // another model, another picture
    test::shared().update(lone.world.scene, lone.world.assets, {.templates = {id}});
    EXPECT_EQ(triangles(), 2u);
    test::shared().thumbnail(id, 64);
    EXPECT_GT(test::shared().stats().trianglesDrawn, 0u);
}

} // namespace
