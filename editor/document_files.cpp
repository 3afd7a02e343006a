// What a document reads and writes: the heavy files of its scene, save, save as and reload.
#include "editor/document.h"

#include "io/base/log.h"
#include "io/scene/height_map_builder.h"

#include <algorithm>

namespace editor {
namespace {

void logComplaints(const io::Complaints& complaints, std::size_t from)
{
    for (std::size_t i = from; i < complaints.size(); ++i)
        io::log::warning("{}: {}", complaints[i].where, complaints[i].what);
}

constexpr double kLeastSpan = 1e-3; // m; heights squeezed into less could not be drawn apart again

// The same shares of the way from one pair of heights to the other.
std::shared_ptr<const io::HeightMap> scaled(const io::HeightMap& heights, const io::Terrain& from, const io::Terrain& to)
{
    const double factor = (to.maxHeight - to.minHeight) / (from.maxHeight - from.minHeight);
    io::HeightMapBuilder scaled{heights.size};
    for (int z = 0; z < heights.size.y; ++z) {
        std::vector<float> row = heights.field().read({{0, z}, {heights.size.x, z + 1}});
        for (float& metres : row)
            metres = float(to.minHeight + (double(metres) - from.minHeight) * factor);
        scaled.addRow(row);
    }
    io::HeightMap map = scaled.finish(heights.metresPerTexel, heights.origin);
    map.shares = heights.shares;
    return std::make_shared<const io::HeightMap>(std::move(map));
}

bool sameImages(const io::Terrain& a, const io::Terrain& b)
{
    return std::ranges::equal(a.layers, b.layers, [](const io::TerrainLayer& x, const io::TerrainLayer& y) {
        return x.texture == y.texture && x.normalTexture == y.normalTexture && x.roughnessTexture == y.roughnessTexture && x.heightTexture == y.heightTexture;
    });
}

// The project's files as they lie on disk, without the folder of a version control system.
io::Status copyFolder(const std::filesystem::path& from, const std::filesystem::path& to)
{
    namespace fs = std::filesystem;
    std::error_code fault;
    fs::create_directories(to, fault);
    for (fs::recursive_directory_iterator it{from, fault}, end; !fault && it != end; it.increment(fault)) {
        if (it->path().filename() == ".git") {
            it.disable_recursion_pending();
            continue;
        }
        const fs::path target = to / fs::relative(it->path(), from, fault);
        if (it->is_symlink(fault))
            fs::copy_symlink(it->path(), target, fault);
        else if (it->is_directory(fault))
            fs::create_directories(target, fault);
        else if (it->is_regular_file(fault))
            fs::copy_file(it->path(), target, fault);
    }
    if (fault)
        return io::Error{to.string(),
                         "could not copy the project here (" + fault.message() + "); choose another folder"};
    return {};
}

io::Status usableForSaveAs(const std::filesystem::path& source, const std::filesystem::path& target)
{
    namespace fs = std::filesystem;
    std::error_code fault;
    if (fs::exists(target, fault) && !(fs::is_directory(target, fault) && fs::is_empty(target, fault)))
        return io::Error{target.string(), "is not an empty folder; name a new one"};
    const fs::path inside = fs::weakly_canonical(target, fault).lexically_relative(fs::weakly_canonical(source, fault));
    if (!inside.empty() && *inside.begin() != "..")
        return io::Error{target.string(), "lies inside the project itself; name a folder outside of it"};
    return {};
}

} // namespace

void Document::rememberAssets()
{
    m_readTerrain = m_world.scene.terrain();
    m_readModels.clear();
    for (const io::Scene::TemplateSlot& slot : m_world.scene.templates())
        m_readModels.push_back(slot.value ? ReadModel{slot.value->model, slot.value->markerSize} : ReadModel{});
}

void Document::readChangedAssets(const io::Changes& changes)
{
    for (const io::TemplateId id : changes.templates) {
        const io::Template* value = m_world.scene.find(id);
        const ReadModel wanted = value ? ReadModel{value->model, value->markerSize} : ReadModel{};
        const std::size_t slot = io::number(id) - 1;
        if (m_readModels.size() <= slot) m_readModels.resize(slot + 1);
        const bool have = m_assets.models.size() > slot && m_assets.models[slot];
        if (!have || m_readModels[slot] != wanted) reloadModel(id);
    }
    if (changes.terrain) readChangedTerrain();
}

// Only the files that another part of the terrain is made of now: a rule of a layer is dragged without reading any.
void Document::readChangedTerrain()
{
    const io::Terrain& now = m_world.scene.terrain();
    const bool images = !sameImages(now, m_readTerrain);
    m_readTerrain = now;
    if (!images) return;
    io::Terrain wanted = now;
    wanted.heightMap.clear();
    io::World ground; // a world that names nothing but those files
    ground.project = m_world.project;
    ground.entry = m_world.entry;
    ground.scene.exchange(std::move(wanted));
    const std::size_t before = m_complaints.size();
    if (io::Result<io::Assets> read = io::readAssets(ground, m_complaints); read) m_assets.layers = std::move(read->layers);
    logComplaints(m_complaints, before);
}

std::shared_ptr<const io::HeightMap> Document::readHeights(const io::Terrain& terrain)
{
    if (terrain.heightMap.empty()) return nullptr;
    const std::size_t before = m_complaints.size();
    auto heights = io::readHeights(m_world, terrain, m_complaints);
    if (heights) m_world.heightFiles[terrain.heightMap] = {heights, terrain.minHeight, terrain.maxHeight};
    logComplaints(m_complaints, before);
    return heights;
}

std::shared_ptr<const io::CoverMap> Document::readCover(const io::Terrain& terrain)
{
    if (terrain.coverMap.empty() || !m_world.scene.heights()) return nullptr;
    const std::size_t before = m_complaints.size();
    auto cover = io::readCover(m_world, terrain, m_world.scene.heights()->size, m_complaints);
    if (cover) m_world.coverFiles[terrain.coverMap] = cover;
    logComplaints(m_complaints, before);
    return cover;
}

std::shared_ptr<const io::GrassMap> Document::readGrassMap(const io::Grass& grass)
{
    const std::size_t before = m_complaints.size();
    auto map = io::readGrassMap(m_world, grass, m_complaints);
    if (map) m_world.grassFiles[grass.map] = map;
    logComplaints(m_complaints, before);
    return map;
}

void setGrass(Document& document, std::string name, io::Grass grass)
{
    const bool otherFile = grass.map != document.scene().grass().map;
    const Gesture gesture{document, name};
    document.run(std::make_unique<SwapGrass>(name, grass));
    if (!otherFile) return;
    const auto read = document.readGrassMap(grass);
    setGrassMap(document, name, read, read ? read->field().rect() : io::TexelRect{});
}

io::Status setTerrain(Document& document, std::string name, io::Terrain terrain)
{
    const io::Terrain before = document.scene().terrain();
    const auto heights = document.scene().heights();
    const bool otherFile = terrain.heightMap != before.heightMap;
    const auto otherHeights = otherFile ? document.readHeights(terrain) : nullptr;
    if (otherFile && !terrain.heightMap.empty() && !otherHeights) return io::Error{terrain.heightMap, "is no height map that can be read; the ground stays as it is"};
    const bool otherRange = terrain.minHeight != before.minHeight || terrain.maxHeight != before.maxHeight;
    const Gesture gesture{document, name};
    document.run(std::make_unique<SwapTerrain>(name, terrain));
    if (otherFile) setHeights(document, name, otherHeights, otherHeights ? otherHeights->texels() : io::TexelRect{});
    if (otherFile || terrain.coverMap != before.coverMap) {
        const auto read = document.readCover(terrain);
        setCover(document, name, read, read ? read->rect() : io::TexelRect{});
    }
    if (otherFile) return {};
    if (!otherRange || !heights || !heights->shares) return {};
    if (std::abs(before.maxHeight - before.minHeight) < kLeastSpan || std::abs(terrain.maxHeight - terrain.minHeight) < kLeastSpan) return {};
    setHeights(document, name, scaled(*document.scene().heights(), before, terrain), heights->texels());
    return {};
}

void Document::reloadModel(io::TemplateId id)
{
    const std::size_t slot = io::number(id) - 1;
    if (m_assets.models.size() <= slot) m_assets.models.resize(slot + 1);
    if (m_readModels.size() <= slot) m_readModels.resize(slot + 1);
    const std::size_t before = m_complaints.size();
    m_assets.models[slot] = io::readTemplateModel(m_world, id, m_complaints);
    const io::Template* value = m_world.scene.find(id);
    m_readModels[slot] = value ? ReadModel{value->model, value->markerSize} : ReadModel{};
    logComplaints(m_complaints, before);
    m_changes.templates.push_back(id);
    ++m_revision;
}

io::Result<io::FileTransaction::Report> Document::save()
{
    m_gestureDepth = std::min(m_gestureDepth, 1);
    endGesture();
    io::Result<io::FileTransaction::Report> report = io::saveWorld(m_world);
    if (report) m_savedState = m_history.state();
    return report;
}

io::Result<io::FileTransaction::Report> Document::saveAs(const std::filesystem::path& folder)
{
    namespace fs = std::filesystem;
    const fs::path source = m_world.project.folder;
    const fs::path target = fs::absolute(folder).lexically_normal();
    if (const io::Status usable = usableForSaveAs(source, target); !usable) return usable.error();

    // All of it beside the target first, so that the target is there whole or not at all.
    fs::path half = target;
    if (!half.has_filename()) half = half.parent_path();
    half += ".saving";
    std::error_code fault;
    if (fs::exists(half, fault)) return io::Error{half.string(), "is in the way; remove it or name another folder"};
    const io::Status copied = copyFolder(source, half);
    if (!copied) {
        fs::remove_all(half, fault);
        return copied.error();
    }
    const io::Project projectBefore = m_world.project;
    const auto templateFilesBefore = m_world.templateFiles;
    const auto heightFilesBefore = m_world.heightFiles;
    const auto coverFilesBefore = m_world.coverFiles;
    const auto grassFilesBefore = m_world.grassFiles;
    const auto instanceFilesBefore = m_world.instanceFiles;
    const io::Terrain terrainBefore = m_world.scene.terrain();
    const std::uint64_t savedBefore = m_savedState;
    m_world.project.folder = half;
    io::Result<io::FileTransaction::Report> report = save();
    if (report) {
        fs::rename(half, target, fault);
        if (fault) report = io::Error{target.string(), "could not be made (" + fault.message() + ")"};
    }
    if (report)
        for (fs::path& file : report->written)
            if (file.is_absolute()) file = target / file.lexically_relative(half);
    m_world.project.folder = target;
    if (!report) {
        m_world.project = projectBefore;
        m_world.templateFiles = templateFilesBefore;
        m_world.heightFiles = heightFilesBefore;
        m_world.coverFiles = coverFilesBefore;
        m_world.grassFiles = grassFilesBefore;
        m_world.instanceFiles = instanceFilesBefore;
        m_world.scene.exchange(terrainBefore);
        m_savedState = savedBefore;
        fs::remove_all(half, fault);
    }
    return report;
}

io::Status Document::reload(const io::Progress& progress)
{
    io::Complaints complaints;
    io::Result<io::World> world = io::openWorld(m_world.project.folder, m_world.entry.name, complaints);
    if (!world) return world.error();
    io::Result<io::Assets> assets = io::readAssets(*world, complaints, progress);
    if (!assets) return assets.error();
    m_gesture.reset();
    m_gestureDepth = 0;
    m_world = std::move(*world);
    m_assets = std::move(*assets);
    m_complaints = std::move(complaints);
    m_history.clear();
    m_savedState = m_history.state();
    rememberAssets();
    follow({.everything = true});
    return {};
}

} // namespace editor
