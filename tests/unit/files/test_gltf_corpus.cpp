// Models that nobody here made: valid ones of other tools, and broken ones with what each must do.
#include "model_checks.h"
#include "support.h"

#include "io/files/json.h"
#include "io/files/model_file.h"

#include <cstring>
#include <map>
#include <sys/stat.h>

namespace io {
namespace {

struct ReadGltf {
    Complaints complaints;
    Result<Model> model;
    ReadGltf(const fs::path& file, const fs::path& root) : model{readModel(file, root, complaints)} {}
    explicit ReadGltf(const fs::path& file) : ReadGltf{file, file.parent_path()} {}
    bool refused(std::string_view words) const { return !model && model.error().what.find(words) != std::string::npos; }
};

bool isModel(const fs::path& file)
{
    return file.extension() == ".gltf" || file.extension() == ".glb";
}

TEST(GltfCorpus, ValidFilesLoadOrAreRefusedByName)
{
    NEEDS_TEST_DATA();
    int loaded = 0;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator{testData() / "corpus/gltf-valid"}) {
        if (!isModel(entry.path())) continue;
        const std::string name = entry.path().filename().string();
        const ReadGltf read{entry.path()};
        if (read.model) {
            ++loaded;
            expectSound(*read.model, name);
            EXPECT_EQ(read.complaints.empty(), name != "missing_texture.glb")
                << name << ": " << listed(read.complaints);
        } else {
            EXPECT_TRUE(read.refused("EXT_meshopt_compression") || read.refused("KHR_draco_mesh_compression"))
                << read.model.error().text();
        }
    }
    EXPECT_GE(loaded, 50);
}

TEST(GltfCorpus, SpecialFilesMeanWhatTheySay)
{
    NEEDS_TEST_DATA();
    const fs::path derived = testData() / "corpus/gltf-valid/derived";
    const ReadGltf missing{derived / "missing_texture.glb"};
    ASSERT_TRUE(missing.model);
    EXPECT_EQ(missing.model->images.at(0), nullptr);
    EXPECT_EQ(missing.complaints.size(), 1u);

    EXPECT_EQ(ReadGltf(derived / "nodes_20000_flat.glb").model->triangles(), 40'000u);
    EXPECT_EQ(ReadGltf(derived / "ext_mesh_gpu_instancing_500.glb").model->triangles(), 1000u);
    EXPECT_EQ(ReadGltf(derived / "tree_alpha_mask.glb").model->materials[0].alphaMode == AlphaMode::Mask ||
                  ReadGltf(derived / "tree_alpha_mask.glb").model->materials[1].alphaMode == AlphaMode::Mask,
              true);
    const Model blend = *ReadGltf(derived / "blend_quads.glb").model;
    EXPECT_EQ(blend.materials[0].alphaMode, AlphaMode::Blend);
    const Model coloured = *ReadGltf(testData() / "corpus/gltf-valid/gltf-transform/BoxVertexColors.glb").model;
    EXPECT_NE(coloured.vertices[0].colour, glm::u8vec4{255});
    const Model uvs = *ReadGltf(derived / "two_uv_sets_rgba_colours_texture_transform.glb").model;
    EXPECT_TRUE(
        std::any_of(uvs.vertices.begin(), uvs.vertices.end(), [](const Vertex& v) { return v.uv1 != glm::vec2{0}; }));
}

// The links and pipes that the corpus cannot hold.
fs::path withSpecialFiles(const fs::path& source, const TemporaryFolder& folder)
{
    const fs::path copy = folder / "handmade";
    fs::copy(source, copy, fs::copy_options::recursive);
    fs::permissions(copy / "uri", fs::perms::owner_all, fs::perm_options::add);
    fs::create_symlink("/etc/passwd", copy / "uri/link-to-etc-passwd.bin");
    fs::create_symlink("/etc/passwd", copy / "uri/link-to-etc-passwd.png");
    ::mkfifo((copy / "uri/fifo.bin").c_str(), 0600);
    ::mkfifo((copy / "uri/fifo.png").c_str(), 0600);
    return copy;
}

TEST(GltfCorpus, BrokenFilesDoWhatIsExpectedOfThem)
{
    NEEDS_TEST_DATA();
    const TemporaryFolder folder;
    const fs::path handmade = withSpecialFiles(testData() / "corpus/gltf-invalid/handmade", folder);
    const Result<Value> expected = parseJson(get(handmade / "expected.json"), "expected.json");
    ASSERT_TRUE(expected);
    int checked = 0;
    for (const auto& [name, value] : *expected->asObject()) {
        if (!fs::exists(handmade / name)) continue; // made by HugeFiles below
        const std::string& wanted = *value.asString();
        const ReadGltf read{handmade / name};
        ++checked;
        if (wanted == "refuse") {
            EXPECT_FALSE(read.model) << name;
        } else if (wanted.starts_with("load mesh, placeholder")) {
            ASSERT_TRUE(read.model) << name << ": " << read.model.error().text();
            EXPECT_EQ(read.model->images.at(0), nullptr) << name;
            EXPECT_FALSE(read.complaints.empty()) << name;
        } else if (!read.refused("holds no triangles")) { // where the bad part was all there is
            EXPECT_TRUE(read.model) << name << ": " << read.model.error().text();
        }
        if (read.model) expectSound(*read.model, name);
    }
    EXPECT_GE(checked, 150);
}

TEST(GltfCorpus, FilesThatBrokeOtherLoadersBreakNothing)
{
    NEEDS_TEST_DATA();
    int seen = 0;
    for (const char* from : {"tinygltf", "assimp"}) {
        for (const fs::directory_entry& entry :
             fs::recursive_directory_iterator{testData() / "corpus/gltf-invalid" / from}) {
            if (!isModel(entry.path())) continue;
            const ReadGltf read{entry.path()};
            if (read.model) expectSound(*read.model, entry.path().string());
            ++seen;
        }
    }
    EXPECT_GT(seen, 20);
}

const std::string kTriangle =
    R"("buffers":[{"uri":"data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAAAAABAAIAAAA=","byteLength":44}],)"
    R"("bufferViews":[{"buffer":0,"byteOffset":0,"byteLength":36},{"buffer":0,"byteOffset":36,"byteLength":6}],)"
    R"("accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"},{"bufferView":1,"componentType":5123,"count":3,"type":"SCALAR"}])";
const std::string kMesh = R"("meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1}]}],)";
const std::string kHead = R"({"asset":{"version":"2.0"},"scene":0,)";

TEST(Gltf, HugeFilesEndSoonAndWhole)
{
    const TemporaryFolder folder;
    std::string chain = kHead + R"("scenes":[{"nodes":[0]}],"nodes":[)";
    for (int i = 0; i < 200'000; ++i)
        chain += i + 1 < 200'000 ? "{\"children\":[" + std::to_string(i + 1) + "]}," : std::string{"{\"mesh\":0}]"};
    put(folder / "chain.gltf", chain + "," + kMesh + kTriangle + "}");
    EXPECT_TRUE(ReadGltf(folder / "chain.gltf").model);

    std::string million = kHead + R"("scenes":[{"nodes":[]}],"nodes":[{})";
    for (int i = 1; i < 1'000'000; ++i)
        million += ",{}";
    put(folder / "million.gltf", million + "]}");
    EXPECT_TRUE(ReadGltf(folder / "million.gltf").refused("too many"));

    put(folder / "deep.gltf", kHead + "\"extras\":" + std::string(2'000'000, '['));
    EXPECT_TRUE(ReadGltf(folder / "deep.gltf").refused("nested more than 64 deep"));

    std::string name = kHead + R"("scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],"materials":[{"name":")" +
                       std::string(10'000'000, 'x') + "\"}],";
    put(folder / "name.gltf",
        name + R"("meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1,"material":0}]}],)" + kTriangle +
            "}");
    const ReadGltf named{folder / "name.gltf"};
    ASSERT_TRUE(named.model);
    EXPECT_EQ(named.model->materials[0].name.size(), 256u);

    std::string many = kHead + R"("scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],"meshes":[{"primitives":[)";
    for (int i = 0; i < 160'000; ++i)
        many += std::string{i ? "," : ""} + R"({"attributes":{"POSITION":0},"indices":1})";
    put(folder / "many.gltf", many + "]}]," + kTriangle + "}");
    const ReadGltf shared{folder / "many.gltf"};
    EXPECT_TRUE(shared.model || shared.refused("over")) << shared.model.error().text();
}

TEST(Gltf, AModelMayNameFilesElsewhereInTheProjectButNotOutside)
{
    NEEDS_TEST_DATA();
    const TemporaryFolder outer;
    const fs::path root = outer / "project";
    const std::string text =
        kHead +
        R"("scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],"materials":[{"pbrMetallicRoughness":{"baseColorTexture":{"index":0}}}],)" +
        R"("textures":[{"source":0}],"images":[{"uri":"../textures/a%20b.png"}],)" +
        R"("meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1,"material":0}]}],)" + kTriangle + "}";
    put(root / "models/m.gltf", text);
    const std::string png = get(testData() / "corpus/images-bad/handmade/png16-ok.png");
    put(root / "textures/a b.png", png);
    put(outer / "textures/a b.png", png);
    const ReadGltf inside{root / "models/m.gltf", root};
    ASSERT_TRUE(inside.model) << inside.model.error().text();
    EXPECT_NE(inside.model->images.at(0), nullptr) << listed(inside.complaints);
    put(root / "m.gltf", text); // one folder higher: the same name leads out
    const ReadGltf outside{root / "m.gltf", root};
    ASSERT_TRUE(outside.model);
    EXPECT_EQ(outside.model->images.at(0), nullptr);
    EXPECT_NE(listed(outside.complaints).find("leads out of the project"), std::string::npos);
}

TEST(Gltf, ComplaintsOfOneFileAreCapped)
{
    const TemporaryFolder folder;
    std::string text =
        kHead +
        R"("scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],"meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1})";
    for (int i = 0; i < 500; ++i)
        text += R"(,{"attributes":{"POSITION":0},"mode":0})";
    put(folder / "m.gltf", text + "]}]," + kTriangle + "}");
    const ReadGltf read{folder / "m.gltf"};
    ASSERT_TRUE(read.model) << read.model.error().text();
    EXPECT_EQ(read.complaints.size(), 51u);
}

// A box under a node that mirrors it: its faces and its normals still point outwards.
TEST(Gltf, FrontsStayFrontsWhereANodeMirrors)
{
    const TemporaryFolder folder;
    std::string glb = *encodeGlb(boxModel({1, 1, 1}, {1, 1, 1, 1}));
    const std::string plain = R"("nodes":[{"name":"box","mesh":0}])",
                      mirrored = R"("nodes":[{"scale":[1,-1,1],"mesh":0}])";
    const std::size_t at = glb.find(plain);
    ASSERT_NE(at, std::string::npos);
    glb.replace(at, plain.size(), mirrored);
    std::uint32_t sizes[2]; // of the JSON chunk, which is padded with spaces, and before it of the whole
    std::memcpy(sizes, glb.data() + 8, 8);
    const std::size_t end = 20 + sizes[1] + (mirrored.size() - plain.size());
    const std::size_t padding = (4 - end % 4) % 4;
    glb.insert(end, padding, ' ');
    sizes[0] = std::uint32_t(glb.size());
    sizes[1] = std::uint32_t(end + padding - 20);
    std::memcpy(glb.data() + 8, sizes, 8);
    put(folder / "m.glb", glb);
    const ReadGltf read{folder / "m.glb"};
    ASSERT_TRUE(read.model) << read.model.error().text();
    EXPECT_EQ(read.model->bounds.min.y, -1);
    for (std::size_t i = 0; i < read.model->indices.size(); i += 3) {
        const auto corner = [&](std::size_t c) { return read.model->vertices[read.model->indices[i + c]]; };
        const glm::vec3 face =
            glm::cross(corner(1).position - corner(0).position, corner(2).position - corner(0).position);
        EXPECT_GT(glm::dot(face, corner(0).normal), 0);
        EXPECT_GT(glm::dot(corner(0).normal, corner(0).position - glm::vec3(0, -0.5f, 0)), 0);
    }
}

TEST(Gltf, NodesAreTreesOrRefused)
{
    const TemporaryFolder folder;
    const auto refused = [&](const std::string& roots, const std::string& nodes) {
        put(folder / "m.gltf",
            kHead + "\"scenes\":[{\"nodes\":[" + roots + "]}],\"nodes\":[" + nodes + "]," + kMesh + kTriangle + "}");
        const ReadGltf read{folder / "m.gltf"};
        return read.model ? std::string{} : read.model.error().what;
    };
    EXPECT_EQ(refused("0", R"({"mesh":0})"), "");
    EXPECT_EQ(refused("0,0", R"({"mesh":0})"), "");
    EXPECT_EQ(refused("0,1", R"({"children":[2]},{"children":[2]},{"mesh":0})"), "nodes[2]: has two parents");
    EXPECT_EQ(refused("0,1", R"({"children":[1]},{"mesh":0})"), "nodes[1]: is a root and a child");
    EXPECT_EQ(refused("0", R"({"mesh":0},{"children":[2]},{"children":[1]})"), "nodes[1]: is its own ancestor");
    EXPECT_EQ(refused("0", R"({"mesh":0,"children":[1]},{"children":[2]},{"children":[1]})"),
              "nodes[1]: has two parents");
}

// Of a square that faces +Z: u to the right, and v downwards as in glTF, so that the bitangent points up.
TEST(Gltf, TangentsFollowTheTexture)
{
    const TemporaryFolder folder;
    for (const float side : {1.0f, -1.0f}) { // -1: the texture is mirrored
        Model square = boxModel(glm::vec3{1}, glm::vec4{1});
        square.vertices.clear();
        for (const glm::vec2 corner : {glm::vec2{0, 0}, {1, 0}, {1, 1}, {0, 1}})
            square.vertices.push_back(
                {.position = {corner, 0}, .normal = {0, 0, 1}, .uv0 = {corner.x * side, 1 - corner.y}});
        square.indices = {0, 1, 2, 0, 2, 3};
        square.parts = {{0, 6, 0}};
        put(folder / "m.glb", *encodeGlb(square)); // without a normal map no tangents are written
        const ReadGltf read{folder / "m.glb"};
        ASSERT_TRUE(read.model) << read.model.error().text();
        for (const Vertex& vertex : read.model->vertices)
            EXPECT_EQ(vertex.tangent, glm::vec4(side, 0, 0, side));
    }
}

TEST(Gltf, StripsAndFansBecomeTriangles)
{
    const TemporaryFolder folder;
    // Five corners: a strip and a fan of three triangles each, all facing +Z.
    const std::string data =
        R"("buffers":[{"uri":"c.bin","byteLength":60}],"bufferViews":[{"buffer":0,"byteLength":60}],)"
        R"("accessors":[{"bufferView":0,"componentType":5126,"count":5,"type":"VEC3"}])";
    const auto write = [&](const std::vector<glm::vec3>& corners, int mode) {
        put(folder / "c.bin", {reinterpret_cast<const char*>(corners.data()), 60});
        put(folder / "m.gltf",
            kHead +
                R"("scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],"meshes":[{"primitives":[{"attributes":{"POSITION":0},"mode":)" +
                std::to_string(mode) + "}]}]," + data + "}");
        return ReadGltf{folder / "m.gltf"};
    };
    for (const ReadGltf& read : {write({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {0, 2, 0}}, 5),
                                 write({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {-1, 0, 0}}, 6)}) {
        ASSERT_TRUE(read.model) << read.model.error().text();
        EXPECT_EQ(read.model->triangles(), 3u);
        for (const Vertex& vertex : read.model->vertices)
            EXPECT_NEAR(vertex.normal.z, 1, 1e-6);
    }
}

} // namespace
} // namespace io
