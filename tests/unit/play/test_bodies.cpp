#include "stage.h"

#include "app/play/session.h"
#include "io/base/random.h"
#include "io/scene/ground.h"

#include <gtest/gtest.h>

namespace play {
namespace {

constexpr double kSide = 0.8; // m, of a crate

io::Model crateModel(double side = kSide)
{
    return io::boxModel(glm::vec3{float(side)}, glm::vec4{1}); // stands on its origin
}

struct Play : testing::Test {
    test::Stage stage;
    io::TemplateId crate = io::TemplateId::None;
    std::unique_ptr<Session> session;

    void SetUp() override { stage.setGround([](double, double) { return 0; }); }
    io::TemplateId addCrate(io::Collision collision = io::Collision::Box, float mass = 25)
    {
        const io::TemplateId id = stage.addTemplate("crate" + std::to_string(stage.scene.templates().size()), collision, crateModel(), true);
        io::Template value = *stage.scene.find(id);
        value.body.mass = mass;
        stage.scene.exchange(id, value);
        return id;
    }
    void begin(double x = 0, double z = 0) { session = std::make_unique<Session>(stage.scene, stage.assets, io::Camera{.eye = {x, 1.7, z}}); }
    void run(int steps, const Wish& wish = {})
    {
        for (int i = 0; i < steps; ++i)
            session->step(wish);
    }
    const io::Transform& at(io::ObjectId id) { return session->scene().at(id).transform; }
    glm::dvec3 centre(io::ObjectId id) { return glm::dvec3{io::worldFromModel(at(id)) * glm::dvec4{0, kSide / 2, 0, 1}}; }
    // m that the corners of a crate lie below the ground at most.
    double sunk(io::ObjectId id)
    {
        double deepest = -1e9;
        for (int i = 0; i < 8; ++i) {
            const glm::dvec3 corner = glm::dvec3{io::worldFromModel(at(id)) * glm::dvec4{kSide / 2 * (i & 1 ? 1 : -1), i & 2 ? kSide : 0, kSide / 2 * (i & 4 ? 1 : -1), 1}};
            deepest = std::max(deepest, io::groundHeight(session->scene(), corner.x, corner.z).value_or(-1e9) - corner.y);
        }
        return deepest;
    }
};

TEST_F(Play, ACrateFallsAndComesToRestOnTheGround)
{
    for (const io::Collision collision : {io::Collision::Box, io::Collision::Hull, io::Collision::Mesh, io::Collision::None}) {
        SetUp();
        stage.scene = {};
        stage.assets = {};
        SetUp();
        const io::ObjectId id = stage.place(addCrate(collision), {0, 3, -5}, {20, 30, 10});
        begin();
        run(400);
        EXPECT_EQ(session->bodies().awake(), 0u);
        EXPECT_NEAR(sunk(id), 0, 0.01) << int(collision);
        const glm::dmat3 turn = glm::mat3_cast(io::orientation(at(id).rotation));
        EXPECT_GT(std::max({std::abs(turn[0].y), std::abs(turn[1].y), std::abs(turn[2].y)}), 0.9999); // on one of its sides
        const io::Transform rest = at(id);
        run(60);
        EXPECT_EQ(at(id), rest);
    }
}

TEST_F(Play, BetweenStepsItIsBetweenTheTwoPlaces)
{
    const io::ObjectId id = stage.place(addCrate(), {0, 3, -5}, {20, 30, 10});
    begin();
    run(20);
    const io::Transform before = at(id);
    run(1);
    const io::Transform now = at(id);
    ASSERT_LT(now.position.y, before.position.y - 0.01);
    for (const double share : {0.0, 0.25, 1.0}) {
        const std::vector<io::Moved> between = session->between(share);
        ASSERT_EQ(between.size(), 1u);
        EXPECT_EQ(between[0].id, id);
        EXPECT_NEAR(between[0].transform.position.y, glm::mix(before.position.y, now.position.y, share), 1e-9);
        EXPECT_EQ(between[0].transform.scale, now.scale);
    }
    EXPECT_LT(glm::distance(session->between(0)[0].transform.rotation, before.rotation), 1e-3f);
    EXPECT_EQ(at(id), now); // the world is as it was stepped
    run(400);
    EXPECT_TRUE(session->between(0.5).empty()) << "it has come to rest";
}

TEST_F(Play, OnASlopeItStaysUnlessThatIsSteep)
{
    stage.setGround([](double x, double) { return x * (x > 0 ? 0.25 : 1.2); });
    const io::TemplateId id = addCrate();
    const io::ObjectId gentle = stage.place(id, {8, 3.5, -5}), steep = stage.place(id, {-8, -8, 5});
    begin(0, 20);
    run(420);
    EXPECT_NEAR(at(gentle).position.x, 8, 1);
    EXPECT_LT(at(steep).position.x, -14);
    EXPECT_LT(sunk(gentle), 0.015);
    EXPECT_LT(sunk(steep), 0.015);
}

TEST_F(Play, ThePlayerPushesWhatIsLightAndIsStoppedByWhatIsHeavy)
{
    const io::ObjectId light = stage.place(addCrate(io::Collision::Box, 25), {0, 0, -3}), heavy = stage.place(addCrate(io::Collision::Box, 4000), {6, 0, -3});
    begin();
    run(240, {.move = {0, 1}});
    EXPECT_LT(at(light).position.z, -5);
    EXPECT_LT(session->walker().feet().z, -4);
    EXPECT_LT(session->walker().depth(session->surroundings()), 0.005);
    begin(6, 0);
    run(240, {.move = {0, 1}});
    EXPECT_NEAR(at(heavy).position.z, -3, 0.05);
    EXPECT_GT(session->walker().feet().z, -2.5);
}

TEST_F(Play, ItCarriesThePlayer)
{
    const io::ObjectId raft = stage.place(addCrate(io::Collision::Box, 400), {0, 0, 0}, {0, 0, 0}, {4, 0.5f, 4});
    begin(0, 0);
    run(90);
    ASSERT_EQ(session->walker().ground(), raft);
    const glm::dvec3 on = session->walker().feet() - at(raft).position;
    session->bodies().setVelocity(raft, {4, 0, 0});
    for (int i = 0; i < 150; ++i) {
        run(1);
    }
    EXPECT_GT(at(raft).position.x, 0.8);
    EXPECT_LT(glm::length(session->walker().feet() - at(raft).position - on), 0.1);
    EXPECT_EQ(session->walker().ground(), raft);
}

TEST_F(Play, ThrownAtAWallItDoesNotGetThrough)
{
    const io::TemplateId crate = addCrate(), hull = addCrate(io::Collision::Hull);
    const io::TemplateId wall = stage.addTemplate("wall", io::Collision::Mesh, io::boxModel({60, 20, 0.05f}, glm::vec4{1})), thin = stage.addBox({0.05f, 20, 60});
    stage.place(wall, {0, 0, -20});
    stage.place(thin, {20, 0, 0});
    std::vector<io::ObjectId> ids;
    for (int i = 0; i < 6; ++i)
        ids.push_back(stage.place(i % 2 ? crate : hull, {-5.0 + 1.5 * i, 1, 3.1 * i - 10 + 0.01 * i}));
    begin(-20, 20);
    for (const glm::dvec3& velocity : {glm::dvec3{0, 0, -100}, glm::dvec3{100, 0, 0}, glm::dvec3{0, -100, 0}, glm::dvec3{70, 0, -70}}) {
        begin(-20, 20);
        run(1);
        for (const io::ObjectId id : ids)
            session->bodies().setVelocity(id, velocity);
        for (int i = 0; i < 120; ++i) {
            run(1);
            for (const io::ObjectId id : ids) {
                ASSERT_GT(centre(id).z, -20) << velocity.x << ' ' << velocity.z;
                ASSERT_LT(centre(id).x, 20) << velocity.x << ' ' << velocity.z;
                ASSERT_LT(sunk(id), 0.03);
            }
        }
    }
}

TEST_F(Play, APileSettlesAndNothingSinksIntoTheGroundOrIntoEachOther)
{
    stage.setGround([](double x, double z) { return std::sin(x * 0.3) + std::cos(z * 0.4); });
    const io::TemplateId crate = addCrate(), hull = addCrate(io::Collision::Hull);
    std::vector<io::ObjectId> ids;
    io::Random random{4};
    for (int i = 0; i < 200; ++i)
        ids.push_back(stage.place(i % 4 ? crate : hull, {i % 5 * 0.9 + random.range(-0.1f, 0.1f), 2.5 + i / 25 * 1.2, i / 5 % 5 * 0.9}, {random.range(0, 360), random.range(0, 360), 0}));
    begin(20, 20);
    double deepest = 0;
    for (int i = 0; i < 1200; ++i) {
        run(1);
        for (const io::ObjectId id : ids)
            deepest = std::max(deepest, sunk(id));
    }
    EXPECT_LT(deepest, 0.02);
    EXPECT_EQ(session->bodies().awake(), 0u);
    double inside = 0;
    for (const io::ObjectId id : ids)
        inside = std::max(inside, session->bodies().depth(id));
    EXPECT_LT(inside, 0.015);
}

TEST_F(Play, AHoleLetsItThroughAndItComesBackFromOutOfTheWorld)
{
    std::vector<std::uint32_t> cover(65 * 65, 0);
    for (int z = 28; z < 36; ++z)
        for (int x = 28; x < 36; ++x)
            cover[std::size_t(z * 65 + x)] = io::kHoleBit;
    stage.scene.exchange(std::make_shared<const io::CoverMap>(glm::ivec2{65, 65}, cover));
    const io::ObjectId over = stage.place(addCrate(), {0, 2, 0}), beside = stage.place(addCrate(), {8, 2, 0});
    begin(15, 0);
    run(120);
    EXPECT_LT(at(over).position.y, -5);
    EXPECT_NEAR(at(beside).position.y, 0, 0.01);
    run(900);
    EXPECT_LT(sunk(beside), 0.01);
    EXPECT_GT(at(over).position.y, -250); // again and again
}

TEST_F(Play, TheSameInputIsTheSameToTheLastBitAndTheDocumentIsNotTouched)
{
    const io::TemplateId crate = addCrate(), hull = addCrate(io::Collision::Hull);
    for (int i = 0; i < 40; ++i)
        stage.place(i % 3 ? crate : hull, {i % 5 - 2.0, 0.5 + i / 10, -3.0 - i % 10 / 5}, {5.0f * float(i), 0, 0});
    const io::Scene before = stage.scene;
    const auto trace = [this] {
        begin();
        io::Random random{3};
        std::string lines;
        for (int i = 0; i < 400; ++i) {
            session->step({.move = {random.signedUnit(), 1}, .yaw = random.range(-3, 3), .run = true, .jump = random.chance(0.05f)});
            lines += traceLine(*session);
        }
        return lines;
    };
    const std::string first = trace();
    EXPECT_NE(first.find("\"moved\":[{"), std::string::npos);
    EXPECT_EQ(first, trace());
    EXPECT_TRUE(io::sameContent(before, stage.scene));
}

TEST_F(Play, WhatIsFarAwayIsFrozenAndGoesOnWhenThePlayerComes)
{
    stage.scene = {};
    stage.assets = {};
    const io::ObjectId far = stage.place(addCrate(), {0, 5, -100});
    begin();
    run(60);
    EXPECT_EQ(at(far).position.y, 5);
    run(20, {.move = {0, 1}});
}

TEST_F(Play, FaultsOfTheWorldDoNotStopIt)
{
    constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
    const io::TemplateId crate = addCrate(io::Collision::Hull);
    io::Model flat = crateModel();
    for (io::Vertex& vertex : flat.vertices)
        vertex.position = {vertex.position.x, vertex.position.x, 0}; // a line
    io::Model point = crateModel(), wrong = crateModel(), tilted = crateModel();
    for (io::Vertex& vertex : point.vertices)
        vertex.position = {0, 0, 0};
    for (io::Vertex& vertex : wrong.vertices)
        vertex.position.y = kNan;
    for (io::Vertex& vertex : tilted.vertices)
        vertex.position.z = vertex.position.x + vertex.position.y; // a sheet
    int name = 0;
    for (const io::Model& model : {flat, point, wrong, tilted})
        for (const io::Collision collision : {io::Collision::Hull, io::Collision::Mesh, io::Collision::Box, io::Collision::Capsule})
            ++name, stage.place(stage.addTemplate("odd" + std::to_string(name), collision, model, true), {name % 4 * 1.0, 2.0 + name / 4, -3});
    io::Template value = *stage.scene.find(crate);
    for (const float wrongMass : {kNan, 0.0f, -5.0f, 1e30f}) {
        value.name = "odd" + std::to_string(++name);
        value.body = {.dynamic = true, .mass = wrongMass, .friction = wrongMass, .bounce = wrongMass};
        const io::TemplateId id = stage.addTemplate(value.name, io::Collision::Box, crateModel(), true);
        stage.scene.exchange(id, value);
        stage.place(id, {name * 0.3, 3, 1});
    }
    for (const glm::vec3 scale : {glm::vec3{0}, glm::vec3{-1, 1, 1}, glm::vec3{1e-6f}, glm::vec3{1, 0, 1}, glm::vec3{kNan}, glm::vec3{1e6f}})
        stage.place(crate, {5, 2, 1}, {0, 0, 0}, scale);
    stage.place(crate, {std::numeric_limits<double>::infinity(), 0, 0});
    stage.place(crate, {0, kNan, 0});
    stage.place(crate, {3, -1, 3}); // in the ground
    for (int i = 0; i < 30; ++i)
        stage.place(crate, {-4, 1, -4}); // all in one place
    begin();
    run(300, {.move = {0.3, 1}, .yaw = 1});
    for (const io::Object& object : session->scene().objects()) {
        const glm::dvec3& p = object.transform.position;
        EXPECT_TRUE(!std::isfinite(p.x + p.y + p.z) || glm::length(p) < 1e4);
    }
    const glm::dvec3 feet = session->walker().feet();
    EXPECT_TRUE(std::isfinite(feet.x + feet.y + feet.z));
}

TEST_F(Play, ThousandsAreStepped)
{
    const io::TemplateId crate = addCrate();
    for (int i = 0; i < 4000; ++i)
        stage.place(crate, {i % 60 - 30.0, 0.0 + i / 3600, i / 60 % 60 - 30.0});
    begin(0, 0);
    run(30, {.move = {0, 1}});
    EXPECT_LE(session->bodies().awake(), Bodies::kMost);
}

} // namespace
} // namespace play
