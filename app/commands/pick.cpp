// wold pick: what lies under pixels, a JSON line each.
#include "app/commands/commands.h"
#include "app/opened.h"
#include "app/report.h"
#include "app/text.h"
#include "editor/picker.h"
#include "editor/script_commands.h"
#include "io/files/atomic_file.h"
#include "io/files/json.h"
#include "io/files/text.h"

#include <chrono>
#include <cmath>
#include <cstdio>
#include <fmt/format.h>

namespace app {
namespace {

// "120 80" is the middle of that pixel, "120.25 80.5" the very point.
std::optional<double> coordinate(std::string_view text)
{
    const auto number = toNumber<double>(text);
    if (!number) return std::nullopt;
    return toNumber<long>(text) ? *number + 0.5 : *number;
}

io::Result<std::vector<glm::dvec2>> readPoints(const std::filesystem::path& file)
{
    const auto text = io::readFile(file);
    if (!text) return text.error();
    std::vector<glm::dvec2> points;
    int line = 0;
    for (std::string_view row : split(*text, '\n')) {
        ++line;
        std::vector<std::string_view> words;
        for (std::size_t from = row.find_first_not_of(" \t\r,"); from != row.npos;
             from = row.find_first_not_of(" \t\r,", from)) {
            words.push_back(row.substr(from, row.find_first_of(" \t\r,", from) - from));
            from += words.back().size();
        }
        if (words.empty() || words.front().starts_with('#')) continue;
        const auto x = coordinate(words[0]), y = words.size() == 2 ? coordinate(words[1]) : std::nullopt;
        if (!x || !y)
            return io::Error{fmt::format("{}:{}", file.string(), line), "write two numbers, the x and y of a pixel"};
        points.emplace_back(*x, *y);
    }
    return points;
}

double secondsSince(std::chrono::steady_clock::time_point start)
{
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

struct Picked {
    std::vector<editor::PickHit> hits;
    double buildSeconds = 0, seconds = 0;
};

Picked pickAll(const editor::Document& document, const editor::View& view, std::span<const glm::dvec2> points)
{
    Picked picked;
    editor::Picker picker;
    auto start = std::chrono::steady_clock::now();
    picker.update(document.scene(), document.assets(), {.everything = true});
    picker.prepare();
    picked.buildSeconds = secondsSince(start);

    picked.hits.reserve(points.size());
    start = std::chrono::steady_clock::now();
    for (const glm::dvec2& point : points)
        picked.hits.push_back(picker.pick(view, point));
    picked.seconds = secondsSince(start);
    return picked;
}

void append(std::string& text, std::string_view key, const glm::dvec3& v)
{
    text += key;
    for (int axis = 0; axis < 3; ++axis) {
        io::appendNumber(text, v[axis]);
        text += axis < 2 ? ',' : ']';
    }
}

// A line for each, as editor::describe() words it; written straight, as there may be a million.
std::string answers(std::span<const editor::PickHit> hits, const io::Scene& scene)
{
    std::string text;
    text.reserve(hits.size() * 200);
    for (const editor::PickHit& hit : hits) {
        if (!hit || !std::isfinite(glm::dot(hit.position, hit.normal))) {
            text += io::writeJson(editor::describe(hit, scene)) + '\n';
            continue;
        }
        text += R"({"surface":")";
        text += editor::nameOf(hit.surface);
        text += '"';
        if (hit.id != io::ObjectId::None) {
            text += R"(,"id":)";
            io::appendNumber(text, double(io::number(hit.id)));
            text += R"(,"template":)";
            io::appendString(text, scene.templateName(hit.templateId));
        }
        if (const auto instance = scene.findInstance(hit.id)) {
            text += R"(,"layer":)";
            io::appendString(text, scene.find(instance->at.layer)->name);
        }
        append(text, R"(,"position":[)", hit.position);
        append(text, R"(,"normal":[)", hit.normal);
        text += R"(,"distance":)";
        io::appendNumber(text, hit.distance);
        text += "}\n";
    }
    return text;
}

} // namespace

int pick(const Options& options)
{
    const auto points = readPoints(options.points);
    if (!points) return fault(points.error());
    auto opened = openAsAsked(options);
    if (const int* code = std::get_if<int>(&opened)) return *code;
    const auto& [document, drawing, milliseconds] = std::get<Opened>(opened);
    const auto camera = cameraFor(options, *document);
    if (!camera) return fault(camera.error());

    const Picked picked = pickAll(*document, {.camera = *camera, .size = options.size}, *points);
    const std::string text = answers(picked.hits, document->scene());
    std::fwrite(text.data(), 1, text.size(), stdout);
    const io::Value figures =
        io::Value::Object{{"rays", std::uint64_t(points->size())},
                          {"seconds", picked.seconds},
                          {"rays_per_second", double(points->size()) / std::max(picked.seconds, 1e-9)},
                          {"index_ms", picked.buildSeconds * 1e3},
                          {"load_ms", milliseconds}};
    const io::Status written = writeFigures(options.json, figures);
    return written ? 0 : fault(written.error());
}

} // namespace app
