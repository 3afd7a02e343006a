// The two draw paths of a world: what stands on either looks the same and costs what changed; a direct model goes with
// the last template that shows it.
#include "renderer/world.h"
#include "tests/gl/support/shared_renderer.h"

#include <algorithm>
#include <epoxy/gl.h>
#include <gtest/gtest.h>

namespace {

using io::DrawPath;

constexpr glm::ivec2 kSize{320, 180};
constexpr io::DrawPath kPaths[] = {DrawPath::Batched, DrawPath::Direct};

void choosePath(test::TestWorld& world, io::TemplateId id, DrawPath path)
{
    io::Template changed = *world.scene.find(id);
    changed.drawPath = path;
    world.scene.exchange(id, changed);
}

void chooseForAll(test::TestWorld& world, DrawPath path)
{
    for (std::size_t i = 0; i < world.scene.templates().size(); ++i)
        choosePath(world, io::TemplateId(i + 1), path);
}

// The tree with a coarser level: every other leaf card.
std::shared_ptr<const io::Model> treeWithLevels()
{
    auto model = std::make_shared<io::Model>(*test::treeModel());
    io::Level level{.error = 0.05f};
    for (const io::Part& part : model->parts) {
        const auto first = std::uint32_t(level.indices.size());
        const bool leaves = part.material == 1;
        for (std::uint32_t i = 0; i < part.indexCount; ++i)
            if (!leaves || i / 6 % 2 == 0) level.indices.push_back(model->indices[part.firstIndex + i]);
        level.parts.push_back({.firstIndex = first,
                               .indexCount = std::uint32_t(level.indices.size()) - first,
                               .material = part.material});
    }
    model->levels = {level};
    return model;
}

std::shared_ptr<const io::Model> pane(const glm::vec4& colour)
{
    auto glass = std::make_shared<io::Model>(*test::box({4, 5, 0.2f}, colour));
    glass->materials[0].alphaMode = io::AlphaMode::Blend;
    return glass;
}

// Trees of two levels, boxes, some of them mirrored, and panes of two kinds one behind the other.
struct Mixed {
    test::TestWorld world = test::makeWorld({.heightMap = {129, 129}, .trees = 150, .boxes = 40});
    std::vector<io::ObjectId> selected;

    Mixed()
    {
        world.assets.models[0] = treeWithLevels();
        const io::TemplateId red = test::addTemplate(world, "red", pane({0.9f, 0.1f, 0.1f, 0.4f}));
        const io::TemplateId blue = test::addTemplate(world, "blue", pane({0.1f, 0.2f, 0.9f, 0.4f}));
        const double ground = test::hills(0, 0);
        for (int i = 0; i < 6; ++i)
            test::addObject(world, i % 2 ? red : blue, {.position = {i * 1.0 - 3, ground + 4, -8.0 - i * 2}});
        const io::TemplateId coarse = test::addTemplate(world, "coarse", treeWithLevels()); // all of it at one level
        test::addObject(world, coarse, {.position = {10, ground + 25, -80}, .scale = glm::vec3{2}});
        for (int i = 0; i < 6; ++i)
            selected.push_back(test::addObject(world, io::TemplateId{2}, {.position = {i * 2.5 - 6, ground + 8, -4}, .scale = {-0.4, 0.4, 0.4}}));
    }
    io::Camera camera() const { return {.eye = {0, test::hills(0, 0) + 6, 12}}; }
};

struct Shown {
    std::vector<std::uint32_t> ids;
    io::Image image;
    std::uint64_t drawn = 0;
};

Shown show(const Mixed& mixed, renderer::Culler culler, renderer::Show what = renderer::Show::Final)
{
    renderer::FrameInput in = test::frame(kSize, mixed.camera());
    in.settings.culler = culler;
    in.settings.occlusion = false;
    in.selection = mixed.selected;
    in.show = what;
    for (int i = 0; i < (culler == renderer::Culler::Gpu ? 6 : 1); ++i) // counts come a little later
        test::shared().render(in);
    return {test::shared().readIds({0, 0}, kSize), test::shared().readPicture(), test::shared().stats().instancesDrawn};
}

double difference(const io::Image& a, const io::Image& b)
{
    double sum = 0;
    for (std::size_t i = 0; i < a.bytes.size(); ++i)
        sum += std::abs(int(a.bytes[i]) - int(b.bytes[i]));
    return sum / double(a.bytes.size());
}

void expectSame(const Shown& shown, const Shown& expected, const std::string& what)
{
    EXPECT_TRUE(shown.ids == expected.ids) << what;
    EXPECT_EQ(difference(shown.image, expected.image), 0) << what;
    EXPECT_EQ(shown.drawn, expected.drawn) << what;
}

TEST(Paths, LookTheSame)
{
    Mixed mixed;
    test::load(mixed.world);
    const Shown batched = show(mixed, renderer::Culler::Cpu);
    const Shown levels = show(mixed, renderer::Culler::Cpu, renderer::Show::Lod);
    EXPECT_GT(test::shared().stats().trianglesOfLevel[1], 1000u) << "some are coarse";
    for (const io::ObjectId id : mixed.selected)
        EXPECT_GT(std::ranges::count(batched.ids, io::number(id)), 20);
    chooseForAll(mixed.world, DrawPath::Direct);
    test::load(mixed.world);
    expectSame(show(mixed, renderer::Culler::Cpu), batched, "direct, culled by the CPU");
    expectSame(show(mixed, renderer::Culler::Cpu, renderer::Show::Lod), levels, "levels");
    EXPECT_GT(test::shared().stats().trianglesOfLevel[1], 1000u);
    expectSame(show(mixed, renderer::Culler::Gpu), batched, "direct, while the GPU culls");
    choosePath(mixed.world, io::TemplateId{1}, DrawPath::Batched);
    choosePath(mixed.world, io::TemplateId{3}, DrawPath::Batched);
    test::shared().update(mixed.world.scene, mixed.world.assets, {.templates = {io::TemplateId{1}, io::TemplateId{3}}});
    expectSame(show(mixed, renderer::Culler::Cpu), batched, "some of each, culled by the CPU");
    expectSame(show(mixed, renderer::Culler::Gpu), batched, "some of each, while the GPU culls");
    EXPECT_EQ(test::shared().glErrors(), 0u);
}

std::vector<glm::u8vec4> texelsOf(const renderer::Picture& picture)
{
    std::vector<glm::u8vec4> texels(std::size_t(picture.size.x) * std::size_t(picture.size.y));
    glGetTextureImage(GLuint(picture.texture), 0, GL_RGBA, GL_UNSIGNED_BYTE, GLsizei(texels.size() * 4), texels.data());
    return texels;
}

TEST(Paths, ThumbnailsAndGhostsAreTheSame)
{
    Mixed mixed;
    const std::array<renderer::Ghost, 2> ghosts{renderer::Ghost{io::TemplateId{1}, {.position = {3, test::hills(0, 0) + 3, 0}}},
                                                renderer::Ghost{io::TemplateId{2}, {.position = {-3, test::hills(0, 0) + 3, 0}}}};
    std::vector<io::Image> images;
    std::vector<std::vector<glm::u8vec4>> thumbnails;
    for (const DrawPath path : kPaths) {
        chooseForAll(mixed.world, path);
        test::load(mixed.world);
        thumbnails.push_back(texelsOf(test::shared().thumbnail(io::TemplateId{1}, 64)));
        renderer::FrameInput in = test::frame(kSize, mixed.camera());
        in.ghosts = ghosts;
        test::shared().render(in);
        images.push_back(test::shared().readPicture());
    }
    EXPECT_TRUE(images[0].bytes == images[1].bytes);
    EXPECT_TRUE(thumbnails[0] == thumbnails[1]);
    EXPECT_GT(std::ranges::count_if(thumbnails[1], [](glm::u8vec4 t) { return t.y > t.z + 20; }), 200) << "leaves";
    EXPECT_EQ(test::shared().glErrors(), 0u);
}

class PathsTest : public testing::Test {
protected:
    void SetUp() override { ASSERT_TRUE(test::haveContext()); }
};

TEST(Paths, GpuBytesFallWhenADirectModelGoes)
{
    test::TestWorld world;
    const io::TemplateId tree = test::addTemplate(world, "tree", test::treeModel());
    const io::ObjectId gone = test::addObject(world, tree, {});
    const io::ObjectId stays = test::addObject(world, test::addTemplate(world, "box", test::box({1, 1, 1}, glm::vec4{1})), {.position = {3, 0, 0}});
    chooseForAll(world, DrawPath::Direct);
    test::load(world);
    const renderer::FrameInput in = test::frame(kSize, {.eye = {0, 2, 15}});
    for (int i = 0; i < 4; ++i) // until nothing else grows
        test::shared().render(in);
    const std::uint64_t before = test::shared().stats().gpuBytes;
    const auto ids = test::shared().readIds({0, 0}, kSize);
    EXPECT_GT(std::ranges::count(ids, io::number(gone)), 20);
    world.assets.models[0] = nullptr;
    test::shared().update(world.scene, world.assets, {.templates = {tree}});
    test::shared().render(in);
    EXPECT_LT(test::shared().stats().gpuBytes + 4 * (256 * 256 + 128 * 128), before);
    const auto after = test::shared().readIds({0, 0}, kSize);
    EXPECT_EQ(std::ranges::count(after, io::number(gone)), 0);
    EXPECT_GT(std::ranges::count(after, io::number(stays)), 20);
    EXPECT_EQ(test::shared().glErrors(), 0u);
}

TEST_F(PathsTest, AModelThatBothPathsUseIsHeldTwice)
{
    test::TestWorld world;
    const auto model = test::box({1, 1, 1}, glm::vec4{1});
    const io::TemplateId batched = test::addTemplate(world, "batched", model);
    const io::TemplateId direct = test::addTemplate(world, "direct", model), again = test::addTemplate(world, "again", model);
    for (const io::TemplateId id : {direct, again})
        choosePath(world, id, DrawPath::Direct);
    std::vector<io::ObjectId> objects;
    for (const io::TemplateId id : {batched, direct, again})
        objects.push_back(test::addObject(world, id, {}));
    renderer::World gpu;
    gpu.update(world.scene, world.assets, {.everything = true});
    EXPECT_EQ(gpu.sharedModels().size(), 1);
    EXPECT_EQ(gpu.directModels(), 1u) << "two templates of it share it";
    EXPECT_NE(gpu.modelOf(batched).library, gpu.modelOf(direct).library);
    EXPECT_NE(gpu.modelOf(batched).library->vertices(), gpu.modelOf(direct).library->vertices());
    EXPECT_EQ(gpu.handleOf(objects[0]).path(), DrawPath::Batched);
    EXPECT_EQ(gpu.handleOf(objects[1]).path(), DrawPath::Direct);

    choosePath(world, direct, DrawPath::Batched);
    gpu.update(world.scene, world.assets, {.templates = {direct}});
    EXPECT_EQ(gpu.directModels(), 1u) << "the other one shows it still";
    EXPECT_EQ(gpu.handleOf(objects[1]).path(), DrawPath::Batched);
    choosePath(world, again, DrawPath::Batched);
    gpu.update(world.scene, world.assets, {.templates = {again}});
    EXPECT_EQ(gpu.directModels(), 0u);
    EXPECT_EQ(gpu.instances(), 3u);
}

TEST_F(PathsTest, MovingOneDirectObjectUploadsOneRecord)
{
    test::TestWorld world = test::makeWorld({.heightMap = {0, 0}, .trees = 3000, .boxes = 5});
    chooseForAll(world, DrawPath::Direct);
    renderer::World gpu;
    gpu.update(world.scene, world.assets, {.everything = true});
    gpu.upload(false);
    const auto uploaded = [&, before = gpu.uploadedBytes()] { return gpu.uploadedBytes() - before; };
    const io::ObjectId id = world.scene.objects()[1234].id;
    io::Object moved = world.scene.at(id);
    moved.transform.position.x += 1;
    world.scene.exchange(id, moved);
    gpu.update(world.scene, world.assets, {.objects = {id}});
    gpu.upload(false);
    EXPECT_EQ(uploaded(), sizeof(glsl::Instance));

    gpu.select({&id, 1});
    gpu.upload(true);
    EXPECT_EQ(uploaded(), 2 * sizeof(glsl::Instance)) << "its tint";

    world.scene.exchange(id, std::nullopt);
    gpu.update(world.scene, world.assets, {.objects = {id}});
    gpu.upload(true);
    EXPECT_EQ(uploaded(), 3 * sizeof(glsl::Instance)) << "the last one took its place";
    EXPECT_EQ(gpu.instances(), 3004u);
}

TEST_F(PathsTest, ADirectModelIsOneInstancedDrawFromItsOwnBuffer)
{
    test::TestWorld world;
    const io::TemplateId tree = test::addTemplate(world, "tree", test::treeModel()); // two parts
    for (int i = 0; i < 200; ++i)
        test::addObject(world, tree, {.position = {i * 3.0, 0, 0}});
    chooseForAll(world, DrawPath::Direct);
    renderer::World gpu;
    gpu.update(world.scene, world.assets, {.everything = true});
    gpu.upload(false);
    renderer::GpuStream stream;
    stream.beginFrame();
    std::vector<renderer::DrawList> lists;
    gpu.batchedDraws(stream, {}, true, lists);
    EXPECT_TRUE(lists.empty());
    gpu.directDraws(stream, {}, true, lists);
    ASSERT_EQ(lists.size(), 1u);
    ASSERT_EQ(lists[0].calls.size(), 2u);
    for (const renderer::DrawCommand& call : lists[0].calls)
        EXPECT_EQ(call.instanceCount, 200u);
    EXPECT_EQ(lists[0].instances.bytes.size(), 0u) << "nothing is copied where all are drawn as they are";

    renderer::CullRequest few;
    few.eye = {0, 0, 0};
    few.smallestAngle = 0.01f; // the far ones are too small
    gpu.directDraws(stream, few, true, lists);
    ASSERT_EQ(lists.size(), 2u);
    EXPECT_EQ(lists[1].calls.size(), 2u);
    EXPECT_LT(lists[1].visible, 200u);
    stream.endFrame();
}

} // namespace
