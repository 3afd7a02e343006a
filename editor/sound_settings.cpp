#include "editor/sound_settings.h"

#include "io/scene/field_words.h"
#include "io/scene/fields.h"

#include <algorithm>
#include <cmath>

namespace editor {
namespace {

void take(bool& to, const io::Value& saved, std::string_view key)
{
    const io::Value* value = saved.find(key);
    if (const bool* on = value ? value->asBool() : nullptr) to = *on;
}

void take(float& to, const io::Value& saved, std::string_view key)
{
    const io::Value* value = saved.find(key);
    const double* number = value ? value->asNumber() : nullptr;
    if (number && std::isfinite(*number)) to = std::clamp(float(*number), 0.0f, kLoudest);
}

} // namespace

io::Value toValue(const SoundSettings& sound)
{
    io::Value value = io::Value::Object{{"hear", sound.hear}, {"muted", sound.muted}, {"master", io::decimal(sound.master)}};
    for (std::size_t i = 0; i < sound.groups.size(); ++i)
        value[enumNames(io::SoundGroup{})[i]] = io::decimal(sound.groups[i]);
    return value;
}

void restore(SoundSettings& sound, const io::Value& saved)
{
    take(sound.hear, saved, "hear");
    take(sound.muted, saved, "muted");
    take(sound.master, saved, "master");
    for (std::size_t i = 0; i < sound.groups.size(); ++i)
        take(sound.groups[i], saved, enumNames(io::SoundGroup{})[i]);
}

} // namespace editor
