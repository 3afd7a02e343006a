#include "coverage.h"
#include "support.h"

#include "io/files/level_cache.h"
#include "io/files/levels.h"
#include "io/files/model_file.h"
#include "io/files/surface_distance.h"

#include <cstring>
#include <limits>
#include <map>
#include <random>
#include <set>

namespace io {
namespace {

Model valley(const std::string& name)
{
    const fs::path folder = fs::path{WOLD_SOURCE_DIR} / "projects/valley";
    Complaints complaints;
    Result<Model> model = readModel(folder / "models" / (name + ".glb"), folder, complaints);
    EXPECT_TRUE(model) << name;
    return model ? std::move(*model) : Model{};
}

Model finished(Model model)
{
    model.bounds = {};
    for (const Vertex& vertex : model.vertices)
        model.bounds.add(vertex.position);
    if (model.materials.empty()) model.materials.emplace_back();
    if (model.parts.empty()) model.parts = {{.indexCount = std::uint32_t(model.indices.size())}};
    return model;
}

void addQuad(Model& model, std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d)
{
    model.indices.insert(model.indices.end(), {a, b, c, a, c, d});
}

// A ball with a seam, as modellers make them; the southern half of another material when asked for.
Model sphere(int rings, bool twoParts = false)
{
    Model model;
    const int around = rings * 2;
    for (int y = 0; y <= rings; ++y)
        for (int x = 0; x <= around; ++x) {
            const float down = float(y) / float(rings) * 3.14159265f;
            const float turn = float(x % around) / float(around) * 6.2831853f;
            const float out = y == rings ? 0 : std::sin(down); // both poles are points
            const glm::vec3 p{out * std::cos(turn), std::cos(down), out * std::sin(turn)};
            model.vertices.push_back({.position = p, .normal = p, .uv0 = {float(x) / float(around), float(y) / float(rings)}});
        }
    for (int y = 0; y < rings; ++y)
        for (int x = 0; x < around; ++x) {
            const auto at = [&](int i, int j) { return std::uint32_t(j * (around + 1) + i); };
            addQuad(model, at(x, y), at(x + 1, y), at(x + 1, y + 1), at(x, y + 1));
        }
    if (twoParts) {
        const auto half = std::uint32_t(model.indices.size() / 2);
        model.materials.resize(2);
        model.parts = {{0, half, 0}, {half, half, 1}};
    }
    return finished(std::move(model));
}

// Square cards strewn in a ball.
Model cardCloud(int cards, AlphaMode alpha)
{
    Model model;
    std::mt19937 random{5};
    std::uniform_real_distribution<float> unit{-1, 1};
    for (int i = 0; i < cards; ++i) {
        const glm::vec3 middle{unit(random) * 3, unit(random) * 3 + 4, unit(random) * 3};
        const glm::vec3 u = glm::normalize(glm::vec3{unit(random), unit(random), unit(random)}) * 0.3f;
        const glm::vec3 v = glm::normalize(glm::cross(u, glm::vec3{unit(random), 1, unit(random)})) * 0.3f;
        const auto first = std::uint32_t(model.vertices.size());
        for (const glm::vec2 corner : {glm::vec2{-1, -1}, {1, -1}, {1, 1}, {-1, 1}})
            model.vertices.push_back({.position = middle + u * corner.x + v * corner.y,
                                      .tangent = {0, 0, 1, -1},
                                      .uv0 = corner * 0.5f + 0.5f,
                                      .uv1 = {float(i), 1},
                                      .colour = {9, 8, 7, 255}});
        addQuad(model, first, first + 1, first + 2, first + 3);
    }
    model.materials = {{.alphaMode = alpha, .doubleSided = true}};
    return finished(std::move(model));
}

std::vector<SurfaceDistance::Triangle> surface(const Model& model, const std::vector<std::uint32_t>& indices)
{
    std::vector<SurfaceDistance::Triangle> result;
    for (std::size_t i = 0; i + 2 < indices.size(); i += 3)
        result.push_back({model.vertices[indices[i]].position, model.vertices[indices[i + 1]].position,
                          model.vertices[indices[i + 2]].position});
    return result;
}

// The farthest of random points of one surface from the other.
float farthest(const std::vector<SurfaceDistance::Triangle>& from, const std::vector<SurfaceDistance::Triangle>& other)
{
    const SurfaceDistance distance{other};
    std::mt19937 random{11};
    std::uniform_real_distribution<float> unit{0, 1};
    float result = 0;
    for (const SurfaceDistance::Triangle& t : from)
        for (int i = 0; i < 24; ++i) {
            float a = unit(random), b = unit(random);
            if (a + b > 1) a = 1 - a, b = 1 - b;
            result = std::max(result, distance.to(t[0] + (t[1] - t[0]) * a + (t[2] - t[0]) * b, result));
        }
    return result;
}

std::set<int> materialsOf(const std::vector<Part>& parts)
{
    std::set<int> result;
    for (const Part& part : parts)
        result.insert(part.material);
    return result;
}

// What the renderer relies on, whatever the model.
void expectSound(const Model& model)
{
    std::size_t before = model.triangles();
    float error = 0;
    for (const Level& level : model.levels) {
        EXPECT_GT(level.error, error);
        EXPECT_TRUE(std::isfinite(level.error));
        EXPECT_GT(level.indices.size(), 0u);
        EXPECT_LE(float(level.indices.size()) / 3, 0.75f * float(before));
        std::uint32_t next = 0;
        for (const Part& part : level.parts) {
            EXPECT_EQ(part.firstIndex, next);
            EXPECT_EQ(part.indexCount % 3, 0u);
            EXPECT_LT(std::size_t(part.material), model.materials.size());
            next += part.indexCount;
        }
        EXPECT_EQ(next, level.indices.size());
        for (const std::uint32_t index : level.indices) {
            ASSERT_LT(index, model.vertices.size());
            EXPECT_FALSE(std::isnan(model.vertices[index].position.x));
        }
        before = level.indices.size() / 3;
        error = level.error;
    }
    for (const std::uint32_t index : model.indices)
        ASSERT_LT(index, model.vertices.size());
}

bool same(const Model& a, const Model& b)
{
    const auto bytes = [](const Model& model) {
        return levels::encode({}, {.added = model.vertices, .indices = model.indices, .levels = model.levels});
    };
    return bytes(a) == bytes(b);
}

// All triangles by their corners' bytes, in no order.
std::multiset<std::string> drawn(const Model& model)
{
    std::multiset<std::string> result;
    for (std::size_t i = 0; i < model.indices.size(); i += 3) {
        std::size_t first = 0; // a triangle may begin at any of its corners
        const auto corner = [&](std::size_t c) {
            const Vertex& vertex = model.vertices[model.indices[i + c % 3]];
            return std::string{reinterpret_cast<const char*>(&vertex), sizeof vertex};
        };
        for (std::size_t c = 1; c < 3; ++c)
            if (corner(c) < corner(first)) first = c;
        result.insert(corner(first) + corner(first + 1) + corner(first + 2));
    }
    return result;
}

TEST(Levels, countsFallByHalf)
{
    Model model = sphere(32);
    const std::size_t full = model.triangles();
    makeLevels(model);
    expectSound(model);
    ASSERT_GE(model.levels.size(), 4u);
    double share = 0.5;
    for (const Level& level : model.levels) {
        EXPECT_NEAR(double(level.indices.size()) / 3 / double(full), share, share * 0.1);
        share /= 2;
    }
    EXPECT_EQ(model.triangles(), full);
}

TEST(Levels, errorsOfSolidsAreHonest)
{
    for (Model model : {sphere(24), sphere(24, true), valley("rock"), valley("boulder"), valley("stump")}) {
        makeLevels(model);
        expectSound(model);
        ASSERT_FALSE(model.levels.empty()) << model.name;
        const auto full = surface(model, model.indices);
        for (const Level& level : model.levels) {
            const auto own = surface(model, level.indices);
            EXPECT_LE(farthest(own, full), 1.25f * level.error) << model.name;
            EXPECT_LE(farthest(full, own), 1.25f * level.error) << model.name;
            EXPECT_LT(level.error, 0.5f * glm::length(model.bounds.size())) << model.name;
        }
    }
    Model model = sphere(24);
    makeLevels(model);
    EXPECT_LT(model.levels.front().error, 0.03f) << "half a fine ball is still round";
}

TEST(Levels, noCrackOpensBetweenParts)
{
    Model model = sphere(24, true);
    makeLevels(model);
    ASSERT_GE(model.levels.size(), 3u);
    for (const Level& level : model.levels) {
        EXPECT_EQ(materialsOf(level.parts), (std::set<int>{0, 1}));
        // Each edge, by position, is used once in each direction: the ball is closed.
        std::map<std::array<float, 6>, int> edges;
        for (const SurfaceDistance::Triangle& t : surface(model, level.indices))
            for (std::size_t c = 0; c < 3; ++c) {
                const glm::vec3 a = t[c], b = t[(c + 1) % 3];
                if (a == b) continue;
                ++edges[{a.x, a.y, a.z, b.x, b.y, b.z}];
                --edges[{b.x, b.y, b.z, a.x, a.y, a.z}];
            }
        for (const auto& [edge, open] : edges)
            EXPECT_EQ(open, 0) << edge[0] << ' ' << edge[1] << ' ' << edge[2];
    }
}

TEST(Levels, crownsKeepTheirFullness)
{
    for (const char* name : {"oak", "oak_autumn", "beech", "birch_autumn", "birch_old", "fir", "bush"}) {
        Model model = valley(name);
        makeLevels(model);
        expectSound(model);
        ASSERT_FALSE(model.levels.empty()) << name;
        const std::array<int, 6> full = coverage(model, model.indices, model.parts, 128);
        for (const Level& level : model.levels) {
            const std::array<int, 6> own = coverage(model, level.indices, level.parts, 128);
            double share = 0;
            for (std::size_t side = 0; side < 6; ++side) {
                share += double(own[side]) / double(full[side]) / 6;
                EXPECT_NEAR(double(own[side]) / double(full[side]), 1, 0.25) << name << " from " << side;
            }
            EXPECT_NEAR(share, 1, 0.15) << name << " at " << level.indices.size() / 3;
        }
        EXPECT_EQ(materialsOf(model.levels.front().parts), materialsOf(model.parts)) << name;
    }
}

TEST(Levels, cardsThinEvenlyAndStayInTheCrown)
{
    for (const AlphaMode alpha : {AlphaMode::Mask, AlphaMode::Blend}) {
        Model model = cardCloud(400, alpha);
        makeLevels(model);
        expectSound(model);
        ASSERT_GE(model.levels.size(), 3u);
        for (const Level& level : model.levels) {
            std::array<int, 8> octants{};
            for (std::size_t i = 0; i < level.indices.size(); i += 3) {
                const Vertex& vertex = model.vertices[level.indices[i]];
                EXPECT_EQ(vertex.colour, glm::u8vec4(9, 8, 7, 255));
                EXPECT_EQ(vertex.tangent, glm::vec4(0, 0, 1, -1));
                EXPECT_EQ(vertex.uv1.y, 1);
                const glm::vec3 over = glm::abs(vertex.position - model.bounds.centre()) / model.bounds.size();
                EXPECT_LT(std::max({over.x, over.y, over.z}), 0.55f);
                const glm::bvec3 high = glm::greaterThan(vertex.position, model.bounds.centre());
                ++octants[std::size_t(high.x + 2 * high.y + 4 * high.z)];
            }
            const auto [fewest, most] = std::minmax_element(octants.begin(), octants.end());
            const std::size_t cards = level.indices.size() / 6;
            EXPECT_LE(*most, cards >= 40 ? *fewest * 3 : int(cards)) << cards;
            EXPECT_GE(*fewest, cards >= 20 ? 1 : 0) << cards;
        }
    }
}

TEST(Levels, whatIsDrawnInFullStaysTheSame)
{
    for (const char* name : {"oak", "hut", "grass"}) {
        Model model = valley(name);
        const Model before = model;
        makeLevels(model);
        EXPECT_TRUE(drawn(model) == drawn(before)) << name;
        ASSERT_EQ(model.parts.size(), before.parts.size());
        for (std::size_t i = 0; i < model.parts.size(); ++i)
            EXPECT_EQ(model.parts[i].indexCount, before.parts[i].indexCount);
        EXPECT_EQ(model.bounds, before.bounds);
    }
    Model blended = cardCloud(100, AlphaMode::Blend);
    const auto before = surface(blended, blended.indices);
    makeLevels(blended);
    EXPECT_TRUE(surface(blended, blended.indices) == before) << "blended triangles keep their order";
}

TEST(Levels, oddInputIsNoTrouble)
{
    Model empty;
    empty.materials.emplace_back();
    makeLevels(empty);
    EXPECT_TRUE(empty.levels.empty());

    Model small = boxModel({1, 1, 1}, {1, 1, 1, 1});
    makeLevels(small);
    EXPECT_TRUE(small.levels.empty());

    Model flat = sphere(16); // no area anywhere
    for (Vertex& vertex : flat.vertices)
        vertex.position = {1, 2, 3};
    makeLevels(flat);
    expectSound(flat);

    Model holes = sphere(16);
    for (std::size_t i = 0; i < holes.vertices.size(); i += 7)
        holes.vertices[i].position.x = i % 2 ? std::numeric_limits<float>::quiet_NaN() : std::numeric_limits<float>::infinity();
    makeLevels(holes);
    expectSound(holes);

    Model huge = sphere(16);
    for (Vertex& vertex : huge.vertices)
        vertex.position *= 1e30f; // areas are infinite
    makeLevels(huge);
    expectSound(huge);

    Model lonely = sphere(16); // parts of one triangle
    lonely.parts.clear();
    for (std::uint32_t i = 0; i < lonely.indices.size(); i += 3)
        lonely.parts.push_back({i, 3, 0});
    makeLevels(lonely);
    expectSound(lonely);

    Model shards = sphere(16); // nothing shares a vertex, all normals are the faces'
    std::vector<Vertex> loose;
    for (std::size_t i = 0; i < shards.indices.size(); ++i) {
        loose.push_back(shards.vertices[shards.indices[i]]);
        loose.back().normal = shards.vertices[shards.indices[i / 3 * 3]].normal;
    }
    shards.vertices = std::move(loose);
    for (std::uint32_t i = 0; i < shards.indices.size(); ++i)
        shards.indices[i] = i;
    makeLevels(shards);
    expectSound(shards);
    ASSERT_GE(shards.levels.size(), 3u) << "hard edges do not hold the triangles";
    EXPECT_LT(shards.levels.front().error, 0.05f);
}

TEST(Levels, writtenModelsHoldTheFullOneAlone)
{
    Model model = valley("oak_young");
    makeLevels(model);
    ASSERT_FALSE(model.levels.empty());
    Model full = model;
    full.levels.clear();
    full.vertices.resize(*std::max_element(full.indices.begin(), full.indices.end()) + std::size_t{1});
    ASSERT_LT(full.vertices.size(), model.vertices.size());
    const Result<std::string> bytes = encodeGlb(model), plain = encodeGlb(full);
    ASSERT_TRUE(bytes && plain);
    EXPECT_TRUE(*bytes == *plain);
}

TEST(LevelCache, readsBackWhatWasMade)
{
    const TemporaryFolder folder;
    for (const char* name : {"oak_young", "stump", "fir_young"}) {
        Model made = valley(name), first = made, second = made;
        makeLevels(made);
        addLevels(first, folder / "levels");
        EXPECT_TRUE(same(first, made)) << name << ": twice the same";
        const fs::path file = folder / "levels" / levels::fileName(levels::keyOf(second));
        ASSERT_TRUE(fs::exists(file));
        const auto written = fs::last_write_time(file);
        addLevels(second, folder / "levels");
        EXPECT_TRUE(same(second, made)) << name << ": from the disk";
        EXPECT_EQ(fs::last_write_time(file), written);
    }
    for (const auto& entry : fs::directory_iterator{folder / "levels"})
        EXPECT_EQ(entry.path().extension(), ".levels") << "no temporary stays";
}

TEST(LevelCache, theKeyFollowsWhatIsDrawn)
{
    const Model model = valley("oak_young");
    Model moved = model, masked = model;
    moved.vertices[7].position.x += 0.01f;
    masked.materials[0].alphaMode = AlphaMode::Blend;
    EXPECT_NE(levels::keyOf(moved), levels::keyOf(model));
    EXPECT_NE(levels::keyOf(masked), levels::keyOf(model));
}

TEST(LevelCache, aFolderThatCannotBeWrittenIsNoError)
{
    const TemporaryFolder folder;
    put(folder / "file", "in the way");
    Model model = sphere(16);
    addLevels(model, folder / "file" / "levels");
    EXPECT_FALSE(model.levels.empty());
}

// Damage that the checksum would find, and damage behind a checksum that fits.
TEST(LevelCache, damagedFilesAreMadeAnew)
{
    const TemporaryFolder folder;
    const Model source = valley("birch_young");
    Model made = source;
    addLevels(made, folder.path());
    const levels::Key key = levels::keyOf(source);
    const fs::path file = folder / levels::fileName(key);
    const std::string good = get(file);
    ASSERT_TRUE(levels::decode(good, key, source));

    std::mt19937 random{3};
    for (int i = 0; i < 200; ++i) {
        std::string bad = good;
        if (i % 4 == 0)
            bad.resize(random() % bad.size());
        else if (i % 4 == 1)
            bad += "more";
        else
            bad[random() % bad.size()] ^= char(1 << random() % 8);
        EXPECT_FALSE(levels::decode(bad, key, source)) << i;
    }
    put(file, good.substr(0, good.size() / 2));
    Model again = source;
    addLevels(again, folder.path());
    EXPECT_TRUE(same(again, made));
    EXPECT_EQ(get(file), good);
}

TEST(LevelCache, hostileNumbersAreRefused)
{
    Model source = valley("birch_young");
    Model made = source;
    makeLevels(made);
    const levels::Key key = levels::keyOf(source);
    levels::Made good{.added = {}, .indices = made.indices, .levels = made.levels};
    for (std::uint32_t i = 0; i < source.vertices.size(); ++i)
        good.order.push_back(i);
    good.added.resize(made.vertices.size() - source.vertices.size());
    ASSERT_TRUE(levels::decode(levels::encode(key, good), key, source));

    std::mt19937 random{9};
    int kept = 0;
    for (int i = 0; i < 400; ++i) {
        levels::Made bad = good;
        const std::uint32_t value = i % 3 == 0 ? random() : i % 3 == 1 ? ~0u : random() % 4000;
        Level& level = bad.levels[random() % bad.levels.size()];
        switch (random() % 8) {
        case 0: bad.order[random() % bad.order.size()] = value; break;
        case 1: bad.indices[random() % bad.indices.size()] = value; break;
        case 2: level.indices[random() % level.indices.size()] = value; break;
        case 3: level.parts[random() % level.parts.size()].firstIndex = value; break;
        case 4: level.parts[random() % level.parts.size()].indexCount = value; break;
        case 5: level.parts[random() % level.parts.size()].material = int(value); break;
        case 6: std::memcpy(&level.error, &value, sizeof value); break;
        default: bad.added[random() % bad.added.size()].position.y = std::numeric_limits<float>::infinity();
        }
        std::optional<levels::Made> read = levels::decode(levels::encode(key, bad), key, source);
        if (!read) continue;
        ++kept;
        Model model = source;
        levels::apply(std::move(*read), model);
        for (const std::uint32_t index : model.indices)
            ASSERT_LT(index, model.vertices.size());
        for (const Level& one : model.levels)
            for (const std::uint32_t index : one.indices)
                ASSERT_LT(index, model.vertices.size());
    }
    EXPECT_LT(kept, 200);
    // Mutations of the bytes themselves, with the checksum made to fit: see the header's layout in level_cache.cpp.
    EXPECT_FALSE(levels::decode(levels::encode({1, 2}, good), key, source)) << "another model's";
}

} // namespace
} // namespace io
