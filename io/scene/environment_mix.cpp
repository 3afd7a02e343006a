#include "io/scene/environment_mix.h"

#include "io/scene/field_value.h"

#include <cmath>
#include <cstring>

namespace io {
namespace {

// Every field lies at the same place in each Environment, and fields() visits them in the same order. So the ends' fields
// are listed first and then taken one by one.
struct Listed {
    std::vector<const void*>& places;
    template <class T> void operator()(const char*, const T& value, const Hint&)
    {
        if constexpr (Section<T>) fields(*this, value);
        else places.push_back(&value);
    }
};

// After how much a value means the same again: directions around the horizon, longitude and the hours of a day. 0: never.
double periodOf(const Hint& hint)
{
    const std::string_view unit = hint.unit;
    if (unit == "deg" && hint.max - hint.min >= 360) return 360;
    if (unit == "h" && hint.min == 0 && hint.max == 24) return 24;
    return 0;
}

double mixedNumber(double from, double to, double share, const Hint& hint)
{
    if (const double period = periodOf(hint); period > 0) {
        double value = from + std::remainder(to - from, period) * share;
        while (value > hint.max) value -= period;
        while (value < hint.min) value += period;
        return value;
    }
    if (hint.style == Style::Logarithmic && from > 0 && to > 0) return std::exp(std::lerp(std::log(from), std::log(to), share));
    return std::lerp(from, to, share);
}

// Between two seeds lie others that look like neither, and between two resolutions ones that machines dislike. Days pass.
bool passes(const char* key)
{
    return std::strcmp(key, "day_of_year") == 0 || std::strcmp(key, "year") == 0;
}

class Mixer {
public:
    Mixer(const std::vector<const void*>& to, double share) : m_to{to}, m_share{share} {}

    template <class T> void operator()(const char* key, T& value, const Hint& hint)
    {
        if constexpr (Section<T>) fields(*this, value);
        else mix(key, value, *static_cast<const T*>(m_to[m_next++]), hint);
    }

private:
    template <class T> void mix(const char* key, T& value, const T& to, const Hint& hint) const
    {
        if (value == to) return;
        if constexpr (std::is_floating_point_v<T>)
            value = m_share < 1 ? T(mixedNumber(value, to, m_share, hint)) : to;
        else if constexpr (GlmVector<T>)
            for (int i = 0; i < VectorTraits<T>::kSize; ++i)
                mix(key, value[i], to[i], hint);
        else if (std::is_same_v<T, int> && passes(key))
            value = T(std::lround(std::lerp(double(value), double(to), m_share)));
        else if (m_share >= 0.5)
            value = to;
    }

    const std::vector<const void*>& m_to;
    std::size_t m_next = 0;
    double m_share;
};

} // namespace

Environment mixed(const Environment& from, const Environment& to, double share)
{
    if (!(share > 0)) return from; // NaN too
    std::vector<const void*> places;
    Listed listed{places};
    fields(listed, to);
    Environment result = from;
    Mixer mixer{places, std::min(share, 1.0)};
    fields(mixer, result);
    return result;
}

} // namespace io
