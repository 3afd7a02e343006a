#include "io/files/gltf_text.h"

#include "io/files/json.h"
#include "io/files/text.h"
#include "io/scene/field_words.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

namespace io::gltf {
namespace {

constexpr int kMostNotes = 50;
constexpr std::size_t kMostNodes = 250'000;
constexpr std::size_t kMostOthers = 1'000'000; // accessors, meshes, materials …
constexpr std::size_t kLargestJson = std::size_t(64) << 20;

constexpr std::array<std::string_view, 4> kSupported = {"KHR_texture_transform", "KHR_materials_unlit",
                                                        "EXT_mesh_gpu_instancing", "KHR_mesh_quantization"};

std::uint32_t word(std::string_view bytes, std::size_t at)
{
    std::uint32_t value = 0; // the format and the machines that Wold runs on are little-endian
    std::memcpy(&value, bytes.data() + at, sizeof value);
    return value;
}

struct Chunks {
    std::string_view json;
    std::string_view binary;
};

// Header: magic, version, length of all. Then chunks: length, type, data.
Chunks splitGlb(std::string_view bytes)
{
    constexpr std::uint32_t kJson = 0x4E4F534A;
    constexpr std::uint32_t kBinary = 0x004E4942;
    if (bytes.size() < 20) throw Refused{"a GLB that ends inside its header"};
    if (word(bytes, 4) != 2) throw Refused{"GLB version " + std::to_string(word(bytes, 4)) + "; only 2 is known"};
    const std::size_t total = word(bytes, 8);
    if (total < 20 || total > bytes.size()) throw Refused{"a GLB that is cut off, or lies about its length"};

    Chunks chunks;
    std::size_t at = 12;
    for (int number = 0; at + 8 <= total; ++number) {
        const std::size_t size = word(bytes, at);
        const std::uint32_t type = word(bytes, at + 4);
        if (size > total - at - 8) throw Refused{"a GLB whose chunk reaches past its end"};
        const std::string_view data = bytes.substr(at + 8, size);
        if ((number == 0) != (type == kJson)) throw Refused{"a GLB that does not begin with its one JSON chunk"};
        if (type == kJson) chunks.json = data;
        if (type == kBinary && !chunks.binary.empty()) throw Refused{"a GLB with two BIN chunks"};
        if (type == kBinary) chunks.binary = data;
        at += 8 + size;
    }
    return chunks;
}

Value parse(std::string_view json, Notes& notes)
{
    if (json.size() > kLargestJson) throw Refused{"its JSON is over 64 MiB"};
    if (json.find('\0') != std::string_view::npos) throw Refused{"not glTF: the text holds a zero byte"};
    const std::string repaired = repairedUtf8(json);
    if (repaired != json) notes.warn("names that are not UTF-8 were mended");
    Result<Value> value = parseJson(repaired, "JSON");
    if (!value) {
        value = parseJson(repaired, "JSON", Duplicates::KeepFirst);
        if (value) notes.warn("a key appears twice; the first is taken");
    }
    if (!value) throw Refused{value.error().text()};
    if (!value->asObject()) throw Refused{"not glTF: the file must hold one JSON object"};
    return std::move(*value);
}

void checkVersion(const Value& json)
{
    const Value* asset = json.find("asset");
    const Value* version = asset ? asset->find("version") : nullptr;
    if (!version || !version->asString()) throw Refused{"not glTF: asset.version is missing"};
    if (!version->asString()->starts_with("2."))
        throw Refused{"glTF version " + *version->asString() + "; only 2.0 is known: export it again as glTF 2.0"};
}

void checkExtensions(const Value& json)
{
    const Value* required = json.find("extensionsRequired");
    if (!required) return;
    if (!required->asArray()) throw Refused{"extensionsRequired: must be a list"};
    std::string missing;
    for (const Value& name : *required->asArray()) {
        if (!name.asString()) throw Refused{"extensionsRequired: must be a list of names"};
        if (std::find(kSupported.begin(), kSupported.end(), *name.asString()) != kSupported.end()) continue;
        missing += (missing.empty() ? "" : ", ") + *name.asString();
    }
    if (!missing.empty()) throw Refused{"needs " + missing + ", which Wold does not support; export it without"};
}

// Some writers compress without saying that it is required, and leave accessors without data.
void checkCompression(const Value& json)
{
    const Value* used = json.find("extensionsUsed");
    const Value* accessors = json.find("accessors");
    if (!used || !used->asArray() || !accessors || !accessors->asArray()) return;
    const bool empty =
        std::any_of(accessors->asArray()->begin(), accessors->asArray()->end(),
                    [](const Value& accessor) { return !accessor.find("bufferView") && !accessor.find("sparse"); });
    for (const Value& name : *used->asArray())
        if (empty && name == Value{"KHR_draco_mesh_compression"})
            throw Refused{"needs KHR_draco_mesh_compression, which Wold does not support; export it without"};
}

// Sizes and places that are no whole numbers, negative or huge would wrap when they are made into integers.
void checkSizes(const Value& value, const std::string& place)
{
    constexpr std::array<std::string_view, 7> kSizes = {"count",      "byteOffset", "byteLength",   "byteStride",
                                                        "bufferView", "buffer",     "componentType"};
    if (!value.asObject()) return;
    for (const auto& [key, member] : *value.asObject()) {
        const std::string inside = place + "." + key;
        if (std::find(kSizes.begin(), kSizes.end(), key) != kSizes.end()) {
            const double* number = member.asNumber();
            if (!number || *number < 0 || *number > 2147483647.0 || *number != std::floor(*number))
                throw Refused{inside + ": " + (number ? numberText(*number) + " is" : "this is") + " no possible size"};
        } else if (key == "sparse" || key == "indices" || key == "values") {
            checkSizes(member, inside);
        }
    }
}

void checkList(const Value& json, const char* name, std::size_t most, bool sizes)
{
    const Value* list = json.find(name);
    if (!list) return;
    if (!list->asArray()) throw Refused{std::string{name} + ": must be a list"};
    if (list->asArray()->size() > most)
        throw Refused{std::string{name} + ": " + std::to_string(list->asArray()->size()) + " are too many; at most " +
                      std::to_string(most)};
    for (std::size_t i = 0; i < list->asArray()->size(); ++i) {
        const std::string place = name + ("[" + std::to_string(i)) + "]";
        if (!(*list->asArray())[i].asObject()) throw Refused{place + ": must be an object"};
        if (sizes) checkSizes((*list->asArray())[i], place);
    }
}

} // namespace

void Notes::warn(std::string what)
{
    if (m_first.empty()) m_first = what;
    ++m_count;
    if (m_count <= kMostNotes) m_complaints.push_back({Severity::Warning, m_where, std::move(what)});
    if (m_count == kMostNotes) m_complaints.push_back({Severity::Warning, m_where, "further warnings are left out"});
}

Text readText(std::string_view bytes, Notes& notes)
{
    const Chunks chunks = bytes.starts_with("glTF") ? splitGlb(bytes) : Chunks{bytes, {}};
    Text text{parse(chunks.json, notes), chunks.binary};
    checkVersion(text.json);
    checkExtensions(text.json);
    checkCompression(text.json);
    for (const char* list : {"accessors", "bufferViews", "buffers"})
        checkList(text.json, list, kMostOthers, true);
    for (const char* list : {"meshes", "materials", "textures", "images", "samplers", "scenes"})
        checkList(text.json, list, kMostOthers, false);
    checkList(text.json, "nodes", kMostNodes, false);
    return text;
}

} // namespace io::gltf
