// The JSON of a glTF or GLB file, checked before anything else looks at it. glTF 2.0, section 4.4 (GLB).
#pragma once

#include "io/base/complaint.h"
#include "io/base/result.h"
#include "io/base/value.h"

#include <string>
#include <string_view>

namespace io::gltf {

// Thrown inside the reader of models when the file cannot be trusted; never leaves it.
struct Refused {
    std::string what;
};

// What is wrong with a part of the file that is dropped or mended. At most 50 a file.
class Notes {
public:
    Notes(std::string where, Complaints& complaints) : m_where{std::move(where)}, m_complaints{complaints} {}
    void warn(std::string what);
    const std::string& where() const { return m_where; }
    const std::string& first() const { return m_first; }

private:
    std::string m_where;
    Complaints& m_complaints;
    std::string m_first;
    int m_count = 0;
};

struct Text {
    Value json;              // an object; its extensions and sizes were checked
    std::string_view binary; // the BIN chunk of a GLB; empty when there is none
};

// Throws Refused: broken GLB or JSON, another version than 2, a required extension that Wold lacks, sizes that
// are no sizes, too many nodes.
Text readText(std::string_view bytes, Notes& notes);

} // namespace io::gltf
