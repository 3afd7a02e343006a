// More than there is room for, and what cannot be drawn: room is made, or it is left out and said; OpenGL hears nothing of it.
#include "io/base/log.h"
#include "renderer/choosing.h"
#include "tests/gl/support/shared_renderer.h"

#include <gtest/gtest.h>
#include <limits>

namespace {

using renderer::Culler;

constexpr glm::ivec2 kSize{320, 180};
constexpr double kInfinite = std::numeric_limits<double>::infinity();

TEST(Overflow, TheStreamHoldsWhateverAFrameTakes)
{
    ASSERT_TRUE(test::haveContext());
    renderer::GpuStream stream;
    for (std::uint32_t frame = 0; frame < 7; ++frame) {
        stream.beginFrame();
        std::vector<renderer::GpuStream::Piece> pieces;
        for (std::uint32_t i = 0; i < 12; ++i) { // of a first megabyte twelve times 700 kB
            const std::vector<std::uint32_t> words(175'000, frame * 100 + i);
            pieces.push_back(stream.put(std::span<const std::uint32_t>{words}));
        }
        EXPECT_EQ(stream.taken(), 12u * 700'000);
        for (std::uint32_t i = 0; i < pieces.size(); ++i) {
            std::vector<std::uint32_t> held(175'000);
            glGetNamedBufferSubData(pieces[i].buffer, GLintptr(pieces[i].offset), 700'000, held.data());
            EXPECT_EQ(held.front(), frame * 100 + i);
            EXPECT_EQ(held.back(), frame * 100 + i);
            if (frame >= 3) {
                EXPECT_EQ(pieces[i].buffer, pieces[0].buffer) << "one piece of memory by now";
            }
        }
        stream.endFrame();
    }
    EXPECT_EQ(glGetError(), GLenum(GL_NO_ERROR));
}

// Boxes side by side, seen from above.
class ManyBoxes {
public:
    ManyBoxes() : m_box{test::addTemplate(m_world, "box", test::box({1, 1, 1}, glm::vec4{1}))} { test::load(m_world); }

    void add(int count)
    {
        io::Changes changes;
        for (int i = 0; i < count; ++i, ++m_count)
            changes.objects.push_back(
                test::addObject(m_world, m_box, {.position = {(m_count % 200 - 100) * 1.6, 0, (m_count / 200 - 80) * 1.6}}));
        test::shared().update(m_world.scene, m_world.assets, changes);
    }
    renderer::FrameInput frame() const
    {
        renderer::FrameInput in = test::frame(kSize, {.eye = {0, 270, 0}, .pitch = -90});
        in.show = renderer::Show::Id;
        in.settings.shadows = false;
        return in;
    }
    test::TestWorld& world() { return m_world; }

private:
    test::TestWorld m_world;
    io::TemplateId m_box;
    int m_count = 0;
};

void expectAllDrawn(renderer::FrameInput in, std::uint64_t count)
{
    in.settings.culler = Culler::Gpu;
    for (int i = 0; i < 12; ++i) // until what the GPU counted has come, and room was made
        test::shared().render(in);
    EXPECT_EQ(test::shared().stats().instancesDrawn, count);
    const auto ids = test::shared().readIds({0, 0}, in.size);
    in.settings.culler = Culler::Cpu;
    test::shared().render(in);
    EXPECT_TRUE(ids == test::shared().readIds({0, 0}, in.size));
}

TEST(Overflow, TheGpusListsGrowWithWhatIsInView)
{
    ManyBoxes boxes; // there is room for 16,384 at first
    boxes.add(20'000);
    for (const bool occlusion : {false, true}) {
        renderer::FrameInput in = boxes.frame();
        in.settings.occlusion = occlusion;
        expectAllDrawn(in, 20'000);
    }
    EXPECT_EQ(test::shared().glErrors(), 0u);
}

TEST(Overflow, TheGpusListsGrowWithWhatComesLittleByLittle)
{
    ManyBoxes boxes; // few come into sight at a time, so that only the list of what was seen before becomes too long
    boxes.add(30'000);
    expectAllDrawn(boxes.frame(), 30'000);
    boxes.add(2'000); // there is room for 32,768
    expectAllDrawn(boxes.frame(), 32'000);
    boxes.add(1'000);
    expectAllDrawn(boxes.frame(), 33'000);
    EXPECT_EQ(test::shared().glErrors(), 0u);
}

TEST(Overflow, WhatIsMoreThanTheMostIsLeftOutAndSaid)
{
    ASSERT_TRUE(test::haveContext());
    ManyBoxes boxes;
    boxes.add(500);
    renderer::World gpu;
    gpu.update(boxes.world().scene, boxes.world().assets, {.everything = true});
    gpu.upload(true);
    renderer::CullTable table;
    table.update(gpu.sharedModels());
    renderer::ShaderLibrary shaders{WOLD_SOURCE_DIR "/renderer/shaders"};
    renderer::CulledView view{shaders, 64};
    renderer::GpuStream stream;
    renderer::PassTimers timers;
    renderer::FrameStats stats;
    const renderer::gl::VertexArray empty{"none"};
    const auto before = io::log::linesAfter(0);
    for (int frame = 0; frame < 6; ++frame) {
        renderer::GpuFrame made{stream, timers, stats, empty};
        const renderer::DrawList list = view.all(made, table, gpu.gpuScene(), {});
        std::vector<renderer::DrawCommand> commands(table.partCount());
        glGetNamedBufferSubData(list.commands.buffer, 0, GLsizeiptr(commands.size() * sizeof(commands[0])), commands.data());
        std::uint32_t drawn = 0;
        for (const renderer::DrawCommand& command : commands) {
            drawn += command.instanceCount;
            EXPECT_LE(command.baseInstance + command.instanceCount, 64u);
        }
        EXPECT_EQ(drawn, 64u);
        glFinish();
    }
    EXPECT_EQ(view.counts().copies, 500u);
    int said = 0;
    for (const io::log::Line& line : io::log::linesAfter(before.empty() ? 0 : before.back().number))
        said += line.level == io::log::Level::Warning && line.text.find("500 instances are in view, 64 are drawn") != line.text.npos;
    EXPECT_EQ(said, 1);
    EXPECT_EQ(glGetError(), GLenum(GL_NO_ERROR));
}

std::shared_ptr<const io::Model> withoutTriangles()
{
    io::Model model = io::boxModel({1, 1, 1}, glm::vec4{1});
    model.indices.clear();
    model.parts[0].indexCount = 0;
    return std::make_shared<io::Model>(std::move(model));
}

std::shared_ptr<const io::Model> withoutEnd()
{
    io::Model model = io::boxModel({1, 1, 1}, glm::vec4{1});
    model.vertices[0].position.y = std::numeric_limits<float>::infinity();
    model.bounds.add(model.vertices[0].position);
    return std::make_shared<io::Model>(std::move(model));
}

class Undrawable : public testing::TestWithParam<Culler> {};

// What files hold of these is mended and said while they are read (unit_files); what comes past that is not drawn.
TEST_P(Undrawable, IsSkipped)
{
    test::TestWorld world;
    const io::TemplateId box = test::addTemplate(world, "box", test::box({1, 1, 1}, glm::vec4{0.6f, 0.2f, 0.2f, 1}));
    const io::ObjectId sound = test::addObject(world, box, {.position = {0, 0, -6}});
    world.scene.exchange(test::plainEnvironment(150, 50));
    test::load(world);
    renderer::FrameInput in = test::frame(kSize, {.eye = {0, 1, 0}});
    in.settings.culler = GetParam();
    test::shared().render(in);
    const io::Image alone = test::shared().readPicture();

    const io::TemplateId nothing = test::addTemplate(world, "nothing", withoutTriangles()),
                         endless = test::addTemplate(world, "endless", withoutEnd());
    const auto nan = float(NAN), infinite = float(kInfinite);
    const io::Transform bad[] = {{.position = {1, 0, -6}, .scale = {1, 0, 1}},      {.position = {NAN, 0, -6}},
                                 {.position = {1, 0, -6}, .scale = {nan, 1, 1}},    {.position = {0, kInfinite, -6}},
                                 {.position = {1, 0, -6}, .rotation = {0, nan, 0}}, {.position = {1, 0, -6}, .scale = {infinite, 1, 1}}};
    for (const io::Transform& transform : bad)
        test::addObject(world, box, transform);
    test::addObject(world, nothing, {.position = {1, 0, -6}});
    test::addObject(world, endless, {.position = {1, 0, -6}});
    test::load(world);
    for (const bool culling : {true, false}) {
        in.settings.culling = culling;
        for (int frame = 0; frame < 3; ++frame)
            test::shared().render(in);
        EXPECT_TRUE(alone.bytes == test::shared().readPicture().bytes) << "culling " << culling;
    }
    world.scene.exchange(sound, io::Object{.id = sound, .templateId = box, .transform = {.position = {0, NAN, -6}}});
    test::shared().update(world.scene, world.assets, {.objects = {sound}}); // goes bad while it is shown
    test::shared().render(in);
    for (const std::uint32_t id : test::shared().readIds({0, 0}, kSize))
        ASSERT_EQ(id, 0u);
    EXPECT_EQ(test::shared().glErrors(), 0u);
}

INSTANTIATE_TEST_SUITE_P(Cullers, Undrawable, testing::Values(Culler::Cpu, Culler::Gpu),
                         [](const auto& one) { return one.param == Culler::Cpu ? "Cpu" : "Gpu"; });

} // namespace
