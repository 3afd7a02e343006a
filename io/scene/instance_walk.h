// Walks over instances with all there is to know of each: number, template, where it stands.
#pragma once

#include "io/scene/scene.h"

namespace io {

// By species; None where the project has no such template.
inline std::vector<TemplateId> templatesOf(const Scene& scene, const ScatterLayer& layer)
{
    std::vector<TemplateId> ids;
    for (const Species& species : layer.species)
        ids.push_back(scene.findTemplate(species.templateName));
    return ids;
}

// visit(id, template, transform) for each instance of a tile, in their order; none where its layer is not in the list.
template <class Visit> void eachInstance(const Scene& scene, const LayerTile& at, Visit&& visit)
{
    const ScatterLayer* layer = scene.find(at.layer);
    const InstanceTile* tile = scene.find(at);
    if (!layer || !tile) return;
    const std::vector<TemplateId> templates = templatesOf(scene, *layer);
    std::uint32_t id = number(scene.idOf({at, 0}));
    for (const Instance& instance : tile->instances)
        visit(ObjectId{id++}, instance.species < templates.size() ? templates[instance.species] : TemplateId::None,
              transformOf(at.tile, instance));
}

// visit(at) for each tile of each layer in the list.
template <class Visit> void eachTile(const Scene& scene, Visit&& visit)
{
    for (const ScatterLayer& layer : scene.scatterLayers())
        for (const auto& [place, tile] : scene.instances(layer.id))
            visit(LayerTile{layer.id, place});
}

} // namespace io
