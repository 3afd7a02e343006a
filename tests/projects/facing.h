// Which way the faces of a made mesh look: its pieces of solid surface, each with what tells outside from inside.
#pragma once

#include "projects/make/mesh.h"

#include <vector>

namespace tests {

// Triangles that hang together by their corners' places. Leaves and cloth have no inside and are left out.
struct Piece {
    double area = 0;        // m2
    double opening = 0;     // length of the summed area vectors as a share of the area: 0 closed … 1 a flat sheet
    double volume = 0;      // m3 about its own middle; negative when it is inside out
    double agreeing = 0;    // share of the area whose face normals look where their vertices' normals look
    double turnedOver = 0;  // share of the area whose front looks into the piece
    double turnedEdges = 0; // share of the edges between two triangles at which one of them is the wrong way round
};
std::vector<Piece> piecesOf(const make::Mesh& mesh);

} // namespace tests
