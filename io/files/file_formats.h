// What each file of a project holds beside the fields of the things in it: a header, and how they nest.
#pragma once

#include "io/files/project.h"
#include "io/scene/fields.h"

#include <type_traits>

namespace io {

constexpr int kFileVersion = 1;

// Every file is one object that begins with its format and version.
template <class Body> struct Headed {
    std::string format;
    int version = 0;
    Body body;
};

template <class T> struct IsHeaded : std::false_type {
};
template <class Body> struct IsHeaded<Headed<Body>> : std::true_type {
};

template <class T>
requires IsHeaded<std::remove_const_t<T>>::value void fields(auto& v, T& file)
{
    v("format", file.format, Hint{});
    v("version", file.version, Hint{.min = 0});
    fields(v, file.body);
}

void fields(auto& v, Of<SceneEntry> auto& e)
{
    v("name", e.name, Hint{});
    v("file", e.file, Hint{.style = Style::Path});
}

struct ProjectBody {
    std::string name;
    std::string start;
    std::vector<SceneEntry> scenes;
    std::vector<std::string> templates;
    std::vector<Camera> cameras;
    std::vector<CameraPath> paths;
    std::vector<Control> controls;
    Extra extra;
    bool operator==(const ProjectBody&) const = default;
};

void fields(auto& v, Of<Control> auto& c)
{
    v("action", c.action, Hint{});
    v("by", c.by, Hint{});
}

void fields(auto& v, Of<ProjectBody> auto& p)
{
    v("name", p.name, Hint{});
    v("start", p.start, Hint{});
    v("scenes", p.scenes, Hint{});
    v("templates", p.templates, Hint{});
    v("cameras", p.cameras, Hint{});
    v("paths", p.paths, Hint{});
    v("controls", p.controls, Hint{.optional = true});
}

constexpr Hint kIdHint{.min = 1, .max = kHighestId};

// All of a scene's file but its objects, which come after it, one a line.
struct SceneBody {
    std::string environment;
    Terrain terrain;
    Grass grass;
    std::vector<ScatterLayer> scatter;
    Extra extra;
};

void fields(auto& v, Of<SceneBody> auto& s)
{
    v("environment", s.environment, Hint{.style = Style::Path});
    v("terrain", s.terrain, Hint{});
    v("grass", s.grass, Hint{.optional = true});
    v("scatter", s.scatter, Hint{.optional = true});
}

// An object as its line has it: led by its id.
struct ObjectLine : Object {};

void fields(auto& v, Of<ObjectLine> auto& line)
{
    using Plain = std::conditional_t<std::is_const_v<std::remove_reference_t<decltype(line)>>, const Object, Object>;
    v("id", line.id, kIdHint);
    fields(v, static_cast<Plain&>(line));
}

} // namespace io
