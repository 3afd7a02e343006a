// Height maps: PNG, TIFF or EXR to metres, with the gaps of measured data closed.
#pragma once

#include "io/base/complaint.h"
#include "io/base/progress.h"
#include "io/base/result.h"
#include "io/scene/height_map.h"
#include "io/scene/terrain.h"

#include <cstdint>
#include <filesystem>
#include <vector>

namespace io {

// 8 and 16 bits unsigned map 0..max to the terrain's minHeight..maxHeight; float and signed integers are metres.
// Voids (NaN, infinity, -32768, -32767, -9999, anything beyond 100 km) are filled from their neighbours and counted in
// a complaint. At least 2 x 2, at most kGroundLimits.side along a side. Read in bands of at most 512 rows, between which it
// reports and can be cancelled; besides the map itself it takes a few MB.
Result<HeightMap> readHeightMap(const std::filesystem::path& file, const Terrain& terrain, Complaints& complaints,
                                const Progress& progress = {});

// A 16-bit PNG that readHeightMap() reads back with the same two heights; what lies outside them is clamped.
Status writeHeightMap16(const std::filesystem::path& file, const HeightGrid& heights, double minHeight,
                        double maxHeight);

bool holdsHeights(const std::filesystem::path& file); // by its name: a format that heights can be written to

// Moves the terrain's two heights apart, to whole metres, where the ground lies beyond them; puts them right where they are upside down.
void makeRoom(const HeightMap& heights, Terrain& terrain);
std::vector<std::uint16_t> samples16(const HeightGrid& heights, double minHeight, double maxHeight); // what lies outside is clamped

// What terrain.heightMap is to hold: a PNG of 16 bits between the terrain's two heights, which are moved apart where the
// ground lies beyond them; EXR or TIFF in metres, float.
Result<std::string> encodeHeightMap(const HeightMap& heights, Terrain& terrain);

} // namespace io
