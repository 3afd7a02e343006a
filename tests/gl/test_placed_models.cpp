// One handle for instances of both draw paths, misuse that is an error in words, and direct models that are unloaded alone.
#include "renderer/gl/handle.h"
#include "renderer/placed_models.h"
#include "tests/gl/support/shared_renderer.h"

#include <gtest/gtest.h>

namespace {

using io::DrawPath;
using renderer::InstanceHandle;
using renderer::PlacedModels;

constexpr io::DrawPath kPaths[] = {DrawPath::Batched, DrawPath::Direct};

class PlacedModelsTest : public testing::Test {
protected:
    void SetUp() override { ASSERT_TRUE(test::haveContext()); }
};

TEST_F(PlacedModelsTest, OneHandleMovesTintsAndRemovesOnBoth)
{
    for (const DrawPath path : kPaths) {
        PlacedModels models{path};
        const int box = models.registerModel(test::box({1, 1, 1}, glm::vec4{1}));
        std::vector<InstanceHandle> handles;
        for (int i = 0; i < 5; ++i) {
            auto added = models.add({.model = box, .transform = {.position = {double(i), 0, 0}}});
            ASSERT_TRUE(added);
            EXPECT_EQ(added->path(), path);
            handles.push_back(*added);
        }
        ASSERT_TRUE(models.remove(handles[1])); // the last one stands in its row now
        ASSERT_TRUE(models.move(handles[4], {.model = box, .transform = {.position = {40, 0, 0}}}));
        ASSERT_TRUE(models.tint(handles[4], renderer::Tint::Selected));
        EXPECT_FLOAT_EQ(models.find(handles[4])->centre.x, 40);
        EXPECT_FLOAT_EQ(models.find(handles[3])->centre.x, 3);
        EXPECT_EQ(models.instances(), 4u);
        const auto again = models.add({.model = box});
        ASSERT_TRUE(again);
        EXPECT_EQ(again->slot, handles[1].slot) << "slots are used again";
        EXPECT_NE(*again, handles[1]);
        EXPECT_EQ(models.find(handles[1]), nullptr);
        EXPECT_FLOAT_EQ(models.find(handles[4])->centre.x, 40) << "it stands where it stood";
    }
}

void expectError(const io::Status& status, std::string_view text)
{
    ASSERT_FALSE(status);
    EXPECT_NE(status.error().text().find(text), std::string::npos) << status.error().text();
}

TEST_F(PlacedModelsTest, MisuseIsAnErrorThatSaysSo)
{
    for (const DrawPath path : kPaths) {
        PlacedModels models{path}, others{path == DrawPath::Direct ? DrawPath::Batched : DrawPath::Direct};
        const auto model = test::box({1, 1, 1}, glm::vec4{1});
        const int box = models.registerModel(model), ball = models.registerModel(test::box({2, 2, 2}, glm::vec4{1}));
        const InstanceHandle one = *models.add({.model = box, .transform = {.position = {7, 0, 0}}});
        for (const int unknown : {-1, 9}) {
            const auto added = models.add({.model = unknown});
            ASSERT_FALSE(added);
            EXPECT_NE(added.error().text().find("never registered"), std::string::npos) << added.error().text();
        }
        const int other = others.registerModel(model);
        const InstanceHandle theirs = *others.add({.model = other});
        const renderer::Placement there{.model = box, .transform = {.position = {1, 2, 3}}};
        for (const auto& [handle, text] : {std::pair{theirs, "ask the path that gave"}, {InstanceHandle{}, "never given"}}) {
            expectError(models.move(handle, there), text);
            expectError(models.tint(handle, renderer::Tint::Selected), text);
            expectError(models.remove(handle), text);
        }
        expectError(models.move(one, {.model = ball}), "remove it and add another");
        EXPECT_EQ(models.instances(), 1u);
        ASSERT_NE(models.find(one), nullptr);
        EXPECT_FLOAT_EQ(models.find(one)->centre.x, 7) << "nothing changed";
        ASSERT_TRUE(models.remove(one));
        expectError(models.move(one, there), "stale");
        expectError(models.tint(one, renderer::Tint::Selected), "stale");
        expectError(models.remove(one), "stale");
        expectError(models.unload(9), "never registered");
        const InstanceHandle two = *models.add({.model = box});
        if (path == DrawPath::Batched) {
            expectError(models.unload(box), "cannot be unloaded alone");
            EXPECT_NE(models.find(two), nullptr);
        } else {
            ASSERT_TRUE(models.unload(box));
            expectError(models.remove(two), "stale");
            expectError(models.unload(box), "unloaded");
            ASSERT_FALSE(models.add({.model = box}));
            EXPECT_TRUE(models.add({.model = ball})) << "the other one stays";
        }
    }
}

TEST_F(PlacedModelsTest, UnloadingFreesAllThatAModelHolds)
{
    PlacedModels models{DrawPath::Direct};
    const int box = models.registerModel(test::box({1, 1, 1}, glm::vec4{1}));
    ASSERT_TRUE(models.add({.model = box}));
    models.uploadInstances({.records = true});
    const std::uint64_t before = renderer::gl::Footprint::total();
    const int tree = models.registerModel(test::treeModel());
    const std::uint64_t withTree = renderer::gl::Footprint::total();
    EXPECT_GT(withTree, before + 4 * (256 * 256 + 128 * 128)) << "its textures";
    const int twin = models.registerModel(test::treeModel()); // the same pictures, read once more
    EXPECT_LT(renderer::gl::Footprint::total() - withTree, 200'000u) << "pictures are held once";
    for (int i = 0; i < 100; ++i)
        ASSERT_TRUE(models.add({.model = i % 2 ? tree : twin}));
    models.uploadInstances({.records = true});
    ASSERT_TRUE(models.unload(tree));
    EXPECT_GT(renderer::gl::Footprint::total(), before + 4 * (256 * 256 + 128 * 128)) << "the twin shows them still";
    ASSERT_TRUE(models.unload(twin));
    EXPECT_EQ(renderer::gl::Footprint::total(), before);
    EXPECT_EQ(models.instances(), 1u);
    EXPECT_EQ(models.registerModel(test::box({1, 1, 1}, glm::vec4{1})), 3) << "numbers are not used again";
}

} // namespace
