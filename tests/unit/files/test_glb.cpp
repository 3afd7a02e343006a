#include "support.h"

#include "io/files/model_file.h"

#include <algorithm>

namespace io {
namespace {

std::shared_ptr<const Image> pixels(int channels)
{
    auto image = std::make_shared<Image>();
    image->size = {2, 2};
    image->channels = channels;
    for (int i = 0; i < 4 * channels; ++i)
        image->bytes.push_back(std::byte(i * 10));
    return image;
}

// Two boxes of different materials, everything that a material can say, and both sets of texture coordinates.
Model furnished()
{
    Model model = boxModel({1, 2, 3}, {1, 0.5f, 0.25f, 1});
    model.name = "furnished";
    model.parts = {{0, 18, 1}, {18, 18, 0}};
    model.images = {pixels(3), nullptr, pixels(4)};
    Material second;
    second.name = "leaf \"card\"";
    second.alphaMode = AlphaMode::Mask;
    second.alphaCutoff = 0.3f;
    second.doubleSided = true;
    second.unlit = true;
    second.normalScale = 0.5f;
    second.occlusionStrength = 0.25f;
    second.emissive = {0.1f, 0.2f, 0.3f};
    second.baseColourTexture = {.image = 2,
                                .uvSet = 1,
                                .offset = {0.5f, 0},
                                .scale = {2, 3},
                                .rotation = 0.25f,
                                .wrapU = Wrap::Mirror,
                                .wrapV = Wrap::Clamp};
    second.normalTexture = {.image = 0};
    second.occlusionTexture = {.image = 0};
    second.metallicRoughnessTexture = {.image = 0};
    second.emissiveTexture = {.image = 1}; // could not be read: left out
    model.materials.push_back(second);
    model.materials[0].alphaMode = AlphaMode::Blend;
    for (std::size_t i = 0; i < model.vertices.size(); ++i) {
        model.vertices[i].uv1 = model.vertices[i].uv0 * 0.5f;
        model.vertices[i].colour = {i, 255, 128, 255};
    }
    return model;
}

Model readBack(const std::string& glb)
{
    const TemporaryFolder folder;
    put(folder / "model.glb", glb);
    Complaints complaints;
    const Result<Model> model = readModel(folder / "model.glb", folder.path(), complaints);
    EXPECT_TRUE(model) << model.error().text();
    EXPECT_EQ(listed(complaints), "");
    return model ? *model : Model{};
}

const Material* named(const Model& model, const std::string& name)
{
    const auto found =
        std::find_if(model.materials.begin(), model.materials.end(), [&](const Material& m) { return m.name == name; });
    return found == model.materials.end() ? nullptr : &*found;
}

TEST(Glb, ABoxComesBackAsItWas)
{
    const Model box = boxModel({2, 1, 4}, {1, 0, 0, 1});
    const Result<std::string> glb = encodeGlb(box);
    ASSERT_TRUE(glb) << glb.error().text();
    const Model back = readBack(*glb);
    EXPECT_EQ(back.triangles(), 12u);
    EXPECT_EQ(back.bounds, box.bounds);
    ASSERT_EQ(back.vertices.size(), box.vertices.size());
    for (std::size_t i = 0; i < box.vertices.size(); ++i) {
        EXPECT_EQ(back.vertices[i].position, box.vertices[i].position);
        EXPECT_EQ(back.vertices[i].normal, box.vertices[i].normal);
        EXPECT_EQ(back.vertices[i].uv0, box.vertices[i].uv0);
    }
    EXPECT_EQ(back.indices, box.indices);
    EXPECT_EQ(back.materials[0].baseColour, glm::vec4(1, 0, 0, 1));
    EXPECT_EQ(back.materials[0].roughness, 0.8f);
}

TEST(Glb, MaterialsTexturesAndColoursComeBack)
{
    const Model model = furnished();
    const Result<std::string> glb = encodeGlb(model);
    ASSERT_TRUE(glb) << glb.error().text();
    const Model back = readBack(*glb);
    EXPECT_EQ(back.parts.size(), 2u);
    EXPECT_EQ(back.images.size(), 2u);
    const Material* leaf = named(back, "leaf \"card\"");
    ASSERT_NE(leaf, nullptr);
    const Material& was = model.materials[1];
    EXPECT_EQ(leaf->alphaMode, AlphaMode::Mask);
    EXPECT_EQ(leaf->alphaCutoff, was.alphaCutoff);
    EXPECT_TRUE(leaf->doubleSided && leaf->unlit);
    EXPECT_EQ(leaf->normalScale, was.normalScale);
    EXPECT_EQ(leaf->occlusionStrength, was.occlusionStrength);
    EXPECT_EQ(leaf->emissive, was.emissive);
    const TextureUse& use = leaf->baseColourTexture;
    EXPECT_EQ(use.uvSet, 1);
    EXPECT_EQ(use.offset, was.baseColourTexture.offset);
    EXPECT_EQ(use.scale, was.baseColourTexture.scale);
    EXPECT_EQ(use.rotation, was.baseColourTexture.rotation);
    EXPECT_EQ(use.wrapU, Wrap::Mirror);
    EXPECT_EQ(use.wrapV, Wrap::Clamp);
    EXPECT_EQ(back.images[std::size_t(use.image)]->bytes, model.images[2]->bytes);
    EXPECT_EQ(back.images[std::size_t(leaf->normalTexture.image)]->bytes, model.images[0]->bytes);
    EXPECT_EQ(leaf->emissiveTexture.image, -1);
    for (std::size_t i = 0; i < model.vertices.size(); ++i) {
        EXPECT_EQ(back.vertices[i].colour, model.vertices[i].colour);
        EXPECT_EQ(back.vertices[i].uv1, model.vertices[i].uv1);
        EXPECT_EQ(back.vertices[i].tangent, model.vertices[i].tangent);
    }
}

TEST(Glb, IsTheSameBytesEachTime)
{
    EXPECT_EQ(*encodeGlb(furnished()), *encodeGlb(furnished()));
}

TEST(Glb, SizesAreWrittenAsWholeNumbers)
{
    Model model = boxModel(glm::vec3{1}, glm::vec4{1});
    model.vertices.resize(100'000); // sizes of a million bytes and more
    const Result<std::string> glb = encodeGlb(model);
    ASSERT_TRUE(glb);
    EXPECT_EQ(glb->substr(0, glb->find("BIN")).find("e+"), std::string::npos);
    EXPECT_EQ(readBack(*glb).indices, model.indices); // needs 32 bits each
}

TEST(Glb, RefusesModelsThatDoNotFitTogether)
{
    EXPECT_FALSE(encodeGlb(Model{}));
    Model model = boxModel(glm::vec3{1}, glm::vec4{1});
    model.parts[0].material = 7;
    EXPECT_FALSE(encodeGlb(model));
    model = boxModel(glm::vec3{1}, glm::vec4{1});
    model.indices[3] = 1000;
    EXPECT_FALSE(encodeGlb(model));
    model = boxModel(glm::vec3{1}, glm::vec4{1});
    model.parts[0].indexCount = 40;
    EXPECT_FALSE(encodeGlb(model));
}

// One triangle near by, the same carried away by its node, and a mesh of two corners.
constexpr const char* kPartlyDrawable = R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0,1,2]}],
"nodes":[{"mesh":0},{"mesh":0,"scale":[1e9,1e9,1e9]},{"mesh":1}],
"meshes":[{"primitives":[{"attributes":{"POSITION":0}}]},{"primitives":[{"attributes":{"POSITION":0},"indices":1}]}],
"accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3","min":[0,0,0],"max":[4,4,0]},
{"bufferView":1,"componentType":5123,"count":2,"type":"SCALAR"}],
"bufferViews":[{"buffer":0,"byteLength":36},{"buffer":0,"byteOffset":36,"byteLength":6}],
"buffers":[{"byteLength":42,"uri":"data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAQAAAAAAAAAAAAAAAAAAAgEAAAAAAAAABAAAA"}]})";

TEST(Glb, WhatCannotBeDrawnIsNamedAndLeftOut)
{
    const TemporaryFolder folder;
    put(folder / "m.gltf", kPartlyDrawable);
    Complaints complaints;
    const Result<Model> model = readModel(folder / "m.gltf", folder.path(), complaints);
    ASSERT_TRUE(model) << model.error().text();
    EXPECT_EQ(model->triangles(), 1u);
    EXPECT_EQ(model->bounds.max.x, 4);
    const std::string faults = listed(complaints);
    EXPECT_NE(faults.find("meshes[1].primitives[0]: holds no triangles; left out"), faults.npos) << faults;
    EXPECT_NE(faults.find("over 1e9 m away are left out"), faults.npos) << faults;
}

// Two triangles, the second with corners that are not numbers or have no end.
constexpr const char* kWithoutEnd = R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],
"meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],
"accessors":[{"bufferView":0,"componentType":5126,"count":6,"type":"VEC3","min":[0,0,0],"max":[4,4,0]}],
"bufferViews":[{"buffer":0,"byteLength":72}],
"buffers":[{"byteLength":72,"uri":"data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAQAAAAAAAAAAAAAAAAAAAgEAAAAAAAADAfwAAAAAAAAAAAACAPwAAgH8AAAAAAAAAAAAAgP8AAIA/"}]})";

TEST(Glb, CornersWithoutEndAreNamedAndLeftOut)
{
    const TemporaryFolder folder;
    put(folder / "m.gltf", kWithoutEnd);
    Complaints complaints;
    const Result<Model> model = readModel(folder / "m.gltf", folder.path(), complaints);
    ASSERT_TRUE(model) << model.error().text();
    EXPECT_EQ(model->triangles(), 1u);
    EXPECT_EQ(model->bounds.min, (glm::vec3{0, 0, 0}));
    EXPECT_EQ(model->bounds.max, (glm::vec3{4, 4, 0}));
    EXPECT_NE(listed(complaints).find("infinite or far-off corners are left out"), std::string::npos) << listed(complaints);
}

} // namespace
} // namespace io
