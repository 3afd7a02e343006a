// The bytes that a glTF file names: buffers and images, embedded or in files beside it that stay in the project.
#pragma once

#include "io/files/gltf_text.h"
#include "io/scene/image.h"

#include <filesystem>
#include <memory>
#include <vector>

namespace io::gltf {

class Sources {
public:
    // `folder` is the model's own, `root` the folder that no file may lie outside of.
    Sources(const Text& text, std::filesystem::path folder, std::filesystem::path root);

    void readBuffers(); // throws Refused when one is missing, too short or outside
    std::size_t bufferCount() const { return m_buffers.size(); }
    std::string_view buffer(std::size_t index) const { return m_buffers[index]; }

    std::size_t imageCount() const;
    Result<std::shared_ptr<const Image>> readImage(std::size_t index) const; // an error is for the caller to complain of

private:
    Result<std::string> read(const std::string& uri, std::uint64_t limit) const;
    Result<std::string> bytesOfView(double view) const;

    const Text& m_text;
    std::filesystem::path m_folder;
    std::filesystem::path m_root;
    std::vector<std::string> m_owned;
    std::vector<std::string_view> m_buffers;
};

std::string percentDecoded(std::string_view uri);
Result<std::string> decodedDataUri(std::string_view uri); // "data:TYPE;base64,…"

} // namespace io::gltf
