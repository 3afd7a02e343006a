#include "io/base/text_place.h"

#include <fstream>

namespace io {

std::string placeOf(const std::filesystem::path& file, const std::string& text)
{
    std::ifstream in{file};
    const std::string quoted = '"' + text + '"';
    int number = 0;
    for (std::string line; std::getline(in, line);) {
        ++number;
        if (line.find(quoted) != std::string::npos) return file.string() + ":" + std::to_string(number);
    }
    return file.string() + ":1";
}

} // namespace io
