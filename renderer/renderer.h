// The renderer: a mirror of a scene on the GPU, and the frame that draws it. Needs a current OpenGL 4.5 core
// context on the calling thread for its whole life; shows no GL type.
#pragma once

#include "io/base/kept_bytes.h"
#include "io/base/result.h"
#include "io/scene/assets.h"
#include "io/scene/camera.h"
#include "io/scene/changes.h"
#include "io/scene/moved.h"
#include "io/scene/scene.h"
#include "renderer/settings.h"

#include <array>
#include <cstdint>
#include <filesystem>
#include <glm/glm.hpp>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace renderer {

// Lines that the editor draws into the world: boxes of markers and groups, the grid, footprints, paths.
struct Line {
    glm::dvec3 from{0}, to{0}; // m, world
    glm::vec4 colour{1};       // sRGB
    bool onTop = false;        // not hidden by the world
};

// A copy of a template that is not (yet) in the scene: the ghost that follows the cursor while placing.
struct Ghost {
    io::TemplateId templateId = io::TemplateId::None;
    io::Transform transform;
};

// Something that presses grass aside where it stands: a player, a wheel.
struct Presser {
    glm::dvec3 position{0}; // m, of its foot
    float radius = 0.5f;    // m
    float strength = 1;     // 1 lays grass flat, 0 not at all; below 0 it swings back over
};
constexpr std::size_t kMostPressers = 16; // more are left out

struct FrameInput {
    io::Camera camera;
    glm::ivec2 size{1280, 720}; // pixels, each at least 1
    Settings settings;
    Show show = Show::Final;
    double time = 0;            // s, moves clouds
    std::optional<io::Environment> environment; // in place of the scene's
    std::span<const io::ObjectId> selection; // tinted violet and outlined
    std::span<const Ghost> ghosts;
    std::span<const Line> lines;
    std::span<const Presser> pressers;
    bool markers = true;        // draw the boxes of templates without a model
    bool ids = true;            // keep whose each pixel is, for readIds; surfaces are drawn a little faster without
    bool alone = false;         // a picture of its own: nothing that was gathered or adapted to before counts
    // What the first frame with this culled stays culled while the camera flies on; its view is drawn as lines.
    bool freezeCulling = false;
};

struct PassTime {
    std::string name;
    double cpuMs = 0;
    double gpuMs = 0; // of a frame a little earlier, so that reading it never waits
};

struct GpuMemory { // bytes
    std::uint64_t textures = 0, buffers = 0, shadowMaps = 0;
    std::uint64_t targets = 0; // what passes draw into
};

// Of instances each test of culling hands on fewer: inside, large, of those not hidden. Where the GPU culls, what it
// counted is of a frame a little earlier.
struct FrameStats {
    std::vector<PassTime> passes;
    std::uint64_t drawCalls = 0;           // commands of multi-draws counted one by one
    std::uint64_t trianglesSubmitted = 0;  // all passes
    std::uint64_t trianglesDrawn = 0;      // those of the camera's view
    std::uint64_t instances = 0;           // in the scene
    std::uint64_t instancesDrawn = 0;      // in the camera's view
    std::uint64_t instancesInside = 0;     // in the camera's view, however small or hidden
    std::uint64_t instancesLarge = 0;      // of those, large enough to be seen
    std::uint64_t instancesHidden = 0;     // of those, behind other things
    bool occlusionTested = false;          // else none are known to be hidden
    bool cullingFrozen = false;
    bool gathering = false;                // the next frame of the same view would be smoother: --set render.aa=taa
    std::uint64_t grassDrawn = 0;          // blades and plants, of a frame a little earlier
    std::uint64_t grassLeftOut = 0;        // beyond the most that may be drawn
    std::array<std::uint64_t, 8> trianglesOfLevel{}; // of objects by level of detail
    std::uint64_t uploadedBytes = 0;       // what the frame handed to the GPU: records, commands, constants
    std::uint64_t gpuBytes = 0;            // buffers and textures of ours
    GpuMemory gpuMemory;                   // the same by kind
};

struct ShaderFault {
    std::string where; // file:line
    std::string what;
};

// A texture to show in a panel: the GL name as ImGui's OpenGL backend takes it, bottom row first.
struct Picture {
    std::uintptr_t texture = 0;
    glm::ivec2 size{0};
};

class Renderer {
public:
    struct Options {
        std::filesystem::path shaders; // the folder renderer/shaders
        bool debug = false;            // synchronous GL debug output
        std::shared_ptr<io::KeptBytes> kept; // pictures of impostors from other runs; null: made anew
    };
    static io::Result<std::unique_ptr<Renderer>> create(Options options);
    ~Renderer();
    Renderer(const Renderer&) = delete;
    Renderer& operator=(const Renderer&) = delete;

    // Brings the mirror up to date; costs what `changes` names.
    void update(const io::Scene& scene, const io::Assets& assets, const io::Changes& changes);

    // Draws things elsewhere than the scene has them, as between two steps of a simulation, until an update names them.
    void move(std::span<const io::Moved> things);

    // Draws one frame. The picture stays valid until the next call.
    Picture render(const FrameInput& input);

    // What the last frame holds, read back (waits for the GPU). Top row first.
    io::Image readPicture();  // RGBA8, as shown
    io::Image readRadiance(); // RGB F32, scene-linear before exposure and tone mapping; of Show::Final
    std::vector<std::uint32_t> readIds(glm::ivec2 topLeft, glm::ivec2 size); // of objects and instances (io/scene/ids.h), 0 none, kTerrainId ground; of a frame that kept them

    double readExposure(); // EV that the last frame was shown with, chosen by hand or by itself

    // A small picture of a model on a plain ground in studio light; kept until the template changes.
    Picture thumbnail(io::TemplateId id, int pixels);

    const FrameStats& stats() const;
    std::span<const ShaderFault> shaderFaults() const; // of the last reload; empty when all is well
    void reloadShaders();                              // also happens by itself when a shader's file changes
    std::string deviceName() const;                    // GL_RENDERER and GL_VERSION
    std::uint64_t glErrors() const;                    // messages of type error since the start; tests expect 0

private:
    struct State;
    explicit Renderer(std::unique_ptr<State> state);
    std::unique_ptr<State> m_state;
};

constexpr std::uint32_t kTerrainId = 0xffffffffu; // beyond io::kLastInstanceId

// Matrices as the frame uses them: camera-relative, reversed depth in [0, 1], infinite far plane.
glm::dmat4 viewFromRelative(const io::Camera& camera);           // rotation only; relative = world - eye
glm::dmat4 clipFromView(const io::Camera& camera, double aspect); // near plane kNear
constexpr double kNear = 0.1; // m

io::Ray rayThrough(const io::Camera& camera, glm::ivec2 size, glm::dvec2 pixel); // pixel from the top left, centre at .5
std::optional<glm::dvec2> project(const io::Camera& camera, glm::ivec2 size, const glm::dvec3& world); // to a pixel

} // namespace renderer
