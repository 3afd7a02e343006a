// Every program of the renderer, built from renderer/shaders and built again when a file of it changes. A faulty
// text keeps the last good program.
#pragma once

#include "io/base/content_hash.h"
#include "io/base/result.h"
#include "renderer/gl/program.h"
#include "renderer/renderer.h"

#include <chrono>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace renderer {

struct ProgramDesc {
    std::string label;
    std::vector<std::string> stages; // "lighting.frag.glsl": the middle word is the stage
    std::vector<std::string> defines;
    bool operator==(const ProgramDesc&) const = default;
};

class ShaderLibrary {
public:
    explicit ShaderLibrary(std::filesystem::path folder) : m_folder{std::move(folder)} {}

    // The same description gives the same program. It lives as long as the library and is empty only when its
    // text never was good.
    const gl::Program& program(const ProgramDesc& desc);
    const gl::Program& fullScreen(const std::string& fragment, std::vector<std::string> defines = {});

    // Tells apart the texts of stages, with all that they include.
    io::ContentKey textKey(std::span<const std::string_view> stages) const;

    void reload();       // what changed since it was built
    void reloadIfDue();  // looks at the files' times twice a second
    const std::vector<ShaderFault>& faults() const { return m_faults; }

private:
    struct WatchedFile {
        std::filesystem::path file;
        std::filesystem::file_time_type time;
    };
    struct Entry {
        ProgramDesc desc;
        gl::Program program;
        std::vector<WatchedFile> files; // of the last attempt, good or not
        std::vector<ShaderFault> faults;
    };
    void build(Entry& entry);
    bool changed(const Entry& entry) const;
    void collectFaults();

    std::filesystem::path m_folder;
    std::vector<std::unique_ptr<Entry>> m_entries;
    std::vector<ShaderFault> m_faults;
    std::chrono::steady_clock::time_point m_lastLook = std::chrono::steady_clock::now();
};

} // namespace renderer
