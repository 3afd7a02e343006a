#include "io/files/height_export.h"

#include "io/files/atomic_file.h"
#include "io/files/file_names.h"
#include "io/files/height_map_file.h"
#include "io/files/raw_heights.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace io {
namespace fs = std::filesystem;
namespace {

template <class T> std::string bytesOf(const std::vector<T>& values)
{
    return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T)};
}

} // namespace

bool exportsHeights(const fs::path& file)
{
    constexpr std::string_view kKnown[] = {".png", ".exr", ".tif", ".tiff", ".r16", ".r32"};
    return std::ranges::count(kKnown, lowerExtension(file)) > 0;
}

bool exportsMesh(const fs::path& file)
{
    const std::string extension = lowerExtension(file);
    return extension == ".glb" || extension == ".gltf";
}

Result<HeightExport> exportHeights(const fs::path& file, const HeightMap& heights, const Terrain& terrain)
{
    if (!exportsHeights(file)) return Error{file.string(), "heights are written as .png, .exr, .tif, .r16 or .r32"};
    const std::string extension = lowerExtension(file);
    const bool raw = extension == ".r16" || extension == ".r32";
    Terrain to = terrain;
    to.heightMap = file.filename().string();
    if (!heights.shares) {
        to.minHeight = std::floor(heights.min);
        to.maxHeight = std::max(std::ceil(double(heights.max)), to.minHeight + 1);
    }
    makeRoom(heights, to);
    HeightExport done{.metres = extension != ".png" && extension != ".r16", .minHeight = to.minHeight, .maxHeight = to.maxHeight};
    const HeightGrid grid = heights.read(heights.texels());
    const Result<std::string> bytes = !raw          ? encodeHeightMap(heights, to)
                                      : done.metres ? Result<std::string>{bytesOf(grid.metres)}
                                                    : Result<std::string>{bytesOf(samples16(grid, to.minHeight, to.maxHeight))};
    if (!bytes) return Error{file.string(), bytes.error().what};
    if (const Status written = writeFile(file, *bytes); !written) return written.error();
    done.written.push_back(file);
    if (!raw) return done;
    fs::path header = file; // with the file's whole name, as .r16 and .r32 of one name differ
    header += ".hdr";
    const auto range = done.metres ? std::nullopt : std::optional{glm::dvec2{to.minHeight, to.maxHeight}};
    const std::string text = rawHeaderText(grid.size, done.metres ? HeightSample::F32 : HeightSample::U16, heights.metresPerTexel, heights.origin, range);
    if (const Status written = writeFile(header, text); !written) return written.error();
    done.written.push_back(header);
    return done;
}

} // namespace io
