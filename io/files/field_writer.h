// Writes what fields() lists as JSON text that reads well in a diff, and puts unknown keys back where they were.
#pragma once

#include "io/files/extra_path.h"
#include "io/files/text.h"
#include "io/scene/extra.h"
#include "io/scene/field_value.h"

#include <string>
#include <string_view>

namespace io {

template <class T> void appendLeaf(std::string& out, const T& value)
{
    if constexpr (std::is_same_v<T, bool>)
        out += value ? "true" : "false";
    else if constexpr (std::is_same_v<T, std::string>)
        appendString(out, value);
    else if constexpr (NamedEnum<T>)
        appendString(out, enumNames(value)[std::size_t(value)]);
    else if constexpr (std::is_same_v<T, float>)
        appendNumber(out, value);
    else if constexpr (GlmVector<T>) {
        for (int i = 0; i < VectorTraits<T>::kSize; ++i) {
            out += i == 0 ? "[" : ",";
            appendLeaf(out, value[i]);
        }
        out += ']';
    } else
        appendNumber(out, double(value));
}

// Whether a section is short enough for one line inside a list: few fields, none of them a section or a list.
struct Shortness {
    int fields = 0;
    bool flat = true;
    template <class T> void operator()(const char*, const T&, const Hint&)
    {
        ++fields;
        flat = flat && !Section<const T> && !List<T>;
    }
};

// Members of one object, at one depth of indentation. Negative: on one line.
class FieldWriter {
public:
    FieldWriter(std::string& out, int depth, const Extra* extra, std::string prefix = {})
        : m_out{out}, m_depth{depth}, m_extra{extra}, m_prefix{std::move(prefix)}
    {
    }

    template <class T> void operator()(std::string_view key, const T& value, const Hint& hint)
    {
        if constexpr (std::is_same_v<T, std::string> || List<T>)
            if (hint.optional && value.empty()) return;
        name(key);
        write(value, m_depth, m_extra, m_prefix + escapedKey(key) + ".");
    }
    template <class T> void section(const T& value)
    {
        m_out += '{';
        fields(*this, value);
        extras();
        close();
    }
    void name(std::string_view key)
    {
        if (!std::exchange(m_first, false)) m_out += m_depth < 0 ? ", " : ",";
        breakLine(m_out, m_depth < 0 ? -1 : m_depth + 1);
        appendString(m_out, key);
        m_out += ": ";
    }
    void extras()
    {
        if (!m_extra) return;
        std::string key;
        for (const auto& [path, json] : m_extra->keys()) {
            if (!keyInSection(path, m_prefix, key)) continue;
            name(key);
            m_out += json;
        }
    }
    void close()
    {
        if (!m_first) breakLine(m_out, m_depth);
        m_out += '}';
    }

private:
    static void breakLine(std::string& out, int depth)
    {
        if (depth < 0) return;
        out += '\n';
        out.append(std::size_t(depth) * 2, ' ');
    }
    template <class T> void write(const T& value, int depth, const Extra* extra, const std::string& prefix)
    {
        if constexpr (List<T>) {
            writeList(value, depth + 1, extra, prefix);
        } else if constexpr (Section<const T>) {
            if constexpr (requires { value.extra; })
                FieldWriter{m_out, inner(depth), &value.extra}.section(value);
            else
                FieldWriter{m_out, inner(depth), extra, prefix}.section(value);
        } else {
            appendLeaf(m_out, value);
        }
    }
    static int inner(int depth) { return depth < 0 ? depth : depth + 1; }

    template <class T>
    void writeList(const std::vector<T>& list, int depth, const Extra* extra, const std::string& prefix)
    {
        m_out += '[';
        for (std::size_t i = 0; i < list.size(); ++i) {
            if (i > 0) m_out += ',';
            breakLine(m_out, depth + 1);
            write(list[i], fitsLine(list[i]) ? -1 : depth, extra, prefix + std::to_string(i) + ".");
        }
        if (!list.empty()) breakLine(m_out, depth);
        m_out += ']';
    }
    template <class T> static bool fitsLine(const T& item)
    {
        if constexpr (Section<const T>) {
            Shortness shortness;
            fields(shortness, item);
            return shortness.flat && shortness.fields <= 6;
        }
        return true;
    }

    std::string& m_out;
    int m_depth;
    const Extra* m_extra;
    std::string m_prefix;
    bool m_first = true;
};

} // namespace io
