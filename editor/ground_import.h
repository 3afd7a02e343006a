// Another ground in place of the one that is there: what would differ, and the one step that does it.
#pragma once

#include "editor/document.h"
#include "io/base/value.h"
#include "io/files/height_import.h"

#include <array>
#include <filesystem>
#include <string>
#include <vector>

namespace editor {

enum class GroundPart { Size, MetresPerTexel, Heights, Cover };
constexpr auto enumNames(GroundPart) { return std::array<std::string_view, 4>{"size", "metres_per_texel", "heights", "cover"}; }

// What of the ground would not be what it was: texels, m, or for Cover what becomes of it: "stretched" or "dropped".
struct GroundDifference {
    GroundPart part;
    std::string now, then;
};
// Empty where there is no ground, or the new one fits in its place: same size and metres per texel, heights within the same two.
std::vector<GroundDifference> groundDifferences(const io::Scene& scene, const io::ImportedGround& ground);

// One step: heights, what the terrain says of them, and what was painted: kept on a ground of the same size, stretched over one of the
// same proportions, dropped on another. Save writes them into terrain/, under the name of `file` where that is free.
void importGround(Document& document, const std::string& name, const io::ImportedGround& ground, const std::filesystem::path& file);

// All of an import, as commands ask for it. A ground that differs is an error, which says in what, unless `force`; nothing is
// changed then.
struct HeightRequest {
    std::filesystem::path file;
    io::RawLayout layout;
    io::HeightMeasures measures;
    bool force = false;
};
struct HeightImportReport {
    io::ImportedGround ground; // without its heights
    glm::ivec2 size{0};
    std::size_t voids = 0;
    std::string heightMap;                      // in the project
    std::vector<GroundDifference> differences; // that were overruled
    io::Complaints complaints;
};
io::Result<HeightImportReport> importHeights(Document& document, const std::string& name, const HeightRequest& request);

std::string inWords(const std::vector<GroundDifference>& differences); // English
io::Value::Object membersOf(const HeightImportReport& report);         // for answers and figures

// The ground to a file, by its name: heights or a mesh, of which every `step`-th texel is a vertex (0: as many as are usual). Answers
// what was written.
io::Result<io::Value> exportGround(const io::Scene& scene, const std::filesystem::path& file, int step);

} // namespace editor
