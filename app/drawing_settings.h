// Keys of --set, and what --quality means: the settings of drawing by name.
#pragma once

#include "app/options.h"
#include "io/base/result.h"
#include "io/base/value.h"
#include "io/scene/environment.h"
#include "renderer/device_speed.h"
#include "renderer/settings.h"

#include <string_view>

namespace app {

// `key` is what follows "render.". Settings of features that are still to come take only the value that says what
// happens now (ao off, terrain grid); any other is an error that says so.
io::Status setDrawing(renderer::Settings& settings, std::string_view key, const io::Value& value);
io::Result<io::Value> getDrawing(const renderer::Settings& settings, std::string_view key);

bool drawsInSoftware(std::string_view device); // its name: llvmpipe and its like

// The highest tier whose needs are all met.
Quality qualityFor(const renderer::DeviceSpeed& speed);

// Auto picks by the device's name, so that pictures are the same each time; windows measure first.
// docs/command-line.md holds the table. Answers the tier that was taken.
Quality applyQuality(Quality quality, std::string_view device, renderer::Settings& settings);

} // namespace app
