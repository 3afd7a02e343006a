#include "tests/projects/shipped.h"

#include <gtest/gtest.h>

namespace {

class EveryWorld : public testing::TestWithParam<const char*> {};

TEST_P(EveryWorld, OpensWithoutAComplaint)
{
    for (const io::Complaint& complaint : tests::shipped(GetParam()).complaints)
        ADD_FAILURE() << complaint.where << ": " << complaint.what;
}

TEST_P(EveryWorld, HasGroundLayersAndACameraAboveIt)
{
    const tests::Shipped& world = tests::shipped(GetParam());
    ASSERT_NE(world.scene().heights(), nullptr);
    EXPECT_GE(world.scene().terrain().layers.size(), 4u);
    EXPECT_FALSE(world.scene().cameras().empty());
    for (const io::Camera& camera : world.scene().cameras()) {
        const auto ground = world.scene().heights()->height(camera.eye.x, camera.eye.z);
        ASSERT_TRUE(ground) << camera.name << " looks from outside the world";
        EXPECT_GT(camera.eye.y, *ground + 1) << camera.name;
    }
}

TEST_P(EveryWorld, FliesAboveTheGroundAllAlongItsPaths)
{
    const tests::Shipped& world = tests::shipped(GetParam());
    for (const io::CameraPath& path : world.scene().paths()) {
        EXPECT_GE(io::duration(path), 20) << path.name;
        EXPECT_LE(io::duration(path), 30) << path.name;
        for (double t = 0; t < io::duration(path); t += 0.1) {
            const glm::dvec3 eye = io::sample(path, t).eye;
            const auto ground = world.scene().heights()->height(eye.x, eye.z);
            ASSERT_TRUE(ground) << path.name << " leaves the world at " << t << " s";
            EXPECT_GT(eye.y, *ground + 2) << path.name << " at " << t << " s";
        }
    }
}

TEST_P(EveryWorld, NamesEveryTemplateOfItsObjects)
{
    const tests::Shipped& world = tests::shipped(GetParam());
    for (const io::Object& object : world.scene().objects())
        if (object.templateId != io::TemplateId::None) {
            EXPECT_NE(world.scene().find(object.templateId), nullptr) << number(object.id);
        }
}

TEST(Shipped, AllWorldsTogetherStayUnderFortyMegabytes)
{
    std::uintmax_t bytes = 0;
    for (const char* name : {"valley", "forest-1", "forest-2", "forest-3", "empty"})
        for (const auto& entry :
             std::filesystem::recursive_directory_iterator{std::filesystem::path{WOLD_SOURCE_DIR} / "projects" / name})
            bytes += entry.is_regular_file() ? entry.file_size() : 0;
    EXPECT_LT(bytes, 40000000u);
}

INSTANTIATE_TEST_SUITE_P(Shipped, EveryWorld, testing::Values("valley", "forest-1", "forest-2", "forest-3", "empty"),
                         [](const auto& world) {
                             std::string name = world.param;
                             std::erase(name, '-');
                             return name;
                         });

} // namespace
