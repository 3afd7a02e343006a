// Dotted paths of unknown keys: a key that holds a dot itself has it escaped.
#pragma once

#include <string>
#include <string_view>

namespace io {

inline std::string escapedKey(std::string_view key)
{
    std::string escaped;
    for (const char c : key) {
        if (c == '.' || c == '\\') escaped += '\\';
        escaped += c;
    }
    return escaped;
}

// The key that `path` ends in when it lies directly in the section `prefix` ("sun."); false when it does not.
inline bool keyInSection(std::string_view path, std::string_view prefix, std::string& key)
{
    if (!path.starts_with(prefix)) return false;
    key.clear();
    for (std::size_t i = prefix.size(); i < path.size(); ++i) {
        if (path[i] == '.') return false;
        if (path[i] == '\\' && i + 1 < path.size()) ++i;
        key += path[i];
    }
    return true;
}

} // namespace io
