#include "editor/ground_import.h"

#include "io/files/file_names.h"
#include "io/files/height_export.h"
#include "io/scene/field_words.h"

#include <cmath>
#include <fmt/format.h>

namespace editor {
namespace {

namespace fs = std::filesystem;

std::string sizeText(glm::ivec2 size)
{
    return fmt::format("{} x {}", size.x, size.y);
}

std::string rangeText(double low, double high)
{
    return fmt::format("{} … {} m", io::numberText(low), io::numberText(high)); // of no language
}

bool near(double a, double b)
{
    return std::abs(a - b) <= 1e-6 * std::max({1.0, std::abs(a), std::abs(b)});
}

bool sameProportions(glm::ivec2 a, glm::ivec2 b)
{
    return near(double(a.x - 1) * (b.y - 1), double(a.y - 1) * (b.x - 1));
}

// What was painted, for a ground of another size: the texel that lay there.
std::shared_ptr<const io::CoverMap> stretched(const io::CoverMap& cover, glm::ivec2 size)
{
    const std::vector<std::uint32_t> old = cover.read(cover.rect());
    const auto lines = [](int from, int to) {
        std::vector<std::size_t> at(static_cast<std::size_t>(to));
        for (int i = 0; i < to; ++i)
            at[std::size_t(i)] = std::size_t(std::llround(double(i) * (from - 1) / (to - 1)));
        return at;
    };
    const auto columns = lines(cover.size().x, size.x), rows = lines(cover.size().y, size.y);
    std::vector<std::uint32_t> texels;
    texels.reserve(columns.size() * rows.size());
    for (const std::size_t row : rows)
        for (const std::size_t column : columns)
            texels.push_back(old[row * std::size_t(cover.size().x) + column]);
    return std::make_shared<const io::CoverMap>(size, texels);
}

// A file of the terrain's: its own again where no other scene can show it, else one that does not exist yet.
std::string fileFor(const Document& document, const fs::path& source, const char* extension, const std::string& own)
{
    std::string stem = source.stem().string();
    if (stem.empty() || stem.front() == '.') stem = "heights";
    const std::string wanted = "terrain/" + stem + extension;
    std::error_code fault;
    if (!fs::exists(document.project().folder / wanted, fault)) return wanted;
    if (wanted == own && document.project().scenes.size() == 1) return wanted;
    return io::freshFile(document.project().folder, wanted, extension);
}

} // namespace

std::vector<GroundDifference> groundDifferences(const io::Scene& scene, const io::ImportedGround& ground)
{
    const io::Terrain& now = scene.terrain();
    std::vector<GroundDifference> all;
    if (now.heightMap.empty() && !scene.heights()) return all;
    const glm::ivec2 size = scene.heights() ? scene.heights()->size : glm::ivec2{0};
    if (size != ground.grid.size) all.push_back({GroundPart::Size, scene.heights() ? sizeText(size) : now.heightMap, sizeText(ground.grid.size)});
    if (!near(now.metresPerTexel, ground.grid.metresPerTexel))
        all.push_back({GroundPart::MetresPerTexel, fmt::format("{:.6g}", now.metresPerTexel), fmt::format("{:.6g}", ground.grid.metresPerTexel)});
    const double low = std::min(now.minHeight, now.maxHeight), high = std::max(now.minHeight, now.maxHeight);
    const bool fits = ground.shares ? near(low, ground.minHeight) && near(high, ground.maxHeight)
                                    : low <= ground.minHeight && high >= ground.maxHeight;
    if (!fits) all.push_back({GroundPart::Heights, rangeText(low, high), rangeText(ground.minHeight, ground.maxHeight)});
    if (scene.cover() && size != ground.grid.size)
        all.push_back({GroundPart::Cover, sizeText(scene.cover()->size()), sameProportions(size, ground.grid.size) ? "stretched" : "dropped"});
    return all;
}

void importGround(Document& document, const std::string& name, const io::ImportedGround& ground, const fs::path& file)
{
    const io::Terrain& before = document.scene().terrain();
    const auto cover = document.scene().cover();
    const bool stretch = cover && cover->size() != ground.grid.size && sameProportions(cover->size(), ground.grid.size);
    const bool drop = cover && cover->size() != ground.grid.size && !stretch;
    io::Terrain terrain = before;
    terrain.heightMap = fileFor(document, file, ground.shares ? ".png" : ".exr", before.heightMap);
    terrain.metresPerTexel = ground.grid.metresPerTexel;
    terrain.origin = ground.grid.origin;
    terrain.minHeight = ground.minHeight;
    terrain.maxHeight = ground.maxHeight;
    const bool shown = cover || !document.scene().heights() || document.scene().heights()->size == ground.grid.size;
    if (drop || !shown) terrain.coverMap.clear(); // it would not fit
    if (stretch && document.project().scenes.size() > 1)
        terrain.coverMap = io::freshFile(document.project().folder, terrain.coverMap, ".png");
    io::HeightMap map{ground.grid};
    map.shares = ground.shares;
    const auto heights = std::make_shared<const io::HeightMap>(std::move(map));

    const Gesture gesture{document, name};
    document.run(std::make_unique<SwapTerrain>(name, std::move(terrain)));
    setHeights(document, name, heights, heights->texels());
    if (stretch) setCover(document, name, stretched(*cover, ground.grid.size), {{0, 0}, ground.grid.size});
    if (drop) setCover(document, name, nullptr, {});
}

io::Result<HeightImportReport> importHeights(Document& document, const std::string& name, const HeightRequest& request)
{
    HeightImportReport report;
    const io::Result<io::HeightSource> source = io::readHeightSource(request.file, request.layout, report.complaints);
    if (!source) return source.error();
    io::Result<io::ImportedGround> ground = io::groundFrom(*source, request.measures, document.scene(), report.complaints);
    if (!ground) return ground.error();
    report.differences = groundDifferences(document.scene(), *ground);
    if (!report.differences.empty() && !request.force)
        return io::Error{request.file.string(), "would not fit in place of the ground that is there (" + inWords(report.differences) +
                                                    "); nothing was changed; replace it by force (--force, \"force\": true)"};
    importGround(document, name, *ground, request.file);
    report.size = source->size;
    report.voids = source->voids;
    report.heightMap = document.scene().terrain().heightMap;
    ground->grid.metres.clear();
    report.ground = *std::move(ground);
    return report;
}

std::string inWords(const std::vector<GroundDifference>& differences)
{
    std::string words;
    for (const GroundDifference& d : differences) {
        if (!words.empty()) words += "; ";
        if (d.part == GroundPart::Size) words += fmt::format("{} texels, not {}", d.then, d.now);
        if (d.part == GroundPart::MetresPerTexel) words += fmt::format("{} m a texel, not {}", d.then, d.now);
        if (d.part == GroundPart::Heights) words += fmt::format("heights {}, not {}", d.then, d.now);
        if (d.part == GroundPart::Cover) words += fmt::format("what was painted would be {}", d.then);
    }
    return words;
}

io::Value::Object membersOf(const HeightImportReport& report)
{
    io::Value::Array warnings;
    for (const io::Complaint& complaint : report.complaints)
        warnings.push_back(complaint.what);
    io::Value::Object members{{"height_map", report.heightMap},
                              {"size", io::Value::Array{report.size.x, report.size.y}},
                              {"metres_per_texel", report.ground.grid.metresPerTexel},
                              {"metres_from", io::nameOf(report.ground.metresFrom)},
                              {"heights", io::Value::Array{report.ground.minHeight, report.ground.maxHeight}},
                              {"heights_from", io::nameOf(report.ground.heightsFrom)},
                              {"voids", std::uint64_t(report.voids)},
                              {"warnings", std::move(warnings)}};
    for (const GroundDifference& d : report.differences)
        if (d.part == GroundPart::Cover) members.emplace_back("cover", d.then);
    return members;
}

io::Result<io::Value> exportGround(const io::Scene& scene, const fs::path& file, int step)
{
    if (!scene.heights()) return io::Error{file.string(), "this scene has no ground to export"};
    const io::HeightMap& heights = *scene.heights();
    io::Value::Object members{{"size", io::Value::Array{heights.size.x, heights.size.y}}, {"metres_per_texel", heights.metresPerTexel}};
    std::vector<fs::path> written;
    if (io::exportsMesh(file)) {
        auto done = io::exportTerrainMesh(file, heights, scene.cover().get(), scene.terrain(), step > 0 ? step : io::meshStep(heights.size));
        if (!done) return done.error();
        members.insert(members.end(), {{"step", done->step}, {"triangles", done->triangles}, {"tiles", done->tiles}});
        written = std::move(done->written);
    } else {
        auto done = io::exportHeights(file, heights, scene.terrain());
        if (!done) return done.error();
        if (!done->metres) members.emplace_back("heights", io::Value::Array{done->minHeight, done->maxHeight});
        written = std::move(done->written);
    }
    io::Value::Array files;
    for (const fs::path& each : written)
        files.push_back(each.generic_string());
    members.emplace_back("files", std::move(files));
    return io::Value{std::move(members)};
}

} // namespace editor
