#include "tests/projects/shipped.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace {

const tests::Shipped& valley()
{
    return tests::shipped("valley");
}

TEST(Valley, IsTwoKilometresWideAtOneMetre)
{
    const io::HeightMap& heights = *valley().scene().heights();
    EXPECT_EQ(heights.size, glm::ivec2{2049});
    EXPECT_EQ(heights.metresPerTexel, 1);
    EXPECT_EQ(heights.origin, glm::dvec2{-1024});
    EXPECT_GT(heights.max - heights.min, 300);
}

TEST(Valley, HasModelsOfEveryKindItPromises)
{
    std::size_t models = 0;
    for (const io::Scene::TemplateSlot& slot : valley().scene().templates())
        models += slot.value && !slot.value->model.empty();
    EXPECT_GE(models, 14u);
    for (const char* name :
         {"oak_young",    "oak",         "oak_old",     "oak_autumn", "birch_young",  "birch",     "birch_old",
          "birch_autumn", "beech_young", "beech",       "beech_old",  "beech_autumn", "fir_young", "fir",
          "fir_old",      "dead_tree",   "dead_branch", "stump",      "stump_broken", "rock",      "bush",
          "axe",          "campfire",    "tent",        "hut",        "fence"}) {
        const io::TemplateId id = valley().scene().findTemplate(name);
        ASSERT_NE(id, io::TemplateId::None) << name;
        const auto copies = std::ranges::count(valley().scene().objects(), id, &io::Object::templateId);
        EXPECT_GT(copies, 0) << name << " stands nowhere";
        for (const auto& image : valley().assets.model(id)->images)
            EXPECT_NE(image, nullptr) << name;
    }
}

TEST(Valley, HoldsSomeFiveThousandObjectsAndAsManyTreesAsInstances)
{
    EXPECT_GT(valley().scene().objects().size(), 4500u); // its tufts and flowers are grass
    EXPECT_LT(valley().scene().objects().size(), 5600u);
    EXPECT_GT(valley().scene().instanceCount(), 4000u);
    EXPECT_LT(valley().scene().instanceCount(), 5000u);
}

TEST(Valley, EverythingStandsOnTheGround)
{
    for (const io::Object& object : valley().scene().objects()) {
        const io::Template* what = valley().scene().find(object.templateId);
        if (!what || object.name == "Axe") continue; // the axe is struck into its block
        const io::Model* model = valley().assets.model(object.templateId);
        const float bottom = what->model.empty() ? 0 : model->bounds.min.y;
        const io::HeightMap& heights = *valley().scene().heights();
        const glm::dquat turn = io::orientation(object.transform.rotation);
        const glm::dvec3 foot = object.transform.position + turn * glm::dvec3{0, bottom * object.transform.scale.y, 0};
        const glm::dvec3 up =
            what->alignToGround ? heights.normal(foot.x, foot.z).value_or(glm::dvec3{0, 1, 0}) : glm::dvec3{0, 1, 0};
        const glm::dvec3 rests = foot + up * double(what->sink);
        const auto ground = heights.height(rests.x, rests.z);
        ASSERT_TRUE(ground) << what->name << " " << number(object.id) << " stands outside the world";
        EXPECT_NEAR(rests.y, *ground, 0.08) << what->name << " " << number(object.id);
    }
}

TEST(Valley, NoTwoTrunksOverlap)
{
    std::vector<glm::dvec2> trunks;
    for (const io::Object& object : valley().scene().objects()) {
        const io::Template* what = valley().scene().find(object.templateId);
        if (what && what->category == "Trees")
            trunks.emplace_back(object.transform.position.x, object.transform.position.z);
    }
    EXPECT_GT(trunks.size(), 2000u);
    std::sort(trunks.begin(), trunks.end(), [](const glm::dvec2& a, const glm::dvec2& b) { return a.x < b.x; });
    for (std::size_t i = 0; i < trunks.size(); ++i)
        for (std::size_t j = i + 1; j < trunks.size() && trunks[j].x - trunks[i].x < 1.5; ++j)
            EXPECT_GT(glm::length(trunks[i] - trunks[j]), 1.5) << "at " << trunks[i].x << ", " << trunks[i].y;
}

TEST(Valley, HasViewsAndAFlight)
{
    EXPECT_GE(valley().scene().cameras().size(), 5u);
    for (const char* name : {"overview", "camp", "stream", "forest edge", "ridge"})
        EXPECT_NE(valley().scene().findCamera(name), nullptr) << name;
    EXPECT_NE(valley().scene().findPath("fly"), nullptr);
}

} // namespace
