// What a GeoTIFF says of where its pixels lie. OpenImageIO passes those tags over, so they are looked up in the bytes.
#pragma once

#include <optional>
#include <string_view>

namespace io {

struct GeoTiff {
    std::optional<double> metresPerTexel; // of its ModelPixelScale, in metres, feet or degrees
    double stretch = 1;                   // how much longer the pixel is from north to south than from west to east
    std::optional<double> nodata;         // GDAL's mark of a void
};

// Nothing where the bytes are no TIFF, a BigTIFF, damaged, or say nothing of the kind.
GeoTiff geoTiffOf(std::string_view bytes);

// Metres of a degree of latitude (x: from north to south) and of longitude (y) at a latitude in degrees, on WGS 84.
struct DegreeMetres {
    double north, east;
};
DegreeMetres metresOfDegree(double latitude);

} // namespace io
