// What a command changed: all that a mirror of the scene (GPU, Embree, panels) needs to follow it.
#pragma once

#include "io/scene/ids.h"
#include "io/scene/instances.h"
#include "io/scene/texel_rect.h"

#include <vector>

namespace io {

struct Changes {
    std::vector<ObjectId> objects;     // added, moved, edited or removed: look in the scene for what is true now
    std::vector<TemplateId> templates; // edited, or a model that came, went or was read again
    bool environment = false;
    bool cameras = false;
    bool terrain = false;
    std::vector<TexelRect> heights; // parts of the ground that rose or sank; all of it for another map
    std::vector<TexelRect> cover;   // parts of it that were painted
    bool grass = false;              // its kinds, or where its map lies
    std::vector<TexelRect> grassMap; // parts of it that were painted
    bool scatter = false;                // the list of scatter layers, or what one of them says
    std::vector<LayerTile> instances;    // tiles of which instances came, went or changed
    bool everything = false; // another scene: rebuild

    bool none() const
    {
        return objects.empty() && templates.empty() && !environment && !cameras && !terrain &&
               heights.empty() && cover.empty() && !grass && grassMap.empty() &&
               !scatter && instances.empty() && !everything;
    }
    void add(const Changes& other)
    {
        objects.insert(objects.end(), other.objects.begin(), other.objects.end());
        templates.insert(templates.end(), other.templates.begin(), other.templates.end());
        environment |= other.environment;
        cameras |= other.cameras;
        terrain |= other.terrain;
        heights.insert(heights.end(), other.heights.begin(), other.heights.end());
        cover.insert(cover.end(), other.cover.begin(), other.cover.end());
        grass |= other.grass;
        grassMap.insert(grassMap.end(), other.grassMap.begin(), other.grassMap.end());
        scatter |= other.scatter;
        instances.insert(instances.end(), other.instances.begin(), other.instances.end());
        everything |= other.everything;
    }
};

} // namespace io
