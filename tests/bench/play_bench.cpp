// play_bench PROJECT [MINUTES]: what entering a world and a step of the player cost, among 100,000 things and in the project, where
// random input also looks for a place in which the player gets inside of something, below the ground or nowhere.
#include "app/play/session.h"
#include "io/base/random.h"
#include "io/scene/ground.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace {

using Clock = std::chrono::steady_clock;
double msSince(Clock::time_point start)
{
    return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
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
    const auto at = [&](double share) { return outcome.ms[std::size_t(share * double(outcome.ms.size() - 1))]; };
    std::printf("%s: %zu steps, median %.3f ms, p99 %.3f ms, longest %.2f ms; inside at most %.4f m, below ground %.4f m, not finite %d, longest in one place %.1f s\n", name,
                outcome.ms.size(), at(0.5), at(0.99), at(1), outcome.deepest, outcome.lowest, outcome.notFinite, outcome.longestStill / 60.0);
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

} // namespace

int main(int count, char** words)
{
    crowd();
    if (count < 2) return 0;
    io::Complaints complaints;
    auto world = io::openWorld(words[1], {}, complaints);
    if (!world) return std::fprintf(stderr, "%s\n", world.error().text().c_str()), 1;
    const auto assets = io::readAssets(*world, complaints);
    if (!assets) return 1;
    const auto start = Clock::now();
    play::Session session{world->scene, *assets, world->scene.cameras().empty() ? io::Camera{} : world->scene.cameras()[0]};
    std::printf("%s: entering %.1f ms\n", words[1], msSince(start));
    const Outcome outcome = wander(session, long(60 * 60 * (count > 2 ? std::atof(words[2]) : 1)), true);
    say(words[1], outcome);
    return outcome.deepest < 0.01 && outcome.lowest < 0.01 && outcome.notFinite == 0 ? 0 : 1;
}
