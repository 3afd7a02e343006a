// Coarser solids: all parts but foliage, simplified together so that no crack opens between them.
#pragma once

#include "io/files/level_foliage.h"

#include <optional>

namespace io::levels {

class Solid {
public:
    // Takes the parts that the foliage does not; `places` as of placesOf. In the crown, errors hide among the leaves.
    Solid(const Model& model, std::span<const std::uint32_t> places, const Foliage& foliage);
    std::size_t triangles() const { return m_full.size(); }

    // About `share` of the triangles, whatever error that takes; pieces thinner than `freeError` go in any case.
    // Corners whose normals had to be merged get vertices of their own at the end of model.vertices.
    Piece simplified(Model& model, float share, float freeError);

private:
    // What is simplified: vertices that are equal, and of one part, are one.
    struct Mesh {
        std::vector<std::uint32_t> indices;
        std::vector<glm::vec3> positions;
        std::vector<std::uint32_t> vertexOf; // of the model
        std::vector<std::uint32_t> partOf;
    };
    enum class Weld { Equal, Normals, Positions }; // what may differ where corners become one
    Mesh welded(const Model& model, Weld weld) const;
    Piece leastError(Model& model, const Mesh& mesh, std::size_t wanted, float freeError, bool mergedNormals);
    Piece reduced(Model& model, const Mesh& mesh, std::size_t triangles, float droppedTo, bool mergedNormals);
    float thicknessAt(std::uint32_t vertex) const { return m_thickness[m_places[vertex]]; }
    std::uint32_t withMeanNormal(Model& model, const Mesh& mesh, std::uint32_t index);
    Piece sloppy(const Model& model, const Mesh& mesh, float share) const;
    void dropThin(const Model& model, Piece& piece, float thickness, std::size_t triangles) const;
    float measured(const Model& model, const Piece& piece, float droppedBelow) const;

    std::vector<Corners> m_full;
    std::vector<float> m_thickness;              // m, of the component, by place
    std::vector<float> m_sorted;                 // m, of the component of each full triangle
    std::vector<std::uint32_t> m_places;
    std::vector<glm::vec3> m_samples;            // of the full surface
    std::vector<float> m_sampleThickness;        // m, of the components they lie on
    std::optional<SurfaceDistance> m_surface;
    Mesh m_equal;
    std::optional<Mesh> m_normals;
    std::vector<glm::vec3> m_meanNormals;        // by vertex of m_normals
    std::vector<std::uint32_t> m_meanVertices;   // of the model, by vertex of m_normals; kNone: not made yet
    Box m_crown;
    float m_size = 0;                            // m, largest extent
};

} // namespace io::levels
