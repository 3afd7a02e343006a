#include "renderer/cull.h"

#include <cmath>

namespace renderer {
namespace {

void see(const CullScene& scene, const glsl::CullView& view, std::uint32_t slot, std::vector<Seen>& seen)
{
    const glsl::CullRecord& record = scene.records[slot];
    const glsl::CullModel& model = scene.models[record.model];
    const glsl::LevelChoice choice = glsl::chooseLevel(record, model, view);
    const bool fading = choice.share < DRAWN_FADE_STEPS;
    const bool swaying = glsl::swayShown(record, model, view) > 0;
    const std::uint32_t kind = glsl::binOf(model, record, 0, fading, swaying);
    const auto add = [&](std::uint32_t level, std::uint32_t fade) {
        seen.push_back({slot | level << DRAWN_LEVEL_SHIFT | fade << DRAWN_FADE_SHIFT, kind + level * BINS_OF_LEVEL});
    };
    const auto level = std::uint32_t(choice.level);
    if (!fading) return add(level, 0);
    add(level, std::uint32_t(choice.share));
    add(level - 1, DRAWN_FADE_OTHERS + std::uint32_t(choice.share));
}

} // namespace

glsl::CullView cullView(const CullRequest& request, std::size_t instances)
{
    glsl::CullView view{};
    for (std::size_t i = 0; i < 5; ++i)
        view.planes[i] = request.volume ? glm::vec4{request.volume->planes[i]} : glm::vec4{0, 0, 0, 1e30f};
    view.eye = glm::vec3{request.eye};
    view.smallestAngle = request.smallestAngle;
    view.smallestRadius = request.smallestRadius;
    view.errorAngle = request.errorAngle;
    view.errorLength = request.errorLength;
    view.required = request.required;
    view.refused = request.refused;
    view.count = std::uint32_t(instances);
    view.impostors = request.impostors;
    view.meshLeeway = request.meshLeeway;
    view.windMost = glsl::windMost(request.wind);
    view.swayAngle = request.swayAngle;
    view.swayLength = request.swayLength;
    view.wind = request.wind;
    return view;
}

glsl::CullRecord cullRecord(const glm::dvec3& centre, double radius, std::uint32_t model, std::uint32_t flags)
{
    const double rounding = 1e-6 * (std::abs(centre.x) + std::abs(centre.y) + std::abs(centre.z));
    return {.centre = glm::vec3{centre}, .radius = float(radius * 1.0001 + rounding), .model = model, .flags = flags};
}

glsl::CullCounts cull(const CullScene& scene, const CullRequest& request, std::vector<Seen>& seen)
{
    seen.clear();
    const glsl::CullView view = cullView(request, scene.records.size());
    glsl::CullCounts counts{};
    const auto test = [&](std::uint32_t slot, bool inside) {
        const glsl::CullRecord& record = scene.records[slot];
        if (&record == request.leftOut || !glsl::wanted(record, view) || !(inside || glsl::insidePlanes(record, view))) return;
        ++counts.inside;
        if (!glsl::largeEnough(record, view)) return;
        ++counts.large;
        see(scene, view, slot, seen);
    };
    if (request.volume && scene.tree)
        scene.tree->frustum(request.volume->planes, [&](const auto& items, bool whole) {
            for (const auto& item : items)
                test(item.value, whole);
        });
    else
        for (std::uint32_t slot = 0; slot < scene.records.size(); ++slot)
            test(slot, false);
    counts.drawn = counts.large;
    return counts;
}

void addTo(glsl::CullCounts& sum, const glsl::CullCounts& more)
{
    sum.inside += more.inside;
    sum.large += more.large;
    sum.hidden += more.hidden;
    sum.drawn += more.drawn;
}

} // namespace renderer
