// Names of files: their kind, and one that is free.
#pragma once

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <string>

namespace io {

// ".png" of a.PNG; letters of ASCII only.
inline std::string lowerExtension(const std::filesystem::path& file)
{
    std::string extension = file.extension().string();
    std::ranges::transform(extension, extension.begin(), [](unsigned char c) { return char(std::tolower(c)); });
    return extension;
}

// A file beside this one (relative to the folder) that does not exist: name_2.png, name_3.png…
inline std::string freshFile(const std::filesystem::path& folder, const std::filesystem::path& file, const std::string& extension)
{
    const std::string stem = (file.parent_path() / file.stem()).generic_string();
    std::error_code fault;
    for (int i = 2;; ++i)
        if (std::string name = stem + "_" + std::to_string(i) + extension; !std::filesystem::exists(folder / name, fault) && !fault) return name;
}

} // namespace io
