// RayMesh: the triangles of one model as an Embree tree, shared by all its instances; and owners of Embree's handles.
#pragma once

#include "editor/alpha_test.h"
#include "io/scene/model.h"

#include <embree3/rtcore.h>
#include <map>
#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

namespace editor {

struct ReleaseEmbree {
    void operator()(RTCScene scene) const { rtcReleaseScene(scene); }
    void operator()(RTCGeometry geometry) const { rtcReleaseGeometry(geometry); }
    void operator()(RTCDevice device) const { rtcReleaseDevice(device); }
};
using EmbreeDevice = std::unique_ptr<std::remove_pointer_t<RTCDevice>, ReleaseEmbree>;
using EmbreeScene = std::unique_ptr<std::remove_pointer_t<RTCScene>, ReleaseEmbree>;
using EmbreeGeometry = std::unique_ptr<std::remove_pointer_t<RTCGeometry>, ReleaseEmbree>;

// Asked at each hit of a part with holes; defined by what sends the rays (editor/ray_tree.h).
void filterHit(const RTCFilterFunctionNArguments* arguments);

class RayMesh {
public:
    // The buffers of the model are used in place.
    RayMesh(RTCDevice device, std::shared_ptr<const io::Model> model);
    RayMesh(const RayMesh&) = delete;
    RayMesh& operator=(const RayMesh&) = delete;

    const std::shared_ptr<const io::Model>& model() const { return m_model; }
    const PartOfModel& part(unsigned geometry) const { return m_parts[geometry]; }
    RTCScene scene() const { return m_scene.get(); }

private:
    AlphaMips* mipsOf(const io::Material& material);

    std::shared_ptr<const io::Model> m_model;
    std::vector<PartOfModel> m_parts;                               // by Embree's number; stay where they are
    std::map<std::pair<const io::Image*, float>, AlphaMips> m_mips; // by image and cutoff; stay where they are
    EmbreeScene m_scene;
};

// The box around a model, as a model.
std::shared_ptr<const io::Model> boxAround(const io::Box& bounds);

inline glm::vec3 corner(const io::Model& model, std::size_t index)
{
    return model.vertices[model.indices[index]].position;
}

} // namespace editor
