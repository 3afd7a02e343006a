#include "editor/dialogs/height_dialogs.h"

#include "editor/dialogs/dialogs.h"
#include "editor/editor.h"
#include "editor/text.h"
#include "editor/widgets.h"
#include "io/files/file_names.h"
#include "io/files/height_export.h"
#include "io/files/image_file.h"

#include <algorithm>

namespace editor {
namespace {

namespace fs = std::filesystem;

constexpr const char* kFrom[] = {"heights.from_given",  "heights.from_file",   "heights.from_sidecar", "heights.from_name",
                                 "heights.from_ground", "heights.from_values", "heights.from_usual"};
constexpr const char* kDiffers[] = {"heights.differs_size", "heights.differs_metres", "heights.differs_heights", "heights.differs_cover"};

struct Format {
    const char* extension;
    const char* text;
    const char* note;
};
constexpr Format kFormats[] = {{".png", "heights.png", "heights.note_bits"},  {".r16", "heights.raw_bits", "heights.note_header"},
                               {".exr", "heights.exr", "heights.note_metres"}, {".tif", "heights.tif", "heights.note_metres"},
                               {".r32", "heights.raw_floats", "heights.note_header"}, {".glb", "heights.glb", "heights.note_mesh"},
                               {".gltf", "heights.gltf", "heights.note_mesh"}};

bool mayHoldHeights(const fs::path& file)
{
    constexpr std::string_view kPictures[] = {".png", ".tif", ".tiff", ".exr", ".jpg", ".jpeg", ".hdr", ".dds"};
    return io::holdsRawSamples(file) || std::ranges::count(kPictures, io::lowerExtension(file)) > 0;
}

// A number with the word of where it comes from beside it; true when a person changed it.
bool measured(const char* id, const char* label, const char* unit, double min, double max, io::KnownFrom from, double& value)
{
    constexpr float kWord = 190;
    ui::propertyLabel(label, unit);
    const float width = ImGui::GetContentRegionAvail().x - kWord;
    const bool changed = ui::number({.id = id, .label = label, .min = min, .max = max, .speed = 0.5, .decimals = 3, .width = width}, value);
    ImGui::SameLine(0, 10);
    ui::softText(tr(kFrom[std::size_t(from)]));
    return changed;
}

void lookAtAll(Editor& editor)
{
    const io::HeightMap& map = *editor.document()->scene().heights();
    const glm::dvec2 end = map.origin + glm::dvec2{map.size - 1} * map.metresPerTexel;
    const glm::dvec2 pixels{glm::max(editor.viewport().view().size, 1)};
    editor.viewport().camera.frame({{map.origin.x, map.min, map.origin.y}, {end.x, map.max, end.y}}, pixels.x / pixels.y);
}

void warning(const std::string& text)
{
    ImGui::PushTextWrapPos(0);
    ui::iconText(Icon::Warning, palette::kAmber, text);
    ImGui::PopTextWrapPos();
    mapItem("warning", text);
}

} // namespace

void HeightImportForm::start(const fs::path& folder)
{
    *this = {};
    m_browser.start(folder, mayHoldHeights);
}

void HeightImportForm::read(const fs::path& file)
{
    std::error_code fault;
    if (!fs::is_regular_file(file, fault)) { // a folder, or half a name
        if (m_file.empty()) return;
        FolderBrowser browser = std::move(m_browser);
        *this = {};
        m_browser = std::move(browser);
        return;
    }
    if (file != m_file) {
        m_layout = {};
        m_measures = {};
    } else if (!m_stale) {
        return;
    }
    m_file = file;
    m_stale = false;
    m_ofFile.clear();
    m_source.reset();
    io::Result<io::HeightSource> source = io::readHeightSource(file, m_layout, m_ofFile);
    m_fault = source ? "" : source.error().text();
    if (source) m_source = *std::move(source);
}

void HeightImportForm::plan(const Document& document)
{
    m_plan.reset();
    m_differences.clear();
    m_ofPlan.clear();
    if (!m_source) return;
    io::Result<io::ImportedGround> plan = io::planGround(*m_source, m_measures, document.scene(), m_ofPlan);
    m_fault = plan ? "" : plan.error().text();
    if (!plan) return;
    m_differences = groundDifferences(document.scene(), *plan);
    m_plan = *std::move(plan);
}

// Of bare samples, which say nothing of themselves.
void HeightImportForm::layoutFields()
{
    if (m_file.empty() || !io::holdsRawSamples(m_file) || io::isHgt(m_file)) return;
    constexpr int kUnknown = 1024;
    glm::dvec2 size{m_source ? m_source->size : m_layout.size.value_or(glm::ivec2{kUnknown})};
    ui::propertyLabel(tr("heights.size"));
    const float width = (ImGui::GetContentRegionAvail().x - 8) / 2;
    const double most = io::kGroundLimits.side;
    const auto side = [&](const char* id, const char* label, double& texels) {
        return ui::number({.id = id, .label = label, .min = 2, .max = most, .speed = 1, .decimals = 0, .width = width}, texels);
    };
    bool changed = side("##width", tr("heights.width"), size.x);
    ImGui::SameLine(0, 8);
    changed |= side("##height", tr("heights.height"), size.y);
    if (changed) m_layout.size = glm::ivec2{glm::round(size)};

    const std::vector<std::string> samples{tr("heights.u8"), tr("heights.u16"), tr("heights.i16"), tr("heights.f32")};
    int sample = int(m_source ? m_source->sample : m_layout.sample.value_or(io::HeightSample::U16));
    ui::propertyLabel(tr("heights.sample"));
    if (ui::combo("##sample", tr("heights.sample"), samples, sample)) {
        m_layout.sample = io::HeightSample(sample);
        changed = true;
    }
    bool bigEndian = m_source ? m_source->bigEndian : m_layout.bigEndian.value_or(false);
    if (ui::checkbox("big", tr("heights.big_endian"), bigEndian)) {
        m_layout.bigEndian = bigEndian;
        changed = true;
    }
    m_stale |= changed;
}

void HeightImportForm::measureFields()
{
    if (!m_source) return;
    ui::softText(trf("heights.facts", m_source->size.x, m_source->size.y, m_source->lowest, m_source->highest));
    if (!m_plan) { // what was typed makes no ground; it can be typed anew
        if (ui::button("reset", tr("heights.reset"))) m_measures = {};
        return;
    }
    double metres = m_plan->grid.metresPerTexel;
    if (measured("##metres", tr("heights.metres"), "m", 0.001, 10000, m_plan->metresFrom, metres)) m_measures.metresPerTexel = metres;
    const bool canScale = m_source->sample == io::HeightSample::F32 && m_source->lowest >= 0 && m_source->highest <= 1;
    bool scaled = m_plan->scaled;
    if (canScale && ui::checkbox("shares", tr("heights.shares"), scaled))
        m_measures.heights = scaled ? std::optional{glm::dvec2{0, 100}} : std::nullopt;
    if (!m_plan->scaled) return;
    glm::dvec2 heights = m_plan->scaledFrom;
    const bool low = measured("##low", tr("heights.lowest"), "m", -1e5, 1e5, m_plan->heightsFrom, heights.x);
    const bool high = measured("##high", tr("heights.highest"), "m", -1e5, 1e5, m_plan->heightsFrom, heights.y);
    if (low || high) m_measures.heights = heights;
}

// What is amiss with the file, and what of the ground would be another.
void HeightImportForm::findings()
{
    for (const io::Complaints* complaints : {&m_ofFile, &m_ofPlan})
        for (const io::Complaint& complaint : *complaints)
            warning(complaint.what);
    for (const GroundDifference& d : m_differences) {
        const std::string then = d.part != GroundPart::Cover ? d.then : d.then == "stretched" ? tr("heights.stretched") : tr("heights.dropped");
        warning(trf(kDiffers[std::size_t(d.part)], d.now, then));
    }
}

void HeightImportForm::draw(const Document& document)
{
    m_browser.draw(220);
    ImGui::Dummy({0, 4});
    read(m_browser.chosen());
    plan(document);
    layoutFields();
    measureFields();
    findings();
}

io::Status HeightImportForm::import(Editor& editor)
{
    io::Complaints told;
    const io::Result<io::ImportedGround> ground = io::groundFrom(*m_source, m_measures, editor.document()->scene(), told);
    if (!ground) return ground.error();
    for (const io::Complaint& complaint : m_ofFile)
        io::log::warning("{}: {}", complaint.where, complaint.what);
    const bool elsewhere = replaces() || !editor.document()->scene().heights();
    editor.step("undo.import_heights", [&](Document& document) { importGround(document, tr("undo.import_heights"), *ground, m_file); });
    editor.toasts().add(io::log::Level::Info, trf("message.heights_imported", m_file.filename().string()));
    if (elsewhere) lookAtAll(editor); // the eye may lie deep in the new ground
    return {};
}

void HeightExportForm::start(const fs::path& folder, const Document& document)
{
    m_browser.start(folder);
    const io::Terrain& terrain = document.scene().terrain();
    m_name = terrain.heightMap.empty() ? "heights" : fs::path{terrain.heightMap}.stem().string();
    m_step = document.scene().heights() ? io::meshStep(document.scene().heights()->size) : 1;
}

fs::path HeightExportForm::file() const
{
    return m_browser.chosen() / (m_name + kFormats[m_format].extension);
}

void HeightExportForm::draw(const Document& document)
{
    ui::propertyLabel(tr("heights.name"));
    ui::textField("##name", tr("heights.name"), m_name);
    std::vector<std::string> formats;
    for (const Format& format : kFormats)
        formats.emplace_back(tr(format.text));
    ui::propertyLabel(tr("heights.format"));
    ui::combo("##format", tr("heights.format"), formats, m_format);
    const io::HeightMap* heights = document.scene().heights().get();
    if (heights && io::exportsMesh(file())) {
        double step = m_step;
        ui::propertyLabel(tr("heights.step"));
        if (ui::number({.id = "##step", .label = tr("heights.step"), .min = 1, .max = 256, .decimals = 0}, step)) m_step = int(std::lround(step));
        ui::softText(trf("heights.triangles", io::meshTriangles(heights->size, m_step)));
    }
    ui::softText(tr(kFormats[m_format].note));
    ImGui::Dummy({0, 4});
    ui::softText(tr("dialog.where"));
    m_browser.draw(220);
    std::error_code fault;
    if (ready() && fs::exists(file(), fault)) warning(trf("heights.exists", file().filename().string()));
}

void Dialogs::showImportHeights(Editor& editor)
{
    if (!editor.document()) return;
    m_which = Which::ImportHeights;
    m_import.start(editor.document()->project().folder.parent_path());
}

void Dialogs::showExportHeights(Editor& editor)
{
    if (!editor.document()) return;
    m_which = Which::ExportHeights;
    m_export.start(editor.document()->project().folder.parent_path(), *editor.document());
}

void Dialogs::drawImportHeights(Editor& editor)
{
    if (!editor.document()) return close();
    if (!begin(tr("heights.import_title"), 680)) return;
    m_import.draw(*editor.document());
    m_fault = m_import.fault();
    if (buttons(m_import.replaces() ? tr("heights.replace") : tr("heights.import"), m_import.ready())) {
        const io::Status done = m_import.import(editor);
        if (done) {
            close();
            m_import = {};
        }
    }
    end();
}

void Dialogs::drawExportHeights(Editor& editor)
{
    if (!editor.document()) return close();
    if (!begin(tr("heights.export_title"), 620)) return;
    m_export.draw(*editor.document());
    if (buttons(tr("heights.export"), m_export.ready() && editor.document()->scene().heights())) {
        const auto done = exportGround(editor.document()->scene(), m_export.file(), io::exportsMesh(m_export.file()) ? m_export.step() : 0);
        if (!done) {
            m_fault = done.error().text();
        } else {
            editor.toasts().add(io::log::Level::Info, trf("message.heights_exported", m_export.file().string()));
            close();
        }
    }
    end();
}

} // namespace editor
