// Height maps of other programs: any file that holds heights to metres, with what it says of itself and what had to be guessed.
#pragma once

#include "io/base/complaint.h"
#include "io/base/result.h"
#include "io/files/raw_heights.h"
#include "io/scene/height_map.h"
#include "io/scene/scene.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace io {

// Where a number of an import comes from: a person, the file, a file beside it, its name, the ground that is there, what the
// values look like, or nothing better than what is usual.
enum class KnownFrom { Given, File, Sidecar, Name, Ground, Values, Usual };
constexpr auto enumNames(KnownFrom) { return std::array<std::string_view, 7>{"given", "file", "sidecar", "name", "ground", "values", "usual"}; }
std::string_view nameOf(KnownFrom from);

// What a file holds, before metres are made of it.
struct HeightSource {
    std::filesystem::path file;
    glm::ivec2 size{0};
    std::vector<float> values; // row by row from the north-west, voids filled
    float lowest = 0, highest = 0; // of them
    std::size_t voids = 0;     // that were
    bool metres = false;       // the values are metres; otherwise shares of 0..full
    float full = 65535;        // the largest value that an unsigned sample can have
    bool raw = false;          // bare samples: size, sample and byte order can be said otherwise
    HeightSample sample = HeightSample::U16;
    bool bigEndian = false;
    KnownFrom sizeFrom = KnownFrom::File;
    std::optional<double> metresPerTexel; // as the file, a file beside it or its name say
    KnownFrom metresFrom = KnownFrom::File;
    std::optional<glm::dvec2> heights; // m, of 0 and `full`, as a file beside it says
};

// PNG, JPEG, TIFF, GeoTIFF, EXR, HDR, DDS; .hgt; bare samples. 2 to 16385 texels a side. A picture whose channels differ is refused.
// Voids (io/files/void_filling.h, and what the file marks so) are filled and counted in a complaint; more than 19 of 20 are an
// error. `layout` is for bare samples; a size that an image does not have is an error.
Result<HeightSource> readHeightSource(const std::filesystem::path& file, const RawLayout& layout, Complaints& complaints);

// What a person says of it; the rest is taken from the file, then from the ground that is there, then guessed.
struct HeightMeasures {
    std::optional<double> metresPerTexel;
    std::optional<glm::dvec2> heights; // m, of the lowest and the highest value: 0 and 255 or 65535, or 0 and 1 of floats
};

// A ground to be, and what the terrain then says of it. It lies around the world's middle, or where one of the same size lies now.
struct ImportedGround {
    HeightGrid grid;
    bool shares = false; // as HeightMap::shares: a 16-bit file holds it exactly; otherwise floats do
    double minHeight = 0, maxHeight = 0;
    bool scaled = false;           // the values are not metres: these are the heights of 0 and of the highest one
    glm::dvec2 scaledFrom{0, 1};   // m
    KnownFrom metresFrom = KnownFrom::Usual, heightsFrom = KnownFrom::Usual;
};

// All but the heights themselves. An error, which names the file and what to do, for metres per texel or heights that make no ground.
Result<ImportedGround> planGround(const HeightSource& source, const HeightMeasures& measures, const Scene& scene, Complaints& complaints);
// With the heights.
Result<ImportedGround> groundFrom(const HeightSource& source, const HeightMeasures& measures, const Scene& scene, Complaints& complaints);

} // namespace io
