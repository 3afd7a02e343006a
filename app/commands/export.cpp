// wold export: a world as one glTF file, or its ground as heights or as a mesh.
#include "app/commands/commands.h"
#include "app/opened.h"
#include "app/report.h"
#include "editor/ground_import.h"
#include "io/files/height_export.h"
#include "io/files/world_export.h"

#include <fmt/format.h>

namespace app {
namespace {

std::string numbersOf(const io::Value& list, const char* between)
{
    std::string text;
    for (const io::Value& number : *list.asArray())
        text += fmt::format("{}{:.6g}", text.empty() ? "" : between, *number.asNumber());
    return text;
}

// What was written, and how `wold import` takes it back.
std::string inWords(const io::Value& done)
{
    std::string words;
    for (const io::Value& file : *done.find("files")->asArray())
        words += (words.empty() ? "" : ", ") + *file.asString();
    words += fmt::format(": {} texels, {:.6g} m apart", numbersOf(*done.find("size"), " x "), *done.find("metres_per_texel")->asNumber());
    if (const io::Value* heights = done.find("heights")) words += ", 16 bits from " + numbersOf(*heights, " to ") + " m";
    if (const io::Value* triangles = done.find("triangles"))
        words += fmt::format(", {:.0f} triangles in {:.0f} tiles, a vertex every {:.0f} texels", *triangles->asNumber(),
                             *done.find("tiles")->asNumber(), *done.find("step")->asNumber());
    return words;
}

int exportWhole(const Options& options, const editor::Document& document)
{
    const auto done = io::exportWorld(options.out, document.scene(), document.assets(), options.exchange.step);
    if (!done) return fault(done.error());
    if (!options.quiet && options.json != "-")
        fmt::print("{}: {} models, {} copies, {} triangles of ground{}\n", options.out.string(), done->models, done->instances, done->groundTriangles,
                   done->leftOut > 0 ? fmt::format("; {} objects without a model left out", done->leftOut) : "");
    io::Value::Array files;
    for (const std::filesystem::path& file : done->written)
        files.push_back(file.generic_string());
    const io::Status written = writeFigures(options.json, io::Value::Object{{"models", done->models},
                                                                            {"instances", done->instances},
                                                                            {"ground_triangles", done->groundTriangles},
                                                                            {"step", done->step},
                                                                            {"left_out", done->leftOut},
                                                                            {"files", std::move(files)}});
    return written ? 0 : fault(written.error());
}

} // namespace

int exportFile(const Options& options)
{
    const bool mesh = io::exportsMesh(options.out);
    if (!mesh && !io::exportsHeights(options.out))
        return misuse(fmt::format("--out {}: a world, or its ground's mesh (--only terrain), is written as .glb or .gltf, heights as .png, "
                                  ".r16, .exr, .tif or .r32", options.out.string()));
    if (!mesh && options.exchange.step > 0) return misuse("--step goes with .glb and .gltf");
    auto opened = openAsAsked(options);
    if (const int* code = std::get_if<int>(&opened)) return *code;
    const editor::Document& document = *std::get<Opened>(opened).document;
    if (mesh && !options.exchange.onlyTerrain) return exportWhole(options, document);
    const auto done = editor::exportGround(document.scene(), options.out, options.exchange.step);
    if (!done) return fault(done.error());
    if (!options.quiet && options.json != "-") fmt::print("{}\n", inWords(*done));
    const io::Status written = writeFigures(options.json, *done);
    return written ? 0 : fault(written.error());
}

} // namespace app
