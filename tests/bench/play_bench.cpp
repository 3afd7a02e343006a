// play_bench PROJECT [MINUTES]: what entering a world and a step of the player cost, among 100,000 things and in the project, what 200
// bodies that fall on a heap cost, and 20,000 that lie about; in the project
// random input also looks for a place in which the player gets inside of something, below the ground or nowhere.
#include "app/play/session.h"
#include "io/base/random.h"
#include "io/scene/ground.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <memory>

namespace {

using Clock = std::chrono::steady_clock;
double msSince(Clock::time_point start)
{
    return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

double at(std::vector<double> values, double share)
{
    std::ranges::sort(values);
    return values.empty() ? 0 : values[std::size_t(share * double(values.size() - 1))];
}

struct Outcome {
    std::vector<double> ms;
    double deepest = 0, lowest = 0;
    int notFinite = 0, longestStill = 0;
};

Outcome wander(play::Session& session, long steps, bool watch)
{
    io::Random random{2};
    Outcome outcome;
    play::Wish wish;
    glm::dvec3 stillAt = session.walker().feet();
    int still = 0;
    for (long i = 0; i < steps; ++i) {
        if (i % 40 == 0)
            wish = {.move = {random.signedUnit(), random.range(-0.3f, 1)}, .yaw = random.range(-2, 2), .run = random.chance(0.6f), .crouch = random.chance(0.1f),
                    .jump = random.chance(0.3f)};
        const auto start = Clock::now();
        session.step(wish);
        outcome.ms.push_back(msSince(start));
        const play::Walker& walker = session.walker();
        const glm::dvec3 feet = walker.feet();
        outcome.notFinite += !std::isfinite(feet.x + feet.y + feet.z);
        if (!watch) continue;
        outcome.deepest = std::max(outcome.deepest, walker.depth(session.surroundings()));
        if (const auto ground = io::groundHeight(session.scene(), feet.x, feet.z)) outcome.lowest = std::max(outcome.lowest, *ground - feet.y);
        still = glm::length(feet - stillAt) < 0.5 ? still + 1 : 0;
        if (still == 0) stillAt = feet;
        outcome.longestStill = std::max(outcome.longestStill, still);
    }
    std::ranges::sort(outcome.ms);
    return outcome;
}

void say(const char* name, const Outcome& outcome)
{
    std::printf("%s: %zu steps, median %.3f ms, p99 %.3f ms, longest %.2f ms; inside at most %.4f m, below ground %.4f m, not finite %d, longest in one place %.1f s\n", name,
                outcome.ms.size(), at(outcome.ms, 0.5), at(outcome.ms, 0.99), at(outcome.ms, 1), outcome.deepest, outcome.lowest, outcome.notFinite, outcome.longestStill / 60.0);
}

void crowd()
{
    io::Scene scene;
    io::Assets assets;
    io::HeightGrid grid{.size = {513, 513}, .metresPerTexel = 1, .origin = {-256, -256}};
    for (int z = 0; z < 513; ++z)
        for (int x = 0; x < 513; ++x)
            grid.metres.push_back(float(std::sin(x * 0.05) * 3 + std::cos(z * 0.07) * 3));
    scene.exchange(std::make_shared<const io::HeightMap>(grid));
    for (const io::Collision collision : {io::Collision::Box, io::Collision::Capsule, io::Collision::Hull, io::Collision::Mesh}) {
        const io::TemplateId id = scene.templateSlot(std::to_string(int(collision)));
        scene.exchange(id, io::Template{.collision = collision});
        assets.models.push_back(std::make_shared<io::Model>(io::boxModel({0.5f, 1.5f, 0.5f}, glm::vec4{1})));
    }
    io::Random random{1};
    for (int i = 0; i < 100'000; ++i) {
        const double x = random.range(-250, 250), z = random.range(-250, 250);
        const io::ObjectId id = scene.freshId();
        scene.exchange(id, io::Object{.id = id, .templateId = io::TemplateId{std::uint32_t(1 + i % 4)},
                                      .transform = {{x, *scene.heights()->height(x, z) - 0.1, z}, {random.range(-20, 20), random.range(0, 360), 0}, glm::vec3{random.range(0.5f, 1.5f)}}});
    }
    const auto start = Clock::now();
    play::Session session{scene, assets, {.eye = {0, 10, 0}}};
    std::printf("100,000 things: entering %.1f ms\n", msSince(start));
    say("100,000 things", wander(session, 20'000, false));
}

// Uneven ground, and crates of which every fourth is a hull.
struct Yard {
    io::Scene scene;
    io::Assets assets;
    std::vector<io::TemplateId> kinds;

    Yard()
    {
        io::HeightGrid grid{.size = {513, 513}, .metresPerTexel = 1, .origin = {-256, -256}};
        for (int z = 0; z < 513; ++z)
            for (int x = 0; x < 513; ++x)
                grid.metres.push_back(float(std::sin(x * 0.3) + std::cos(z * 0.4)) * 0.7f);
        scene.exchange(std::make_shared<const io::HeightMap>(grid));
        for (const io::Collision collision : {io::Collision::Box, io::Collision::Hull}) {
            kinds.push_back(scene.templateSlot(std::to_string(int(collision))));
            scene.exchange(kinds.back(), io::Template{.collision = collision, .body = {.dynamic = true}});
            assets.models.push_back(std::make_shared<io::Model>(io::boxModel(glm::vec3{0.8f}, glm::vec4{1})));
        }
    }
    void place(std::size_t i, const glm::dvec3& where, const glm::vec3& turn)
    {
        const io::ObjectId id = scene.freshId();
        scene.exchange(id, io::Object{.id = id, .templateId = kinds[i % 4 == 0], .transform = {where, turn, glm::vec3{1}}});
    }
};

void heap()
{
    Yard yard;
    io::Random random{4};
    for (std::size_t i = 0; i < 200; ++i)
        yard.place(i, {double(i % 5) * 0.9 + random.range(-0.1f, 0.1f), 2.5 + double(i / 25) * 1.2, double(i / 5 % 5) * 0.9}, {random.range(0, 360), random.range(0, 360), 0});
    play::Session session{yard.scene, yard.assets, {.eye = {20, 3, 20}}};
    std::vector<double> moving, resting;
    std::clock_t spent = 0;
    double inside = 0;
    while (session.steps() < 1800) {
        const std::clock_t before = std::clock();
        const auto start = Clock::now();
        session.step({});
        const double ms = msSince(start);
        (session.bodies().awake() > 0 ? moving : resting).push_back(ms);
        if (session.bodies().awake() > 0) spent += std::clock() - before;
    }
    for (const io::Object& object : session.scene().objects())
        inside = std::max(inside, session.bodies().depth(object.id));
    std::printf("200 bodies on a heap: %.1f s until all sleep; moving median %.2f ms a step (%.2f ms on the processor), p99 %.2f ms, longest %.2f ms; asleep median %.4f ms; inside of each other at most %.4f m\n",
                double(moving.size()) / 60, at(moving, 0.5), 1e3 * double(spent) / CLOCKS_PER_SEC / double(moving.size()), at(moving, 0.99), at(moving, 1), at(resting, 0.5), inside);
}

void lyingAbout()
{
    Yard yard;
    io::Random random{5};
    for (std::size_t i = 0; i < 20'000; ++i) {
        const double x = random.range(-250, 250), z = random.range(-250, 250);
        yard.place(i, {x, *yard.scene.heights()->height(x, z) + 0.3, z}, {0, random.range(0, 360), 0});
    }
    auto start = Clock::now();
    play::Session session{yard.scene, yard.assets, {.eye = {0, 3, 0}}};
    const double entering = msSince(start);
    start = Clock::now();
    session.step({});
    const double first = msSince(start);
    for (int i = 0; i < 900; ++i)
        session.step({});
    std::vector<double> ms;
    for (int i = 0; i < 300; ++i) {
        start = Clock::now();
        session.step({});
        ms.push_back(msSince(start));
    }
    std::printf("20,000 bodies lying about: entering %.1f ms, first step %.1f ms; after 15 s %zu awake, median %.3f ms a step\n", entering, first, session.bodies().awake(), at(ms, 0.5));
}

} // namespace

int main(int count, char** words)
{
    heap();
    lyingAbout();
    crowd();
    if (count < 2) return 0;
    io::Complaints complaints;
    auto world = io::openWorld(words[1], {}, complaints);
    if (!world) return std::fprintf(stderr, "%s\n", world.error().text().c_str()), 1;
    const auto assets = io::readAssets(*world, complaints);
    if (!assets) return 1;
    const io::Camera from = world->scene.cameras().empty() ? io::Camera{} : world->scene.cameras()[0];
    std::vector<double> entering, leaving;
    for (int i = 0; i < 9; ++i) {
        auto start = Clock::now();
        auto session = std::make_unique<play::Session>(world->scene, *assets, from);
        session->step({});
        entering.push_back(msSince(start));
        for (int k = 0; k < 60; ++k)
            session->step({.move = {0, 1}});
        start = Clock::now();
        (void)session->differences();
        session.reset();
        leaving.push_back(msSince(start));
    }
    std::printf("%s: entering with the first step median %.1f ms, longest %.1f ms; leaving %.1f ms\n", words[1], at(entering, 0.5), at(entering, 1), at(leaving, 0.5));
    play::Session session{world->scene, *assets, from};
    const Outcome outcome = wander(session, long(60 * 60 * (count > 2 ? std::atof(words[2]) : 1)), true);
    say(words[1], outcome);
    return outcome.deepest < 0.01 && outcome.lowest < 0.01 && outcome.notFinite == 0 ? 0 : 1;
}
