// What planting costs: dabs of a brush until the world knows them, a layer of a million evaluated by its rules, all of it again after
// a stroke. No project is needed. The figures go to stdout as JSON.
#include "editor/random.h"
#include "editor/scatter_steps.h"
#include "io/files/json.h"
#include "tests/bench/clock.h"
#include "tests/unit/editor/worlds.h"

#include <cstdio>

namespace {

constexpr int kDabs = 40;

std::unique_ptr<editor::Document> hillyWorld(io::ScatterLayer layer)
{
    auto document = test::forest(0, 1);
    const auto map = test::hills(2049, 1, 3);
    editor::setHeights(*document, "Hills", map, map->texels());
    editor::setScatterLayers(*document, "Layer", {std::move(layer)});
    return document;
}

} // namespace

int main()
{
    io::Value figures;
    const io::ScatterLayer layer{.id = io::ScatterId{1}, .name = "wood", .rule = true, .species = {{.templateName = "blob"}, {.templateName = "leaf"}}, .density = 0.061f, .spacing = 2, .slope = {0, 90}};
    const auto document = hillyWorld(layer);

    io::ScatterLayer brush = layer;
    brush.rule = false;
    brush.density = 0.2f;
    editor::Random random{7};
    std::vector<double> dabs, strokes;
    const io::HeightMap& map = *document->scene().heights();
    for (int i = 0; i < kDabs; ++i) {
        const double begun = bench::wallMs();
        const editor::Planting planting = editor::plantingOf(*document, brush);
        const double ready = bench::wallMs();
        const glm::dvec2 at = map.origin + glm::dvec2{random.in(200, 1800), random.in(200, 1800)};
        editor::setInstances(*document, "Dab", editor::planted(editor::layerTiles(document->scene(), brush), planting, editor::PlantRegion::disc(at, 50)));
        dabs.push_back(bench::wallMs() - ready);
        strokes.push_back(ready - begun);
    }
    figures["dab_50m_ms"] = bench::share(dabs, 0.5);
    figures["dab_50m_p99_ms"] = bench::share(dabs, 0.99);
    figures["stroke_begins_ms"] = bench::share(strokes, 0.5);
    editor::clearPlants(*document, "Clear", layer.id);

    for (const char* name : {"evaluate_ms", "evaluate_again_ms"}) {
        const double begun = bench::wallMs();
        auto slots = editor::evaluated(editor::layerTiles(document->scene(), layer), editor::plantingOf(*document, layer), editor::PlantRegion::everywhere().bounds());
        figures[name] = bench::wallMs() - begun;
        editor::setInstances(*document, "Evaluate", *std::move(slots));
    }
    figures["plants"] = std::uint64_t(io::instanceCount(document->scene().instances(layer.id)));
    const double begun = bench::wallMs();
    const glm::dvec2 middle = map.origin + 1024.0;
    editor::followRules(*document, "Follow", {middle - 100.0, middle + 100.0});
    figures["follow_stroke_200m_ms"] = bench::wallMs() - begun;
    std::puts(io::writeJson(figures, 2).c_str());
}
