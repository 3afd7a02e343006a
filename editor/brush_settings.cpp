#include "editor/brush_settings.h"

#include "io/scene/field_value.h"

namespace editor {
namespace {

constexpr std::size_t kTools = enumNames(BrushTool{}).size();

struct Writer {
    io::Value& members;
    void operator()(const char* key, const auto& value, const io::Hint&)
    {
        if (!members.find(key)) members[key] = io::toValue(value);
    }
};

} // namespace

// Each tool lists the fields that it uses; together they are all.
io::Value brushSettings(const Brush& brush)
{
    io::Value saved = io::Value::Object{{"tool", enumNames(brush.tool)[std::size_t(brush.tool)]}, {"level_given", brush.levelGiven}};
    Brush shown = brush;
    shown.levelGiven = true;
    for (std::size_t tool = 0; tool < kTools; ++tool) {
        shown.tool = BrushTool(tool);
        Writer writer{saved};
        fields(writer, shown);
    }
    return saved;
}

void restoreBrush(Brush& brush, const io::Value& saved)
{
    const io::Value::Object* members = saved.asObject();
    if (!members) return;
    Brush read = brush;
    read.levelGiven = true;
    for (const auto& [key, value] : *members) {
        if (key == "level_given") continue;
        for (std::size_t tool = 0; tool < kTools; ++tool) {
            read.tool = BrushTool(tool);
            if (io::setField(read, key, value)) break;
        }
    }
    read.tool = brush.tool;
    if (const io::Value* tool = saved.find("tool"))
        if (const int index = io::indexOfName(*tool, enumNames(BrushTool{})); index >= 0) read.tool = BrushTool(index);
    const io::Value* given = saved.find("level_given");
    read.levelGiven = given && given->asBool() ? *given->asBool() : brush.levelGiven;
    brush = std::move(read);
}

} // namespace editor
