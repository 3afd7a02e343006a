// Impostors' pictures from another run are the same to the last bit, and only ever those of the same model.
#include "io/files/model_file.h"
#include "renderer/run_length.h"
#include "tests/gl/support/shared_renderer.h"

#include <gtest/gtest.h>
#include <map>
#include <random>

namespace {

constexpr glm::ivec2 kSize{160, 48};

class Memory : public io::KeptBytes {
public:
    std::optional<std::string> find(const io::ContentKey& key) override
    {
        const auto known = bytes.find(key);
        found += known != bytes.end();
        return known == bytes.end() ? std::nullopt : std::optional{known->second};
    }
    void keep(const io::ContentKey& key, const std::string& made) override
    {
        bytes[key] = made;
        ++kept;
    }

    std::map<io::ContentKey, std::string> bytes;
    int found = 0, kept = 0;
};

io::Model shipped(const std::string& name)
{
    const std::filesystem::path root = WOLD_SOURCE_DIR "/projects/valley";
    io::Complaints complaints;
    io::Result<io::Model> model = io::readModel(root / "models" / (name + ".glb"), root, complaints);
    return model ? std::move(*model) : io::Model{};
}

using Models = std::vector<io::Model>;

// The models side by side, far away, as a renderer shows them that has just begun.
io::Image picture(const Models& models, const std::shared_ptr<Memory>& memory)
{
    test::TestWorld world;
    for (const io::Model& model : models) {
        const std::string name = std::to_string(world.assets.models.size());
        const io::TemplateId id = test::addTemplate(world, name, std::make_shared<const io::Model>(model));
        world.scene.exchange(id, io::Template{.name = name, .model = "models/it.glb", .impostor = true});
        test::addObject(world, id, {.position = {10.0 * double(world.assets.models.size()) - 15, -3, -150}});
    }
    world.scene.exchange(test::plainEnvironment(150, 40));
    auto made = renderer::Renderer::create(
        {.shaders = WOLD_SOURCE_DIR "/renderer/shaders", .debug = true, .kept = memory});
    EXPECT_TRUE(made);
    (*made)->update(world.scene, world.assets, {.everything = true});
    renderer::FrameInput in = test::frame(kSize, {.fov = 6});
    in.settings.lodPixels = 8;
    (*made)->render(in);
    EXPECT_EQ((*made)->stats().trianglesDrawn, 2 * models.size());
    EXPECT_EQ((*made)->glErrors(), 0u);
    return (*made)->readRadiance();
}

class KeptImpostors : public testing::Test {
protected:
    void SetUp() override { ASSERT_TRUE(test::haveContext()); }

    const Models models{shipped("rock_mossy"), shipped("beech_young")};
    std::shared_ptr<Memory> memory = std::make_shared<Memory>();
};

TEST_F(KeptImpostors, AreTheSameToTheLastBit)
{
    const io::Image fresh = picture(models, nullptr);
    EXPECT_EQ(picture(models, memory).bytes, fresh.bytes);
    EXPECT_EQ(memory->found, 0);
    EXPECT_EQ(memory->kept, 2);
    EXPECT_EQ(picture(models, memory).bytes, fresh.bytes);
    EXPECT_EQ(memory->found, 2);
    EXPECT_EQ(memory->kept, 2);
    EXPECT_EQ(picture({models[1]}, memory).bytes, picture({models[1]}, nullptr).bytes) << "in another layer";
    EXPECT_EQ(memory->found, 3);
}

TEST_F(KeptImpostors, AreWhatIsShown)
{
    const io::Image fresh = picture(models, memory);
    std::swap(memory->bytes.begin()->second, memory->bytes.rbegin()->second);
    EXPECT_NE(picture(models, memory).bytes, fresh.bytes);
}

TEST_F(KeptImpostors, AreMadeAnewWhereTheBytesDoNotFit)
{
    const io::Image fresh = picture(models, memory);
    const auto good = memory->bytes;
    for (const auto spoil : {+[](std::string& bytes) { bytes.resize(bytes.size() / 2); },
                             +[](std::string& bytes) { bytes += "four"; }, +[](std::string& bytes) { bytes.clear(); },
                             +[](std::string& bytes) { bytes[2] = '\x7f'; }}) { // a count beyond the picture
        for (auto& [key, bytes] : memory->bytes)
            spoil(bytes);
        EXPECT_EQ(picture(models, memory).bytes, fresh.bytes);
        EXPECT_EQ(memory->bytes, good) << "and kept anew";
    }
}

TEST_F(KeptImpostors, OfAnotherModelAreOthers)
{
    picture(models, memory);
    const auto differs = [&](const char* what, auto&& change) {
        const int before = memory->kept;
        Models changed = models;
        change(changed[1]);
        picture(changed, memory);
        EXPECT_EQ(memory->kept, before + 1) << what;
    };
    differs("geometry", [](io::Model& model) { model.vertices[5].position.x += 0.01f; });
    differs("triangles", [](io::Model& model) { std::swap(model.indices[0], model.indices[1]); });
    differs("colour", [](io::Model& model) { model.materials[0].baseColour.g *= 0.9f; });
    differs("cutoff", [](io::Model& model) { model.materials.back().alphaCutoff += 0.1f; });
    differs("wrap", [](io::Model& model) { model.materials[0].baseColourTexture.wrapU = io::Wrap::Mirror; });
    differs("pixels", [](io::Model& model) {
        for (std::shared_ptr<const io::Image>& image : model.images) {
            auto other = std::make_shared<io::Image>(*image);
            other->bytes[other->bytes.size() / 2] ^= std::byte{16};
            image = other;
        }
    });
    differs("no levels", [](io::Model& model) {
        model.levels = {{.error = 0.1f, .indices = {model.indices.begin(), model.indices.begin() + 300}}};
        model.levels[0].parts = {{.firstIndex = 0, .indexCount = 300, .material = model.parts[0].material}};
    });
}

TEST(RunLength, givesBackWhatItTook)
{
    std::mt19937 random{1};
    for (int size : {0, 1, 2, 3, 7, 500, 4096}) {
        std::vector<std::uint32_t> texels(std::size_t(size), 0), again(std::size_t(size), 1);
        for (std::size_t i = 0; i < texels.size(); ++i)
            texels[i] = random() % 3 && i > 0 ? texels[i - 1] : random() % 5;
        std::string bytes;
        renderer::packTexels(texels, bytes);
        std::string_view rest = bytes;
        EXPECT_TRUE(renderer::unpackTexels(rest, again));
        EXPECT_TRUE(rest.empty());
        EXPECT_EQ(again, texels);
        for (std::size_t cut = 0; cut < bytes.size(); ++cut) {
            std::string_view part{bytes.data(), cut};
            EXPECT_FALSE(renderer::unpackTexels(part, again)) << size << ' ' << cut;
        }
    }
    std::string bytes;
    renderer::packTexels(std::vector<std::uint32_t>(4096, 7), bytes);
    EXPECT_EQ(bytes.size(), 8u);
}

} // namespace
