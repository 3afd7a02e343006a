// How far a sound reaches, as handles in the view: two at its radius, and its curve along the radius with a handle for each key.
#pragma once

#include "editor/view.h"
#include "io/scene/object.h"
#include "io/scene/template.h"

#include <span>
#include <vector>

namespace editor {

// Where the curve stands: along the picture's width, as high as a share of the radius.
struct SoundFrame {
    glm::dvec3 middle{0}; // m, world
    glm::dvec3 along{1, 0, 0}, up{0, 1, 0};
    double radius = 1; // m

    glm::dvec3 at(double share, double level) const;
};

struct SoundHandle {
    enum class Kind { None, Radius, Key };
    Kind kind = Kind::None;
    std::size_t key = 0;
    bool operator==(const SoundHandle&) const = default;
};

glm::dvec3 soundPlace(const io::Object& object, const io::SoundSource& sound);
SoundFrame soundFrame(const View& view, const io::Object& object, const io::SoundSource& sound);

struct SoundMark {
    SoundHandle handle;
    glm::dvec2 pixel{0};
};
std::vector<SoundMark> soundMarks(const View& view, const SoundFrame& frame, const io::SoundSource& sound); // those before the eye
SoundHandle soundHandleAt(std::span<const SoundMark> marks, glm::dvec2 pixel);
std::vector<glm::dvec2> soundCurve(const View& view, const SoundFrame& frame, const io::SoundSource& sound); // up to where it leaves the view

// The sound with the handle taken to that pixel. `step`: metres to which the radius snaps, 0 for none.
io::SoundSource soundDragged(const View& view, const SoundFrame& frame, io::SoundSource sound, const SoundHandle& handle, glm::dvec2 pixel, double step);

} // namespace editor
