// Whether a ray that meets a triangle of a model sees it there, as the renderer's alpha test decides.
#pragma once

#include "io/scene/model.h"

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <memory>
#include <vector>

namespace editor {

// The alpha of an image at ever half the size, scaled so that as large a share of each passes the cutoff as of the
// first: what keeps leaves far away from thinning out, in the picture and so under the cursor. Made when first needed.
class AlphaMips {
public:
    AlphaMips(std::shared_ptr<const io::Image> image, float cutoff) : m_image{std::move(image)}, m_cutoff{cutoff} {}

    // Trilinear. `lod` 0 is the image itself, 1 half of it.
    float sample(const io::TextureUse& use, glm::vec2 uv, float lod);
    glm::ivec2 size() const { return m_image->size; }

private:
    struct Level {
        glm::ivec2 size{0};
        std::vector<std::uint8_t> alpha;
    };
    void make();

    std::shared_ptr<const io::Image> m_image;
    float m_cutoff;
    std::vector<Level> m_levels; // from half the size down
};

// What the alpha test needs to know of a triangle's part.
struct PartOfModel {
    const io::Model* model = nullptr;
    const io::Material* material = nullptr;
    std::uint32_t firstIndex = 0;
    AlphaMips* mips = nullptr; // of its base colour's image; null: there is none, or its alpha does not count
};

// How the triangle's barycentric coordinates (of its second and third corner) change from a pixel to the next.
using PixelSteps = std::array<glm::vec2, 2>;

// `triangle` counts from the part's first; `at` is where it was met.
bool seenAt(const PartOfModel& part, std::size_t triangle, glm::vec2 at, const PixelSteps& steps = {});

// Of a ray that met the triangle with these edges (world), for pixels that are `metres` wide there.
PixelSteps pixelSteps(const glm::vec3& edge1, const glm::vec3& edge2, const glm::vec3& direction, float metres);

} // namespace editor
