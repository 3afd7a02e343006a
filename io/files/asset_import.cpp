#include "io/files/asset_import.h"

#include "io/files/atomic_file.h"
#include "io/files/file_names.h"
#include "io/files/image_bytes.h"
#include "io/files/image_file.h"
#include "io/files/model_file.h"
#include "io/files/raw_heights.h"

namespace io {
namespace fs = std::filesystem;
namespace {

using namespace std::string_view_literals;

constexpr const char* kFolders[] = {"terrain/", "models/", "textures/", "sounds/"};

bool isSound(std::string_view bytes)
{
    return bytes.starts_with("OggS"sv) || bytes.starts_with("fLaC"sv) || (bytes.starts_with("RIFF"sv) && bytes.substr(0, 12).ends_with("WAVE"sv));
}

// As it stands where that is enough; packed with what it names where it is not.
Result<std::string> modelBytes(const fs::path& file, std::string bytes, const fs::path& project, Complaints& complaints)
{
    Complaints here, there;
    const fs::path folder = file.has_parent_path() ? file.parent_path() : fs::path{"."};
    const Result<Model> model = readModelBytes(bytes, file, folder, here);
    if (!model) return model.error();
    complaints.insert(complaints.end(), here.begin(), here.end());
    const bool whole = lowerExtension(file) == ".glb" && readModelBytes(bytes, project / "models" / file.filename(), project, there) && there.size() == here.size();
    if (whole) return bytes;
    Result<std::string> packed = encodeGlb(*model);
    if (!packed) return Error{file.string(), packed.error().what};
    return packed;
}

} // namespace

Result<AssetKind> assetKind(const fs::path& file)
{
    const std::string extension = lowerExtension(file);
    if (holdsRawSamples(file)) return AssetKind::HeightMap;
    if (extension == ".glb" || extension == ".gltf") return AssetKind::Model;
    if (extension == ".wav" || extension == ".ogg" || extension == ".flac") return AssetKind::Sound;
    const Result<std::string> bytes = readFile(file);
    if (!bytes) return bytes.error();
    if (imageFormat(*bytes).empty())
        return Error{file.string(), "is no height map, model (.glb, .gltf), picture or sound (.wav, .ogg, .flac) that Wold reads; bare samples of heights are named "
                                    ".raw, .r16, .r32, .bil, .flt or .hgt"};
    const Result<Image> image = decodeImage(*bytes, file.string(), kGroundLimits);
    if (!image) return image.error();
    return image->channels == 1 && image->type != PixelType::U8 ? AssetKind::HeightMap : AssetKind::Texture;
}

Result<CheckedAsset> checkAsset(const fs::path& file, AssetKind kind, const fs::path& project, Complaints& complaints)
{
    Result<std::string> bytes = readFile(file);
    if (!bytes) return bytes.error();
    std::string extension = lowerExtension(file);
    if (kind == AssetKind::Model) {
        bytes = modelBytes(file, *std::move(bytes), project, complaints);
        if (!bytes) return bytes.error();
        extension = ".glb";
    } else if (kind == AssetKind::Texture) {
        if (const Result<Image> image = decodeImage(*bytes, file.string()); !image) return image.error();
    } else if (kind == AssetKind::Sound && !isSound(*bytes))
        return Error{file.string(), "is no WAV, OGG or FLAC file; convert it"};
    CheckedAsset asset{.target = kFolders[std::size_t(kind)] + file.stem().string() + extension, .bytes = *std::move(bytes)};
    std::error_code fault;
    if (fs::exists(project / asset.target, fault)) {
        const Result<std::string> old = readFile(project / asset.target);
        asset.there = old && *old == asset.bytes;
        if (!asset.there) asset.target = freshFile(project, asset.target, extension);
    }
    return asset;
}

} // namespace io
