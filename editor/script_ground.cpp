// The script's commands for the ground as a whole: generate, resample, crop, offset.
#include "editor/ground_edits.h"
#include "editor/ground_making.h"
#include "editor/script_commands.h"
#include "io/scene/field_value.h"

namespace editor {
namespace {

// Takes each field of a list from the argument of its name, where there is one.
struct FieldArguments {
    Arguments& arguments;
    template <class T> void operator()(const char* key, T& value, const io::Hint& hint)
    {
        const io::Value* given = arguments.value(key);
        if (!given) return;
        if (const io::FieldFault fault = io::fromValue(value, *given, hint, io::Reading::File)) arguments.fail(std::string{key} + ": " + *fault);
    }
};

Answer replaced(Script& script, const char* name, NewGround ground, bool follow)
{
    const glm::ivec2 size = ground.heights.size;
    const double metres = ground.heights.metresPerTexel;
    replaceGround(script.document(), name, std::move(ground), follow);
    const io::HeightMap& map = *script.document().scene().heights();
    return io::Value::Object{{"texels", io::Value::Array{size.x, size.y}}, {"metres_per_texel", metres}, {"lowest", map.min}, {"highest", map.max}};
}

Answer generate(Script& script, Arguments& arguments)
{
    GroundRecipe recipe;
    FieldArguments reader{arguments};
    fields(reader, recipe);
    const auto origin = arguments.pair("origin");
    const bool follow = arguments.flag("follow", true);
    if (const auto fault = arguments.finish()) return *fault;
    io::Result<io::HeightGrid> heights = generateGround(recipe);
    if (!heights) return heights.error();
    if (origin) heights->origin = *origin;
    return replaced(script, "Generate ground", {.heights = *std::move(heights), .range = glm::dvec2{recipe.lowest, recipe.highest}}, follow);
}

Answer reshape(Script& script, Arguments& arguments, Reshape kind, const char* name)
{
    Reshaping reshaping{.kind = kind};
    FieldArguments reader{arguments};
    fields(reader, reshaping);
    const bool follow = arguments.flag("follow", true);
    if (kind == Reshape::Crop && !(arguments.has("from") && arguments.has("to"))) arguments.fail("needs \"from\" and \"to\"");
    if (kind == Reshape::Offset && !arguments.has("by") && !arguments.has("raise")) arguments.fail("needs \"by\" or \"raise\"");
    if (const auto fault = arguments.finish()) return *fault;
    io::Result<NewGround> ground = reshaped(script.document().scene(), reshaping);
    if (!ground) return ground.error();
    return replaced(script, name, *std::move(ground), follow);
}

Answer resample(Script& script, Arguments& arguments)
{
    return reshape(script, arguments, Reshape::Resample, "Resample ground");
}
Answer crop(Script& script, Arguments& arguments)
{
    return reshape(script, arguments, Reshape::Crop, "Crop ground");
}
Answer offset(Script& script, Arguments& arguments)
{
    return reshape(script, arguments, Reshape::Offset, "Offset ground");
}

constexpr ScriptCommand kCommands[] = {{"generate", generate}, {"resample", resample}, {"crop", crop}, {"offset", offset}};

} // namespace

std::span<const ScriptCommand> landscapeCommands()
{
    return kCommands;
}

} // namespace editor
