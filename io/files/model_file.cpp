#include "io/files/model_file.h"

#include "io/files/atomic_file.h"
#include "io/files/gltf_mesh.h"
#include "io/files/json.h"

#include <new>

namespace io {
namespace fs = std::filesystem;
namespace {

constexpr std::uint64_t kLargestFile = std::uint64_t(1) << 30;

// The parts of the JSON that describe meshes. Buffers and images are read by our own hands, which stay in the
// project; what moves (skins, animations) is not part of a model.
std::string meshesOnly(Value json)
{
    std::erase_if(*json.asObject(), [](const Value::Member& member) {
        for (const char* key : {"buffers", "images", "animations", "skins", "cameras", "extras", "extensions"})
            if (member.first == key) return true;
        return false;
    });
    return writeJson(json);
}

bool refuseImages(tinygltf::Image*, int, std::string*, std::string*, int, int, const unsigned char*, int, void*)
{
    return false; // none is left in the JSON
}

tinygltf::Model parse(const gltf::Text& text)
{
    const std::string json = meshesOnly(text.json);
    tinygltf::TinyGLTF parser;
    parser.SetImageLoader(refuseImages, nullptr);
    parser.SetFsCallbacks({}); // no file is left in the JSON
    tinygltf::Model model;
    std::string error, warning;
    if (!parser.LoadASCIIFromString(&model, &error, &warning, json.data(), unsigned(json.size()), "")) {
        while (!error.empty() && error.back() == '\n')
            error.pop_back();
        throw gltf::Refused{"not valid glTF: " + error.substr(0, error.find('\n'))};
    }
    return model;
}

Model read(const fs::path& file, const fs::path& root, std::string_view bytes, gltf::Notes& notes)
{
    const gltf::Text text = gltf::readText(bytes, notes);
    gltf::Sources sources{text, file.parent_path(), root};
    sources.readBuffers();
    const tinygltf::Model source = parse(text);
    gltf::Accessors accessors{source, sources};
    gltf::Materials materials{source, sources, notes};
    Model model;
    model.name = file.stem().string();
    gltf::bake(source, gltf::placedMeshes(source, accessors, notes), accessors, materials, notes, model);
    if (model.parts.empty())
        throw gltf::Refused{"holds no triangles" + (notes.first().empty() ? std::string{} : ": " + notes.first())};
    return model;
}

} // namespace

Result<Model> readModel(const fs::path& file, const fs::path& root, Complaints& complaints)
{
    const Result<std::string> bytes = readFile(file, kLargestFile);
    if (!bytes) return bytes.error();
    return readModelBytes(*bytes, file, root, complaints);
}

Result<Model> readModelBytes(std::string_view bytes, const fs::path& file, const fs::path& root, Complaints& complaints)
{
    const std::string where = file.string();
    gltf::Notes notes{where, complaints};
    try {
        return read(fs::weakly_canonical(file), fs::weakly_canonical(root), bytes, notes);
    } catch (const gltf::Refused& refused) {
        return Error{where, refused.what};
    } catch (const std::bad_alloc&) {
        return Error{where, "needs more memory than there is"};
    } catch (const std::exception& error) {
        return Error{where, std::string{"cannot be read: "} + error.what()};
    }
}

} // namespace io
