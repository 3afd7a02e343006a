// Scene: a world as plain data. It changes only through exchange(), which gives back what it replaced: the
// inverse of a change is the same call with the answer.
#pragma once

#include "io/scene/camera.h"
#include "io/scene/changes.h"
#include "io/scene/cover_map.h"
#include "io/scene/environment.h"
#include "io/scene/grass.h"
#include "io/scene/height_map.h"
#include "io/scene/ids.h"
#include "io/scene/instance_ids.h"
#include "io/scene/object.h"
#include "io/scene/scatter.h"
#include "io/scene/template.h"
#include "io/scene/terrain.h"

#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace io {

class Scene {
public:
    // Objects lie densely, in no order that means anything. References hold until the next exchange.
    std::span<const Object> objects() const { return m_objects; }
    const Object* find(ObjectId id) const;
    const Object& at(ObjectId id) const; // the id is in the scene
    std::vector<ObjectId> sortedIds() const;

    // Slot i belongs to TemplateId{i + 1}. A slot without a value stands for a template that was deleted or whose
    // file is missing; objects keep pointing to it and its name stays known.
    struct TemplateSlot {
        std::string name;
        std::optional<Template> value;
    };
    std::span<const TemplateSlot> templates() const { return m_templates; }
    TemplateId findTemplate(std::string_view name) const; // None when there is no such slot
    const Template* find(TemplateId id) const;
    std::string_view templateName(TemplateId id) const; // empty for None

    const Environment& environment() const { return m_environment; }
    const Terrain& terrain() const { return m_terrain; }
    const std::shared_ptr<const HeightMap>& heights() const { return m_heights; } // null: no ground
    const std::shared_ptr<const CoverMap>& cover() const { return m_cover; } // as large as the heights; null: nothing was painted
    const Grass& grass() const { return m_grass; }
    const std::shared_ptr<const GrassMap>& grassMap() const { return m_grassMap; } // null: none grows
    std::span<const Camera> cameras() const { return m_cameras; }
    std::span<const CameraPath> paths() const { return m_paths; }
    const Camera* findCamera(std::string_view name) const;
    const CameraPath* findPath(std::string_view name) const;

    // Instances of a layer that is not in the list lie there unseen, until they are removed too.
    std::span<const ScatterLayer> scatterLayers() const { return m_scatterLayers; }
    const ScatterLayer* find(ScatterId id) const;
    const ScatterLayer* findScatterLayer(std::string_view name) const;
    const InstanceTiles& instances(ScatterId id) const;
    const InstanceTile* find(const LayerTile& tile) const;
    std::size_t instanceCount() const; // of the layers in the list

    // The number of an instance, for as long as its tile stays as it is; ObjectId::None, or nothing, where there is none.
    ObjectId idOf(const InstanceRef& instance) const;
    std::optional<InstanceRef> findInstance(ObjectId id) const;
    const Instance& at(const InstanceRef& instance) const; // it is in the scene
    TemplateId templateOf(const InstanceRef& instance) const; // None where the project has no such template

    // Ids and slots that no one has used. They are taken by being handed out.
    ObjectId freshId();
    void takeIdsUpTo(ObjectId last);
    ScatterId freshScatterId();
    void takeIdsUpTo(ScatterId last);
    TemplateId templateSlot(std::string_view name); // the slot of that name, made when there is none

    // The only mutators. Each sets what is given (an empty value removes) and answers what was there.
    std::optional<Object> exchange(ObjectId id, std::optional<Object> object);
    std::optional<Template> exchange(TemplateId id, std::optional<Template> value);
    Environment exchange(Environment environment);
    Terrain exchange(Terrain terrain); // heights lie where it says from then on, if that changes
    std::shared_ptr<const HeightMap> exchange(std::shared_ptr<const HeightMap> heights);
    std::shared_ptr<const CoverMap> exchange(std::shared_ptr<const CoverMap> cover);
    Grass exchange(Grass grass); // the map lies where it says from then on, if that changes
    std::shared_ptr<const GrassMap> exchange(std::shared_ptr<const GrassMap> map);
    std::vector<Camera> exchange(std::vector<Camera> cameras);
    std::vector<CameraPath> exchange(std::vector<CameraPath> paths);
    std::vector<ScatterLayer> exchange(std::vector<ScatterLayer> layers);
    InstanceTiles exchange(ScatterId layer, InstanceTiles tiles);
    std::shared_ptr<const InstanceTile> exchange(const LayerTile& tile, std::shared_ptr<const InstanceTile> value);

    void reserve(std::size_t objects);

    // Keys of the scene's own file that this version does not know.
    Extra extra;
    // The highest id that a file of this scene ever held. The object may be gone; its id stays taken.
    ObjectId lastSavedId = ObjectId::None;

private:
    std::vector<Object> m_objects;
    std::unordered_map<std::uint32_t, std::uint32_t> m_indexOf; // id -> place in m_objects
    std::uint32_t m_lastId = 0;
    std::vector<TemplateSlot> m_templates;
    Environment m_environment;
    Terrain m_terrain;
    std::shared_ptr<const HeightMap> m_heights;
    std::shared_ptr<const CoverMap> m_cover;
    Grass m_grass;
    std::shared_ptr<const GrassMap> m_grassMap;
    std::vector<Camera> m_cameras;
    std::vector<CameraPath> m_paths;
    std::vector<ScatterLayer> m_scatterLayers;
    std::map<ScatterId, InstanceTiles> m_instances; // no layer without any
    InstanceIds m_instanceIds;
    std::uint32_t m_lastScatterId = 0;
};

// The same world, whatever order its objects lie in.
bool sameContent(const Scene& a, const Scene& b);

} // namespace io
