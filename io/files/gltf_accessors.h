// Accessors of a glTF file as numbers, each checked before a byte of it is read. glTF 2.0, section 3.6.2.
#pragma once

#include "io/files/gltf_sources.h"

#include <glm/glm.hpp>
#include <tiny_gltf.h>

#include <map>
#include <vector>

namespace io::gltf {

// One row an element; components that the accessor lacks are 0.
using Rows = std::vector<glm::vec4>;

// What a reader asks of an accessor.
struct Wanted {
    std::vector<int> types; // TINYGLTF_TYPE_…
    bool onlyFloat = false; // no quantized components
};

class Accessors {
public:
    Accessors(const tinygltf::Model& model, const Sources& sources) : m_model{model}, m_sources{sources} {}

    std::size_t count(int accessor) const; // throws Refused when there is no such accessor, as all here do
    const Rows& rows(int accessor, const Wanted& wanted); // normalized integers become 0..1 or -1..1; read once
    std::vector<std::uint32_t> indices(int accessor) const;

private:
    struct Range {
        const unsigned char* data = nullptr; // null: zeros
        std::size_t stride = 0;
    };
    const tinygltf::Accessor& at(int accessor) const;
    Range range(int view, std::size_t offset, std::size_t count, std::size_t elementSize, bool strided,
                const std::string& place) const;
    Rows read(int accessor) const;
    void replaceSparse(const tinygltf::Accessor& accessor, const std::string& place, Rows& rows) const;

    const tinygltf::Model& m_model;
    const Sources& m_sources;
    std::map<int, Rows> m_rows;
    std::size_t m_elements = 0;
};

} // namespace io::gltf
