// Materials, textures and images of a glTF file. What is wrong with them is mended or left out, never refused.
#pragma once

#include "io/files/gltf_sources.h"
#include "io/scene/model.h"

#include <tiny_gltf.h>

namespace io::gltf {

class Materials {
public:
    Materials(const tinygltf::Model& model, const Sources& sources, Notes& notes);

    // Into list(): the material of this number of the file, or the usual one when there is none. Read once.
    int use(int material);
    std::vector<Material> list;
    std::vector<std::shared_ptr<const Image>> images; // only those that are used

private:
    Material read(const tinygltf::Material& source, const std::string& place);
    TextureUse texture(int index, int uvSet, const tinygltf::ExtensionMap& extensions, const std::string& place);
    int image(int source, const std::string& place);

    const tinygltf::Model& m_model;
    const Sources& m_sources;
    Notes& m_notes;
    std::vector<int> m_place; // in `list`, by the file's number + 1; -1: not yet
    std::vector<int> m_imagePlace;
    std::uint64_t m_imageBytes = 0;
};

} // namespace io::gltf
