#include "coverage.h"
#include "support.h"

#include "io/files/card_trimming.h"
#include "io/files/cutout_outline.h"
#include "io/files/levels.h"
#include "io/files/model_file.h"
#include "io/files/surface_distance.h"

#include <cstring>
#include <limits>
#include <random>

namespace io {
namespace {

// Opaque where `inside` says so; texels are counted from their middles, 0 to 1.
std::shared_ptr<Image> picture(int side, auto&& inside)
{
    auto image = std::make_shared<Image>(Image{.size = glm::ivec2{side}, .channels = 4});
    image->bytes.resize(std::size_t(side * side * 4), std::byte{255});
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x)
            if (!inside((glm::vec2(x, y) + 0.5f) / float(side))) image->row<std::uint8_t>(y)[x * 4 + 3] = 0;
    return image;
}

std::shared_ptr<Image> diamond()
{
    return picture(128, [](const glm::vec2& p) { return std::abs(p.x - 0.5f) + std::abs(p.y - 0.5f) < 0.42f; });
}

bool holds(const Polygon& polygon, const glm::vec2& p)
{
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const glm::vec2 a = polygon[i], along = polygon[(i + 1) % polygon.size()] - a;
        if (along.x * (p.y - a.y) - along.y * (p.x - a.x) < -1e-5f) return false;
    }
    return polygon.size() > 2;
}

// A square card in the plane z = 0 as two triangles, from `min` to `max` of the texture.
Model quad(std::shared_ptr<const Image> image, const glm::vec2& min = {0, 0}, const glm::vec2& max = {1, 1})
{
    Model model;
    for (const glm::vec2 corner : {glm::vec2{0, 1}, {1, 1}, {1, 0}, {0, 0}})
        model.vertices.push_back({.position = {corner.x * 2, 2 - corner.y * 2, 0},
                                  .normal = {0, 0, 1},
                                  .uv0 = min + (max - min) * corner});
    model.indices = {0, 1, 2, 0, 2, 3};
    model.parts = {{0, 6, 0}};
    model.materials = {{.alphaMode = AlphaMode::Mask, .doubleSided = true, .baseColourTexture = {.image = 0}}};
    model.images = {std::move(image)};
    for (const Vertex& vertex : model.vertices)
        model.bounds.add(vertex.position);
    return model;
}

float area(const Model& model, std::span<const std::uint32_t> indices)
{
    float sum = 0;
    for (std::size_t i = 0; i + 2 < indices.size(); i += 3) {
        const glm::vec3 a = model.vertices[indices[i]].position;
        sum += glm::length(glm::cross(model.vertices[indices[i + 1]].position - a, model.vertices[indices[i + 2]].position - a)) / 2;
    }
    return sum;
}

float maskedArea(const Model& model, std::span<const std::uint32_t> indices, std::span<const Part> parts)
{
    float sum = 0;
    for (const Part& part : parts)
        if (model.materials[std::size_t(part.material)].alphaMode == AlphaMode::Mask)
            sum += area(model, indices.subspan(part.firstIndex, part.indexCount));
    return sum;
}

TEST(CutoutOutline, holdsAllThatIsOpaqueAndLittleElse)
{
    std::mt19937 random{7};
    std::uniform_real_distribution<float> unit{0, 1};
    for (int i = 0; i < 60; ++i) {
        std::vector<glm::vec3> discs; // and their radii
        for (int disc = 0; disc < 1 + i % 5; ++disc)
            discs.push_back({unit(random), unit(random), 0.02f + unit(random) * 0.2f});
        const auto inside = [&](const glm::vec2& p) {
            return std::ranges::any_of(discs, [&](const glm::vec3& d) { return glm::length(p - glm::vec2(d)) < d.z; });
        };
        const auto image = picture(96, inside);
        const OutlineRequest request{.margin = 0.01f, .corner = 0.02f};
        const Polygon outline = cutoutOutline(*image, request);
        for (int y = 0; y < 96; ++y)
            for (int x = 0; x < 96; ++x) {
                const glm::vec2 middle = (glm::vec2(x, y) + 0.5f) / 96.0f;
                EXPECT_TRUE(!inside(middle) || holds(outline, middle)) << i << ": " << x << ", " << y;
            }
        for (const glm::vec2& corner : outline)
            EXPECT_TRUE(glm::all(glm::greaterThan(corner, glm::vec2{-1e-4f})) && glm::all(glm::lessThan(corner, glm::vec2{1.0001f})));
        EXPECT_GT(areaOf(outline), 0) << "the inside lies to the left";
        EXPECT_LE(outline.size(), 10u);
        const float exact = areaOf(cutoutOutline(*image, {.margin = 0.01f, .corner = 0}));
        EXPECT_LE(areaOf(outline), exact + 0.02f * 8) << "a corner is left out for what it saves";
    }
}

TEST(CutoutOutline, findsTheFewestCornersThatDo)
{
    const Polygon four = cutoutOutline(*diamond(), {.corner = 0.05f});
    EXPECT_EQ(four.size(), 4u);
    EXPECT_NEAR(areaOf(four), 2 * 0.42f * 0.42f, 0.03f);

    const auto bar = picture(64, [](const glm::vec2& p) { return p.x > 0.25f && p.x < 0.5f && p.y > 0.125f; });
    const Polygon rectangle = cutoutOutline(*bar, {.corner = 0.05f});
    EXPECT_EQ(rectangle.size(), 4u);
    EXPECT_NEAR(areaOf(rectangle), 0.25f * 0.875f, 1e-4f);
    const Polygon part = cutoutOutline(*bar, {.min = {0.25f, 0}, .max = {0.375f, 0.5f}, .corner = 0.05f});
    EXPECT_NEAR(areaOf(part), 0.125f * 0.375f, 1e-4f);
    EXPECT_TRUE(cutoutOutline(*bar, {.min = {0.5f, 0}, .max = {1, 1}}).empty());
}

TEST(CardTrimming, treesLookTheSameWithLessArea)
{
    const fs::path folder = fs::path{WOLD_SOURCE_DIR} / "projects/valley";
    for (const char* name : {"oak", "beech_young", "birch_old", "fir", "bush", "fern"}) {
        Complaints complaints;
        Result<Model> whole = readModel(folder / "models" / (std::string{name} + ".glb"), folder, complaints);
        ASSERT_TRUE(whole) << name;
        makeLevels(*whole);
        Model trimmed = *whole;
        trimCards(trimmed);
        for (std::size_t level = 0; level <= whole->levels.size(); ++level) {
            const auto shown = [&](const Model& model) {
                const auto& indices = level == 0 ? model.indices : model.levels[level - 1].indices;
                const auto& parts = level == 0 ? model.parts : model.levels[level - 1].parts;
                for (const std::uint32_t index : indices)
                    EXPECT_LT(index, model.vertices.size());
                return std::pair{coverage(model, indices, parts, 256), maskedArea(model, indices, parts)};
            };
            const auto before = shown(*whole), after = shown(trimmed);
            for (std::size_t side = 0; side < 6; ++side)
                EXPECT_NEAR(float(after.first[side]), float(before.first[side]), (level == 0 ? 0.02f : 0.035f) * float(before.first[side]) + 3)
                    << name << " level " << level << " side " << side;
            EXPECT_LT(after.second, before.second * 0.8f) << name << " level " << level;
        }
        EXPECT_EQ(trimmed.bounds.min, whole->bounds.min);
    }
}

TEST(CardTrimming, cutsStayOnTheSurfaceAndTheTexture)
{
    Model model = quad(diamond()); // folded along its middle, as fir twigs are: six corners, four triangles
    model.vertices.clear();
    for (const float v : {0.0f, 1.0f})
        for (const float u : {0.0f, 0.5f, 1.0f})
            model.vertices.push_back({.position = {u * 2, v * 2, u == 0.5f ? 0.4f : 0},
                                      .normal = glm::normalize(glm::vec3{u - 0.5f, 0, 1}),
                                      .uv0 = {u, v},
                                      .colour = glm::u8vec4{std::uint8_t(u * 200), 0, 0, 255}});
    model.indices = {0, 1, 4, 0, 4, 3, 1, 2, 5, 1, 5, 4};
    model.parts[0].indexCount = 12;
    std::vector<SurfaceDistance::Triangle> full;
    for (std::size_t i = 0; i < model.indices.size(); i += 3)
        full.push_back({model.vertices[model.indices[i]].position, model.vertices[model.indices[i + 1]].position,
                        model.vertices[model.indices[i + 2]].position});
    const SurfaceDistance surface{full};
    const float before = area(model, model.indices);
    trimCards(model);
    EXPECT_LT(area(model, model.indices), before * 0.6f);
    for (std::size_t i = 0; i < model.indices.size(); i += 3) {
        Vertex middle;
        glm::vec3 red{0};
        for (std::size_t c = 0; c < 3; ++c) {
            const Vertex& corner = model.vertices[model.indices[i + c]];
            EXPECT_LT(surface.to(corner.position), 1e-5f);
            EXPECT_NEAR(corner.position.x, corner.uv0.x * 2, 1e-5f);
            EXPECT_NEAR(corner.position.y, corner.uv0.y * 2, 1e-5f);
            EXPECT_NEAR(float(corner.colour.r), corner.uv0.x * 200, 1.0f);
            EXPECT_NEAR(glm::length(corner.normal), 1, 1e-5f);
            middle.position += corner.position / 3.0f;
        }
        EXPECT_LT(surface.to(middle.position), 1e-5f) << "the fold is a fold still";
        const glm::vec3 a = model.vertices[model.indices[i]].position;
        EXPECT_GT(glm::cross(model.vertices[model.indices[i + 1]].position - a, model.vertices[model.indices[i + 2]].position - a).z, 0)
            << "fronts stay in front";
    }
}

TEST(CardTrimming, followsTheTextureWhereverItLies)
{
    Model plain = quad(diamond());
    trimCards(plain);
    const float wanted = area(plain, plain.indices);
    EXPECT_LT(wanted, 4 * 0.5f);

    Model repeated = quad(diamond(), {3, -2}, {4, -1});
    trimCards(repeated);
    EXPECT_NEAR(area(repeated, repeated.indices), wanted, 1e-3f) << "another repetition";
    Model mirrored = quad(diamond(), {1, 0}, {0, 1});
    trimCards(mirrored);
    EXPECT_NEAR(area(mirrored, mirrored.indices), wanted, 1e-3f);
    const glm::vec3 a = mirrored.vertices[mirrored.indices[0]].position;
    EXPECT_GT(glm::cross(mirrored.vertices[mirrored.indices[1]].position - a, mirrored.vertices[mirrored.indices[2]].position - a).z, 0);

    Model moved = quad(diamond(), {0, 0}, {2, 2}); // KHR_texture_transform brings it back, turned by a quarter
    moved.materials[0].baseColourTexture.scale = {0.5f, 0.5f};
    moved.materials[0].baseColourTexture.rotation = 1.5707963f;
    moved.materials[0].baseColourTexture.offset = {0, 1};
    trimCards(moved);
    EXPECT_NEAR(area(moved, moved.indices), wanted, 1e-3f);

    Model both = quad(diamond()); // the other side as triangles of their own
    for (const std::uint32_t index : {0u, 2u, 1u, 0u, 3u, 2u})
        both.indices.push_back(index);
    both.parts[0].indexCount = 12;
    trimCards(both);
    EXPECT_NEAR(area(both, both.indices), wanted * 2, 0.05f);
}

TEST(CardTrimming, leavesAloneWhatItCannotTell)
{
    const auto untouched = [](Model model) {
        const std::vector<std::uint32_t> before = model.indices;
        const std::vector<Vertex> vertices = model.vertices;
        trimCards(model);
        return model.indices == before && model.vertices.size() == vertices.size() &&
               std::memcmp(model.vertices.data(), vertices.data(), vertices.size() * sizeof(Vertex)) == 0;
    };
    EXPECT_FALSE(untouched(quad(diamond())));
    EXPECT_TRUE(untouched(quad(diamond(), {0, 0}, {2, 2}))) << "repeats";
    EXPECT_TRUE(untouched(quad(diamond(), {0, 0}, {0, 0}))) << "one texel";
    EXPECT_TRUE(untouched(quad(nullptr))) << "no picture";
    EXPECT_TRUE(untouched(quad(picture(16, [](const glm::vec2&) { return false; })))) << "all of it would go";
    EXPECT_TRUE(untouched(quad(picture(16, [](const glm::vec2&) { return true; })))) << "nothing to gain";

    Model model = quad(diamond());
    model.materials[0].alphaMode = AlphaMode::Opaque;
    EXPECT_TRUE(untouched(model));
    model.materials[0].alphaMode = AlphaMode::Blend;
    EXPECT_TRUE(untouched(model));
    model = quad(diamond(), {1, 0}, {2, 1});
    model.materials[0].baseColourTexture.wrapU = Wrap::Mirror;
    EXPECT_TRUE(untouched(model));
    model = quad(diamond());
    model.vertices[1].position.x = std::numeric_limits<float>::quiet_NaN();
    EXPECT_TRUE(untouched(model));
    model.vertices[1].position.x = 1;
    model.vertices[2].uv0.x = std::numeric_limits<float>::infinity();
    EXPECT_TRUE(untouched(model));
}

TEST(CardTrimming, aCardThatShowsNothingGoes)
{
    const auto half = picture(32, [](const glm::vec2& p) { return p.x < 0.4f; });
    Model model = quad(half), second = quad(half, {0.5f, 0}, {1, 1});
    for (const Vertex& vertex : second.vertices)
        model.vertices.push_back(vertex);
    for (const std::uint32_t index : second.indices)
        model.indices.push_back(index + 4);
    model.parts[0].indexCount = 12;
    trimCards(model);
    ASSERT_EQ(model.parts.size(), 1u);
    EXPECT_EQ(model.parts[0].indexCount, model.indices.size());
    for (const Vertex& vertex : model.vertices)
        EXPECT_LT(vertex.uv0.x, 0.45f);
}

} // namespace
} // namespace io
