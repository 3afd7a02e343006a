// wold import: height maps, models, pictures and sounds into a project, all of them or none.
#include "app/commands/commands.h"
#include "app/opened.h"
#include "app/report.h"
#include "editor/ground_import.h"
#include "io/files/atomic_file.h"

#include <algorithm>
#include <cstdio>
#include <fmt/format.h>
#include <optional>

namespace app {
namespace {

namespace fs = std::filesystem;

struct Import {
    fs::path file;
    io::AssetKind kind;
    io::CheckedAsset asset; // of all but height maps
};

bool saysOfHeights(const Exchange& e)
{
    return e.layout.size || e.layout.sample || e.layout.bigEndian || e.measures.metresPerTexel || e.measures.heights;
}

io::Result<std::vector<Import>> lookAt(const Exchange& exchange, const fs::path& project)
{
    std::vector<Import> imports;
    io::Complaints complaints;
    for (const fs::path& file : exchange.files) {
        const bool alone = exchange.files.size() == 1 && saysOfHeights(exchange);
        using Kind = io::Result<io::AssetKind>;
        const Kind kind = exchange.as ? Kind{*exchange.as} : alone ? Kind{io::AssetKind::HeightMap} : io::assetKind(file);
        if (!kind) return kind.error();
        Import import{.file = file, .kind = *kind};
        if (*kind != io::AssetKind::HeightMap) {
            io::Result<io::CheckedAsset> asset = io::checkAsset(file, *kind, project, complaints);
            if (!asset) return asset.error();
            import.asset = *std::move(asset);
        }
        imports.push_back(std::move(import));
    }
    const auto heightMaps = std::ranges::count(imports, io::AssetKind::HeightMap, &Import::kind);
    if (heightMaps > 1) return io::Error{exchange.files.back().string(), "a scene has one ground; import one height map at a time"};
    logComplaints(complaints);
    return imports;
}

// A template for a model, as what is placed are templates. Its model's file lies in the project by now.
std::string addTemplate(editor::Document& document, const io::CheckedAsset& asset)
{
    const io::Scene& scene = document.scene();
    for (const io::Scene::TemplateSlot& slot : scene.templates())
        if (slot.value && slot.value->model == asset.target) return slot.name;
    const std::string stem = fs::path{asset.target}.stem().string();
    std::string name = stem;
    for (int i = 2; scene.findTemplate(name) != io::TemplateId::None; ++i)
        name = stem + "_" + std::to_string(i);
    const io::TemplateId id = document.templateSlot(name);
    setTemplate(document, "Import model", id, io::Template{.name = name, .category = "Imported", .model = asset.target});
    return name;
}

void say(const std::string& line, bool quiet)
{
    if (!quiet) fmt::print("{}\n", line);
}

std::string inWords(const editor::HeightImportReport& r)
{
    const io::ImportedGround& ground = r.ground;
    std::string words = fmt::format("{}: {} x {} texels, {:.6g} m apart ({}), {:.6g} to {:.6g} m ({})", r.heightMap, r.size.x, r.size.y,
                                    ground.grid.metresPerTexel, io::nameOf(ground.metresFrom), ground.minHeight, ground.maxHeight,
                                    io::nameOf(ground.heightsFrom));
    if (r.voids > 0) words += fmt::format(", {} voids filled", r.voids);
    if (!r.differences.empty()) words += "; in place of the ground that was there: " + editor::inWords(r.differences);
    return words;
}

} // namespace

int importFiles(const Options& options)
{
    auto opened = openAsAsked(options);
    if (const int* code = std::get_if<int>(&opened)) return *code;
    editor::Document& document = *std::get<Opened>(opened).document;
    const fs::path folder = document.project().folder;
    const bool quiet = options.quiet || options.json == "-";
    io::Result<std::vector<Import>> imports = lookAt(options.exchange, folder);
    if (!imports) return fault(imports.error());

    io::Value::Array figures;
    std::vector<std::string> lines;
    for (const Import& import : *imports) { // what can be refused comes before what is written
        if (import.kind != io::AssetKind::HeightMap) continue;
        const auto report = editor::importHeights(document, "Import heights",
                                                  {import.file, options.exchange.layout, options.exchange.measures, options.exchange.force});
        if (!report) return fault(report.error());
        logComplaints(report->complaints);
        lines.push_back(inWords(*report));
        io::Value::Object members = editor::membersOf(*report);
        members.insert(members.begin(), {"file", import.file.generic_string()});
        figures.emplace_back(std::move(members));
    }
    for (const Import& import : *imports) {
        if (import.kind == io::AssetKind::HeightMap) continue;
        const io::CheckedAsset& asset = import.asset;
        if (!asset.there)
            if (const io::Status written = io::writeFile(folder / asset.target, asset.bytes); !written) return fault(written.error());
        io::Value::Object members{{"file", import.file.generic_string()}, {"target", asset.target}, {"bytes", std::uint64_t(asset.bytes.size())}};
        std::string line = fmt::format("{}: {}", asset.target, asset.there ? "was there already" : fmt::format("{} bytes", asset.bytes.size()));
        if (import.kind == io::AssetKind::Model) {
            const std::string name = addTemplate(document, asset);
            members.emplace_back("template", name);
            line += ", template " + name;
        }
        lines.push_back(std::move(line));
        figures.emplace_back(std::move(members));
    }
    if (const auto saved = document.save(); !saved) return fault(saved.error());
    for (const std::string& line : lines)
        say(line, quiet);
    const io::Status written = writeFigures(options.json, io::Value::Object{{"imported", std::move(figures)}});
    return written ? 0 : fault(written.error());
}

} // namespace app
