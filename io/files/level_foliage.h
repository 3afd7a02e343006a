// Coarser crowns: parts made of many small cards lose some of them, and the rest grow to fill the gaps.
#pragma once

#include "io/files/level_parts.h"
#include "io/scene/bounds.h"

namespace io::levels {

class Foliage {
public:
    // Takes those parts of the model that are made of cards; `places` as of placesOf.
    Foliage(const Model& model, std::span<const std::uint32_t> places);
    bool holds(std::uint32_t part) const;
    std::size_t triangles() const { return m_full; }
    const Box& crown() const { return m_crown; } // empty when there is none

    // About `share` of the triangles. Grown cards get vertices of their own at the end of model.vertices.
    // Cards kept for a share are also kept for every larger one.
    Piece thinned(Model& model, float share) const;

private:
    struct Card {
        std::vector<Corners> full;
        std::vector<Corners> simple; // bends straightened
        glm::vec3 centre{0};     // of its box
        float area = 0;          // m²
        float radius = 0;        // m, to its farthest corner
        std::uint32_t rank = 0;  // low ones stay longest
    };
    void takePart(const Model& model, std::uint32_t part, std::span<const std::uint32_t> places);
    void rankCards();
    void spreadCards();
    void sortCards();
    void simplifyCards(const Model& model);
    void grow(Model& model, const Card& card, std::span<const Corners> triangles, float grown, Piece& piece) const;

    std::vector<std::uint32_t> m_parts;
    std::size_t m_full = 0;   // triangles
    std::size_t m_simple = 0;
    float m_simpleError = 0;  // m
    std::vector<Card> m_cards;
    Box m_crown;
    float m_area = 0;      // m², of all cards
    float m_cardRadius = 0; // m, mean by area
};

} // namespace io::levels
