// The options of `wold import` and `wold export`.
#include "app/option_words.h"
#include "app/text.h"
#include "io/files/height_export.h"
#include "io/files/image_file.h"

#include <algorithm>

namespace app {
namespace {

glm::ivec2 texelsFrom(const std::string& text)
{
    const auto parts = split(text, 'x');
    const auto width = toNumber<int>(parts.front()), height = toNumber<int>(parts.back());
    if (parts.size() != 2 || !width || !height || std::min(*width, *height) < 2 || std::max(*width, *height) > io::kGroundLimits.side)
        throw wrong("--size", text, fmt::format("write WIDTHxHEIGHT, as 1025x1025; a side has 2 to {} texels", io::kGroundLimits.side));
    return {*width, *height};
}

glm::dvec2 heightsFrom(const std::string& text)
{
    const auto n = toNumbers(text, ',');
    if (n.size() != 2 || n[0] >= n[1]) throw wrong("--heights", text, "write LOW,HIGH in metres, as -20,1400");
    return {n[0], n[1]};
}

double metresFrom(const std::string& text)
{
    const auto metres = toNumber<double>(text);
    if (!metres || *metres <= 0) throw wrong("--metres-per-texel", text, "write metres above 0, as 30");
    return *metres;
}

template <class Enum> Enum named(std::string_view option, const std::string& text)
{
    const auto names = enumNames(Enum{});
    const auto found = std::ranges::find(names, text);
    if (found == names.end()) throw wrong(option, text, fmt::format("choose one of {}", fmt::join(names, " ")));
    return Enum(found - names.begin());
}

// An option whose words become a value, or an error that names it.
void add(CLI::App& app, const char* name, const char* type, const char* help, std::function<void(const std::string&)> take)
{
    app.add_option_function<std::string>(name, std::move(take), help)->type_name(type);
}

} // namespace

void addImport(CLI::App& app, Options& o)
{
    Exchange& e = o.exchange;
    app.add_option("FILE", e.files, "height map, model, picture or sound")
        ->required()
        ->expected(-1)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
    add(app, "--as", "KIND", "what the files are: heights model texture sound (default: as they look)",
        [&e](const std::string& text) { e.as = named<io::AssetKind>("--as", text); });
    add(app, "--size", "WxH", "texels of bare samples (default: guessed from the number of bytes)",
        [&e](const std::string& text) { e.layout.size = texelsFrom(text); });
    add(app, "--sample", "TYPE", "of bare samples: u8 u16 i16 f32",
        [&e](const std::string& text) { e.layout.sample = named<io::HeightSample>("--sample", text); });
    app.add_flag_callback("--big-endian", [&e] { e.layout.bigEndian = true; }, "byte order of bare samples (default: little endian)");
    add(app, "--metres-per-texel", "M", "how far the texels of a height map lie apart",
        [&e](const std::string& text) { e.measures.metresPerTexel = metresFrom(text); });
    add(app, "--heights", "LOW,HIGH", "metres of the lowest and highest value that its samples can have",
        [&e](const std::string& text) { e.measures.heights = heightsFrom(text); });
    app.add_flag("--force", e.force, "put it in place of a ground of another size or other measures");
    app.add_option("--scene", o.scene, "scene whose ground it becomes (default: the start scene)")->type_name("NAME");
}

void addExport(CLI::App& app, Options& o)
{
    Exchange& e = o.exchange;
    app.add_option("--out", o.out, "the world: .glb .gltf; heights: .png .r16 (16 bits), .exr .tif .r32 (metres)")->type_name("FILE")->required();
    add(app, "--only", "WHAT", "terrain: of .glb and .gltf the ground alone", [&e](const std::string& text) {
        if (text != "terrain") throw wrong("--only", text, "choose terrain");
        e.onlyTerrain = true;
    });
    add(app, "--step", "N", "texels from vertex to vertex of the ground (default: what makes at most two million triangles)", [&e](const std::string& text) {
        const auto step = toNumber<int>(text);
        if (!step || *step < 1 || *step > io::kGroundLimits.side)
            throw wrong("--step", text, fmt::format("write a whole number from 1 to {}", io::kGroundLimits.side));
        e.step = *step;
    });
    app.add_option("--scene", o.scene, "scene to export (default: the start scene)")->type_name("NAME");
}

} // namespace app
