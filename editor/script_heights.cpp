// The script's commands that bring a height map in and take the ground out.
#include "editor/ground_import.h"
#include "editor/script_commands.h"
#include "io/files/height_export.h"

#include <algorithm>

namespace editor {
namespace {

HeightRequest requestOf(Arguments& arguments)
{
    HeightRequest request{.file = arguments.text("file")};
    if (const auto size = arguments.pair("size")) {
        if (*size != glm::floor(*size) || size->x < 2 || size->y < 2 || size->x > 1e6 || size->y > 1e6) arguments.fail("\"size\" is [width, height] in texels");
        else request.layout.size = glm::ivec2{*size};
    }
    if (arguments.has("sample")) {
        const auto names = enumNames(io::HeightSample{});
        const auto found = std::ranges::find(names, arguments.text("sample"));
        if (found == names.end()) arguments.fail("\"sample\" is u8, u16, i16 or f32");
        else request.layout.sample = io::HeightSample(found - names.begin());
    }
    if (arguments.has("big_endian")) request.layout.bigEndian = arguments.flag("big_endian", false);
    if (arguments.has("metres_per_texel")) request.measures.metresPerTexel = arguments.number("metres_per_texel", 1, -1e12, 1e12);
    request.measures.heights = arguments.pair("heights");
    request.force = arguments.flag("force", false);
    return request;
}

Answer importCommand(Script& script, Arguments& arguments)
{
    const HeightRequest request = requestOf(arguments);
    if (const auto fault = arguments.finish()) return *fault;
    const auto report = importHeights(script.document(), "Import heights", request);
    if (!report) return report.error();
    return membersOf(*report);
}

Answer exportCommand(Script& script, Arguments& arguments)
{
    const std::filesystem::path out = arguments.text("out");
    const auto step = int(arguments.number("step", 0, 0, 16384));
    const io::Scene& scene = script.document().scene();
    if (!scene.heights()) arguments.fail("this scene has no ground");
    if (step > 0 && !io::exportsMesh(out)) arguments.fail("\"step\" is of a mesh, .glb or .gltf");
    if (const auto fault = arguments.finish()) return *fault;
    io::Result<io::Value> done = exportGround(scene, out, step);
    if (!done) return done.error();
    return done;
}

constexpr ScriptCommand kCommands[] = {{"import_heights", importCommand}, {"export_heights", exportCommand}};

} // namespace

std::span<const ScriptCommand> heightCommands()
{
    return kCommands;
}

} // namespace editor
