// The command line as a plain value: what `wold ARGS…` asks for. docs: --help and CONTRACT in docs/command-line.md.
#pragma once

#include "io/files/asset_import.h"
#include "io/files/height_import.h"
#include "io/scene/camera.h"
#include "renderer/settings.h"

#include <filesystem>
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace app {

enum class Command { Edit, Play, Render, Pick, Run, Bench, Check, New, Info, Import, Export };
enum class Quality { Auto, Low, Medium, High, Ultra };

struct FrameRange {
    int first = 0;
    int last = 0; // inclusive
};

// What `import` and `export` are told.
struct Exchange {
    std::vector<std::filesystem::path> files;
    std::optional<io::AssetKind> as;
    io::RawLayout layout;        // of height maps
    io::HeightMeasures measures; // likewise
    bool force = false;
    bool onlyTerrain = false;
    int step = 0; // of the mesh; 0: its own choice
};

struct Options {
    Command command = Command::Edit;
    std::filesystem::path project; // empty: none was named

    // Of every command that draws.
    std::string scene;          // empty: the start scene
    glm::ivec2 size{1280, 720}; // pixels
    bool sizeGiven = false;
    std::string look;                                      // one of Wold's or of the person's; empty: the scene's
    std::optional<float> time;                             // hours
    std::vector<std::pair<std::string, std::string>> sets; // KEY, VALUE
    std::optional<Quality> quality;
    std::string language;         // empty: as the person's settings say
    std::filesystem::path config; // empty: settings.json in the person's folder
    std::string json;             // file, "-" for stdout, empty for none
    bool headless = false;
    bool quiet = false;
    bool verbose = false; // --log was given: the log's own level stands

    std::optional<io::Camera> view;
    std::string camera; // name
    std::string path;   // name
    std::filesystem::path out;
    renderer::Show show = renderer::Show::Final;
    std::optional<io::Camera> cullFrom; // render
    std::optional<FrameRange> range; // render
    int count = 0;                   // render: pictures spread over the path; 0: not asked for
    int frames = 0;                  // bench, play; 0: its own choice
    int warmup = 10;                 // bench
    std::filesystem::path points;    // pick
    std::string script;              // run; "-" reads stdin
    bool fix = false;                // check
    std::filesystem::path folder;    // new
    std::string starter = "empty";   // new
    Exchange exchange;               // import, export

    std::filesystem::path replay;             // edit
    std::filesystem::path record;             // edit
    std::filesystem::path input;              // play
    std::filesystem::path trace;              // play
    std::filesystem::path uiMap;              // edit
    std::vector<std::filesystem::path> shots; // edit
};

// The program ends at once: with 0 and text for stdout (--help), or with 2 and text for stderr.
struct Ending {
    int code = 0;
    std::string text;
};

std::variant<Options, Ending> parseOptions(std::vector<std::string> arguments); // without the program's name

std::string_view nameOf(Command command);
std::optional<Quality> qualityNamed(std::string_view name);
std::string_view nameOf(Quality quality);

} // namespace app
