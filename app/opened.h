// A project opened as the command line asks for it: its document, with --time and --set applied, and how to draw it.
#pragma once

#include "app/options.h"
#include "editor/document.h"
#include "io/base/value.h"
#include "renderer/settings.h"

#include <memory>
#include <variant>

namespace app {

struct Opened {
    std::unique_ptr<editor::Document> document;
    renderer::Settings drawing; // without --quality, which may need to know the device
    double milliseconds = 0;    // that reading took
};

// The exit code when it fails, after saying why.
std::variant<Opened, int> openAsAsked(const Options& options);

// --time and every --set environment.*, as steps that can be undone; 0, or the exit code after saying why.
int applyToWorld(const Options& options, editor::Document& document);
int applyToDrawing(const Options& options, renderer::Settings& drawing); // every --set render.*

// Where the options put the camera: --view, --camera, else the scene's first camera, else above its middle.
io::Result<io::Camera> cameraFor(const Options& options, const editor::Document& document);
// --path, else the scene's first path.
io::Result<io::CameraPath> pathFor(const Options& options, const editor::Document& document);

} // namespace app
