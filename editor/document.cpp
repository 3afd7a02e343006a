#include "editor/document.h"

#include "io/base/log.h"

#include <algorithm>

namespace editor {

io::Result<std::unique_ptr<Document>> Document::open(const std::filesystem::path& project, std::string_view scene,
                                                     const io::Progress& progress)
{
    io::Complaints complaints;
    io::Result<io::World> world = io::openWorld(project, scene, complaints);
    if (!world) return world.error();
    io::Result<io::Assets> assets = io::readAssets(*world, complaints, progress);
    if (!assets) return assets.error();
    auto document = std::make_unique<Document>(std::move(*world), std::move(*assets));
    document->m_complaints = std::move(complaints);
    return document;
}

Document::Document(io::World world, io::Assets assets) : m_world{std::move(world)}, m_assets{std::move(assets)}
{
    m_savedState = m_history.state();
    m_hierarchy.update(m_world.scene, {.everything = true});
    rememberAssets();
}

void Document::run(std::unique_ptr<Command> command)
{
    if (command->changesNothing(m_world)) return;
    apply(*command);
    if (m_gesture)
        m_gesture->add(std::move(command));
    else
        keep(std::move(command));
}

void Document::beginGesture(std::string name)
{
    if (m_gestureDepth++ == 0) m_gesture = std::make_unique<Composite>(std::move(name));
}

void Document::endGesture()
{
    if (m_gestureDepth == 0 || --m_gestureDepth > 0) return;
    std::unique_ptr<Composite> gesture = std::exchange(m_gesture, nullptr);
    if (!gesture->changesNothing(m_world)) keep(std::move(gesture));
}

void Document::keep(std::unique_ptr<Command> done)
{
    done->pack(m_world);
    m_history.push(std::move(done));
}

void Document::cancelGesture()
{
    if (!m_gesture) return;
    m_gestureDepth = 0;
    const std::unique_ptr<Composite> gesture = std::exchange(m_gesture, nullptr);
    if (!gesture->empty()) apply(*gesture);
}

std::string Document::undo()
{
    return step(&History::undo);
}

std::string Document::redo()
{
    return step(&History::redo);
}

std::string Document::step(Command* (History::*which)())
{
    m_gestureDepth = std::min(m_gestureDepth, 1);
    endGesture();
    Command* command = (m_history.*which)();
    if (!command) return {};
    apply(*command);
    return command->name();
}

void Document::goTo(std::size_t position)
{
    while (m_history.position() > position && m_history.canUndo())
        undo();
    while (m_history.position() < position && m_history.canRedo())
        redo();
}

void Document::apply(Command& command)
{
    follow(command.swap(m_world));
}

void Document::follow(const io::Changes& changes)
{
    m_hierarchy.update(m_world.scene, changes);
    readChangedAssets(changes);
    m_changes.add(changes);
    ++m_revision;
}

io::Changes Document::takeChanges()
{
    io::Changes changes = std::exchange(m_changes, {});
    const auto unique = [](auto& ids) {
        std::sort(ids.begin(), ids.end());
        ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
    };
    unique(changes.objects);
    unique(changes.templates);
    unique(changes.instances);
    return changes;
}

void setEnvironment(Document& document, std::string name, io::Environment environment)
{
    document.run(std::make_unique<SwapEnvironment>(std::move(name), std::move(environment)));
}

void setHeights(Document& document, std::string name, std::shared_ptr<const io::HeightMap> heights, const io::TexelRect& changed)
{
    document.run(std::make_unique<SwapHeights>(std::move(name), std::move(heights), changed));
}

void setCover(Document& document, std::string name, std::shared_ptr<const io::CoverMap> cover, const io::TexelRect& changed)
{
    document.run(std::make_unique<SwapCover>(std::move(name), std::move(cover), changed));
}

void setGrassMap(Document& document, std::string name, std::shared_ptr<const io::GrassMap> map, const io::TexelRect& changed)
{
    document.run(std::make_unique<SwapGrassMap>(std::move(name), std::move(map), changed));
}

void setCameras(Document& document, std::string name, std::vector<io::Camera> cameras)
{
    document.run(std::make_unique<SwapCameras>(std::move(name), std::move(cameras)));
}

void setPaths(Document& document, std::string name, std::vector<io::CameraPath> paths)
{
    document.run(std::make_unique<SwapPaths>(std::move(name), std::move(paths)));
}

void setScatterLayers(Document& document, std::string name, std::vector<io::ScatterLayer> layers)
{
    document.run(std::make_unique<SwapScatterLayers>(std::move(name), std::move(layers)));
}

void removeScatterLayer(Document& document, std::string name, io::ScatterId id)
{
    const Gesture gesture{document, name};
    std::vector<SwapInstances::Slot> tiles;
    for (const auto& [place, tile] : document.scene().instances(id))
        tiles.emplace_back(io::LayerTile{id, place}, nullptr);
    setInstances(document, name, std::move(tiles));
    std::vector<io::ScatterLayer> layers{document.scene().scatterLayers().begin(), document.scene().scatterLayers().end()};
    std::erase_if(layers, [&](const io::ScatterLayer& layer) { return layer.id == id; });
    setScatterLayers(document, std::move(name), std::move(layers));
}

void setInstances(Document& document, std::string name, std::vector<SwapInstances::Slot> tiles)
{
    document.run(std::make_unique<SwapInstances>(std::move(name), std::move(tiles)));
}

void setControls(Document& document, std::string name, std::vector<io::Control> controls)
{
    document.run(std::make_unique<SwapControls>(std::move(name), std::move(controls)));
}

void setTemplate(Document& document, std::string name, io::TemplateId id, std::optional<io::Template> value)
{
    document.run(std::make_unique<SwapTemplate>(std::move(name), id, std::move(value)));
}

void addObjects(Document& document, std::string name, std::vector<io::Object> objects)
{
    std::vector<SwapObjects::Slot> slots;
    slots.reserve(objects.size());
    for (io::Object& object : objects) {
        const io::ObjectId id = object.id;
        slots.emplace_back(id, std::move(object));
    }
    document.run(std::make_unique<SwapObjects>(std::move(name), std::move(slots)));
}

void removeObjects(Document& document, std::string name, std::span<const io::ObjectId> ids)
{
    std::vector<SwapObjects::Slot> slots;
    for (const io::ObjectId id : document.hierarchy().withMembers(ids))
        if (document.scene().find(id)) slots.emplace_back(id, std::nullopt);
    document.run(std::make_unique<SwapObjects>(std::move(name), std::move(slots)));
}

std::string displayName(const io::Scene& scene, const io::Object& object)
{
    if (!object.name.empty()) return object.name;
    const std::string_view kind =
        object.templateId == io::TemplateId::None ? "group" : scene.templateName(object.templateId);
    return std::string{kind} + " " + std::to_string(io::number(object.id));
}

} // namespace editor
