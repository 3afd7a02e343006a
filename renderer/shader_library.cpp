#include "renderer/shader_library.h"

#include "io/base/log.h"
#include "renderer/shader_source.h"

#include <algorithm>

namespace renderer {
namespace fs = std::filesystem;
namespace {

GLenum stageOf(std::string_view file)
{
    if (file.find(".vert.") != std::string_view::npos) return GL_VERTEX_SHADER;
    if (file.find(".tesc.") != std::string_view::npos) return GL_TESS_CONTROL_SHADER;
    if (file.find(".tese.") != std::string_view::npos) return GL_TESS_EVALUATION_SHADER;
    if (file.find(".geom.") != std::string_view::npos) return GL_GEOMETRY_SHADER;
    if (file.find(".comp.") != std::string_view::npos) return GL_COMPUTE_SHADER;
    return GL_FRAGMENT_SHADER;
}

fs::file_time_type timeOf(const fs::path& file)
{
    std::error_code ignored;
    return fs::last_write_time(file, ignored);
}

} // namespace

const gl::Program& ShaderLibrary::program(const ProgramDesc& desc)
{
    for (const std::unique_ptr<Entry>& entry : m_entries)
        if (entry->desc == desc) return entry->program;
    Entry& entry = *m_entries.emplace_back(std::make_unique<Entry>());
    entry.desc = desc;
    build(entry);
    collectFaults();
    return entry.program;
}

const gl::Program& ShaderLibrary::fullScreen(const std::string& fragment, std::vector<std::string> defines)
{
    return program({.label = fragment,
                    .stages = {"full_screen.vert.glsl", fragment + ".frag.glsl"},
                    .defines = std::move(defines)});
}

void ShaderLibrary::build(Entry& entry)
{
    entry.faults.clear();
    entry.files.clear();
    std::vector<ShaderSource> sources;
    std::vector<gl::StageText> stages;
    for (const std::string& name : entry.desc.stages) {
        io::Result<ShaderSource> source = readShader(m_folder, name, entry.desc.defines);
        if (!source) {
            entry.files.push_back({m_folder / name, timeOf(m_folder / name)});
            entry.faults.push_back({.where = source.error().where, .what = source.error().what});
            return;
        }
        for (const fs::path& file : source->files)
            entry.files.push_back({file, timeOf(file)});
        stages.push_back({.stage = stageOf(name), .text = source->text});
        sources.push_back(std::move(*source));
    }
    gl::BuildLog log;
    gl::Program program = gl::link(entry.desc.label, stages, log);
    if (program) {
        entry.program = std::move(program);
        return;
    }
    const std::string where = log.stage < 0 ? entry.desc.label : placeOf(sources[std::size_t(log.stage)], log.text);
    entry.faults.push_back({.where = where, .what = log.text});
}

io::ContentKey ShaderLibrary::textKey(std::span<const std::string_view> stages) const
{
    io::ContentHash hash;
    for (const std::string_view stage : stages)
        if (const io::Result<ShaderSource> source = readShader(m_folder, stage, {})) hash.add(source->text);
    return hash.key();
}

bool ShaderLibrary::changed(const Entry& entry) const
{
    return std::ranges::any_of(entry.files, [](const WatchedFile& f) { return timeOf(f.file) != f.time; });
}

void ShaderLibrary::reload()
{
    for (const std::unique_ptr<Entry>& entry : m_entries)
        if (changed(*entry)) build(*entry);
    collectFaults();
}

void ShaderLibrary::reloadIfDue()
{
    const auto now = std::chrono::steady_clock::now();
    if (now - m_lastLook < std::chrono::milliseconds{500}) return;
    m_lastLook = now;
    if (std::ranges::any_of(m_entries, [&](const auto& entry) { return changed(*entry); })) reload();
}

void ShaderLibrary::collectFaults()
{
    std::vector<ShaderFault> faults;
    for (const std::unique_ptr<Entry>& entry : m_entries)
        for (const ShaderFault& fault : entry->faults)
            if (std::ranges::none_of(faults, [&](const ShaderFault& f) { return f.where == fault.where; })) faults.push_back(fault);
    for (const ShaderFault& fault : faults)
        if (std::ranges::none_of(m_faults, [&](const ShaderFault& f) { return f.where == fault.where && f.what == fault.what; }))
            io::log::error("{}: {}", fault.where, fault.what);
    m_faults = std::move(faults);
}

} // namespace renderer
