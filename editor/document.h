// Document: owns an open world and is the only place that changes it. Everything runs through commands, so
// everything can be undone; mirrors (renderer, picker, panels) follow by takeChanges().
#pragma once

#include "editor/commands.h"
#include "editor/hierarchy.h"
#include "editor/history.h"
#include "io/base/progress.h"
#include "io/files/project.h"

#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace editor {

class Document {
public:
    static io::Result<std::unique_ptr<Document>> open(const std::filesystem::path& project, std::string_view scene = {},
                                                      const io::Progress& progress = {});
    explicit Document(io::World world, io::Assets assets = {});
    Document(const Document&) = delete;
    Document& operator=(const Document&) = delete;

    const io::World& world() const { return m_world; }
    const io::Project& project() const { return m_world.project; }
    const io::Scene& scene() const { return m_world.scene; }
    const io::Assets& assets() const { return m_assets; }
    const Hierarchy& hierarchy() const { return m_hierarchy; }
    const io::Complaints& complaints() const { return m_complaints; } // of loading; grows

    // Ids are taken by being handed out, used or not.
    io::ObjectId freshId() { return m_world.scene.freshId(); }
    io::ScatterId freshScatterId() { return m_world.scene.freshScatterId(); }
    io::TemplateId templateSlot(std::string_view name) { return m_world.scene.templateSlot(name); }

    // Does the command and keeps it for undo. One that would change nothing is dropped.
    void run(std::unique_ptr<Command> command);

    // Everything run between the two is one step, kept as the oldest and the newest value of each thing. They
    // may nest; the outermost counts. A cancelled gesture leaves the world as it was at its beginning.
    void beginGesture(std::string name);
    void endGesture();
    void cancelGesture();
    bool inGesture() const { return m_gestureDepth > 0; }

    // An open gesture is ended first. The name of what was undone, empty when there is nothing.
    std::string undo();
    std::string redo();
    void goTo(std::size_t position); // undoes or redoes until so many steps are done
    const History& history() const { return m_history; }
    void setUndoBudget(std::size_t bytes) { m_history.setBudget(bytes); }

    bool modified() const { return m_history.state() != m_savedState || gestureChanged(); }
    io::Result<io::FileTransaction::Report> save();
    // The whole project into a new or empty folder, which then is the one that is open.
    io::Result<io::FileTransaction::Report> saveAs(const std::filesystem::path& folder);
    io::Status reload(const io::Progress& progress = {}); // from disk; forgets the history

    // The heights of the file that such a terrain names; null where there are none or, with a complaint, they cannot be read.
    std::shared_ptr<const io::HeightMap> readHeights(const io::Terrain& terrain);

    std::shared_ptr<const io::CoverMap> readCover(const io::Terrain& terrain); // likewise, for the heights that are there
    std::shared_ptr<const io::GrassMap> readGrassMap(const io::Grass& grass);  // likewise

    // Reads the model of a template again, as after its file changed.
    void reloadModel(io::TemplateId id);

    // What happened since the last call, each id once; `everything` at the first.
    io::Changes takeChanges();
    std::uint64_t revision() const { return m_revision; } // rises with every change

private:
    void apply(Command& command);
    void keep(std::unique_ptr<Command> done);
    std::string step(Command* (History::*which)());
    void follow(const io::Changes& changes);
    void readChangedAssets(const io::Changes& changes);
    void readChangedTerrain();
    void rememberAssets();
    bool gestureChanged() const { return m_gesture && !m_gesture->changesNothing(m_world); }

    struct ReadModel { // of what a template's model was made
        std::string model;
        glm::vec3 markerSize{0};
        bool operator==(const ReadModel&) const = default;
    };

    io::World m_world;
    io::Assets m_assets;
    io::Complaints m_complaints;
    Hierarchy m_hierarchy;
    History m_history;
    std::unique_ptr<Composite> m_gesture;
    int m_gestureDepth = 0;
    std::uint64_t m_savedState = 0;
    io::Changes m_changes{.everything = true};
    std::uint64_t m_revision = 1;
    std::vector<ReadModel> m_readModels;
    io::Terrain m_readTerrain;
};

// One gesture as a scope. Ends when it goes out of scope, unless cancelled.
class Gesture {
public:
    Gesture(Document& document, std::string name) : m_document{document} { document.beginGesture(std::move(name)); }
    ~Gesture()
    {
        if (m_open) m_document.endGesture();
    }
    Gesture(const Gesture&) = delete;
    Gesture& operator=(const Gesture&) = delete;
    void cancel()
    {
        m_document.cancelGesture();
        m_open = false;
    }

private:
    Document& m_document;
    bool m_open = true;
};

// edit(document, "Move", ids, [&](io::Object& o) { o.transform.position += delta; }); ids not in the scene are skipped.
void edit(Document& document, std::string name, std::span<const io::ObjectId> ids, auto&& change)
{
    std::vector<SwapObjects::Slot> slots;
    slots.reserve(ids.size());
    for (const io::ObjectId id : ids) {
        const io::Object* object = document.scene().find(id);
        if (!object) continue;
        io::Object copy = *object;
        change(copy);
        slots.emplace_back(id, std::move(copy));
    }
    document.run(std::make_unique<SwapObjects>(std::move(name), std::move(slots)));
}

void setEnvironment(Document& document, std::string name, io::Environment environment);
// Another file is read; other heights of the lowest and highest value scale the ground.
io::Status setTerrain(Document& document, std::string name, io::Terrain terrain);
// `changed`: where they differ from the scene's.
void setHeights(Document& document, std::string name, std::shared_ptr<const io::HeightMap> heights, const io::TexelRect& changed);
void setCover(Document& document, std::string name, std::shared_ptr<const io::CoverMap> cover, const io::TexelRect& changed);
// Another file of the map is read.
void setGrass(Document& document, std::string name, io::Grass grass);
void setGrassMap(Document& document, std::string name, std::shared_ptr<const io::GrassMap> map, const io::TexelRect& changed);
void setCameras(Document& document, std::string name, std::vector<io::Camera> cameras);
void setControls(Document& document, std::string name, std::vector<io::Control> controls);
void setPaths(Document& document, std::string name, std::vector<io::CameraPath> paths);
void setScatterLayers(Document& document, std::string name, std::vector<io::ScatterLayer> layers);
void removeScatterLayer(Document& document, std::string name, io::ScatterId id); // with its instances
void setInstances(Document& document, std::string name, std::vector<SwapInstances::Slot> tiles);
void setTemplate(Document& document, std::string name, io::TemplateId id, std::optional<io::Template> value);
void addObjects(Document& document, std::string name, std::vector<io::Object> objects);      // each with a fresh id
void removeObjects(Document& document, std::string name, std::span<const io::ObjectId> ids); // with the groups' members

// "Oak 17" or the name that a person gave.
std::string displayName(const io::Scene& scene, const io::Object& object);

} // namespace editor
