#include "io/files/gltf_sources.h"

#include "io/base/paths.h"
#include "io/files/atomic_file.h"
#include "io/files/shared_images.h"

#include <algorithm>
#include <charconv>

namespace io::gltf {
namespace fs = std::filesystem;
namespace {

constexpr std::uint64_t kLargestFile = std::uint64_t(1) << 30;
constexpr std::uint64_t kLargestBuffers = std::uint64_t(2) << 30; // all together

int sixBits(char c)
{
    if (c >= 'A' && c <= 'Z') return c - 'A';
    if (c >= 'a' && c <= 'z') return c - 'a' + 26;
    if (c >= '0' && c <= '9') return c - '0' + 52;
    return c == '+' ? 62 : c == '/' ? 63 : -1;
}

Result<std::string> decodedBase64(std::string_view text)
{
    while (text.ends_with('='))
        text.remove_suffix(1);
    std::string bytes;
    bytes.reserve(text.size() * 3 / 4);
    std::uint32_t bits = 0;
    int count = 0;
    for (const char c : text) {
        const int six = sixBits(c);
        if (six < 0) return Error{"data URI", "is not base64"};
        bits = bits << 6 | std::uint32_t(six);
        count += 6;
        if (count < 8) continue;
        count -= 8;
        bytes += char(bits >> count & 0xFF);
    }
    return bytes;
}

std::string shortened(const std::string& uri)
{
    std::string shown = uri.size() <= 80 ? uri : uri.substr(0, 77) + "...";
    std::replace_if(
        shown.begin(), shown.end(), [](char c) { return static_cast<unsigned char>(c) < 0x20; }, '?');
    return shown;
}

bool hasScheme(std::string_view uri)
{
    const std::size_t colon = uri.find(':');
    return colon != std::string_view::npos && uri.find('/') > colon;
}

const Value::Array& list(const Value& json, const char* name)
{
    static const Value::Array none;
    const Value* found = json.find(name);
    return found && found->asArray() ? *found->asArray() : none;
}

double numberOf(const Value& object, const char* key, double fallback)
{
    const Value* found = object.find(key);
    return found && found->asNumber() ? *found->asNumber() : fallback;
}

} // namespace

std::string percentDecoded(std::string_view uri)
{
    std::string decoded;
    for (std::size_t i = 0; i < uri.size(); ++i) {
        unsigned byte = 0;
        const char* digits = uri.data() + i + 1;
        if (uri[i] == '%' && i + 2 < uri.size() && std::from_chars(digits, digits + 2, byte, 16).ptr == digits + 2) {
            decoded += char(byte);
            i += 2;
        } else {
            decoded += uri[i];
        }
    }
    return decoded;
}

Result<std::string> decodedDataUri(std::string_view uri)
{
    const std::size_t comma = uri.find(',');
    if (comma == std::string_view::npos) return Error{"data URI", "holds no data"};
    const std::string_view data = uri.substr(comma + 1);
    if (uri.substr(0, comma).ends_with(";base64")) return decodedBase64(data);
    return percentDecoded(data);
}

Sources::Sources(const Text& text, fs::path folder, fs::path root)
    : m_text{text}, m_folder{std::move(folder)}, m_root{std::move(root)}
{
}

// A URI is relative to the model, and may climb out of the model's folder as long as it stays in the project.
Result<std::string> Sources::read(const std::string& uri, std::uint64_t limit) const
{
    if (uri.starts_with("data:")) return decodedDataUri(uri);
    const std::string name = percentDecoded(uri);
    if (hasScheme(name)) return Error{shortened(uri), "is not a file of the project; put the file beside the model"};
    if (name.empty() || fs::path{name}.is_absolute() || name.find('\0') != std::string::npos)
        return Error{shortened(uri), "leads out of the project; put the file beside the model"};
    const fs::path relative = (m_folder.lexically_relative(m_root) / name).lexically_normal();
    const Result<fs::path> path = insideFolder(m_root, relative.string());
    if (!path) return Error{shortened(uri), "leads out of the project; put the file beside the model"};
    return readFile(*path, limit);
}

void Sources::readBuffers()
{
    const Value::Array& buffers = list(m_text.json, "buffers");
    m_owned.reserve(buffers.size()); // the views below point into it
    std::uint64_t total = 0;
    for (std::size_t i = 0; i < buffers.size(); ++i) {
        const std::string place = "buffers[" + std::to_string(i) + "]: ";
        const auto size = std::uint64_t(numberOf(buffers[i], "byteLength", 0));
        const Value* uri = buffers[i].find("uri");
        if (size == 0) throw Refused{place + "byteLength is missing"};
        if (uri && !uri->asString()) throw Refused{place + "uri must be a text"};
        if (!uri && (i > 0 || m_text.binary.empty())) throw Refused{place + "names no data"};
        std::string_view bytes = m_text.binary;
        if (uri) {
            Result<std::string> read = this->read(*uri->asString(), kLargestFile);
            if (!read) throw Refused{place + read.error().text()};
            bytes = m_owned.emplace_back(std::move(*read));
        }
        if (bytes.size() < size)
            throw Refused{place + "holds " + std::to_string(bytes.size()) + " bytes where " + std::to_string(size) +
                          " were promised"};
        total += bytes.size();
        if (total > kLargestBuffers) throw Refused{"its buffers are over 2 GiB"};
        m_buffers.push_back(bytes.substr(0, size));
    }
}

std::size_t Sources::imageCount() const
{
    return list(m_text.json, "images").size();
}

Result<std::string> Sources::bytesOfView(double view) const
{
    const Value::Array& views = list(m_text.json, "bufferViews");
    const Error outside{"bufferView", "reaches past the data"};
    if (!(view >= 0 && view < double(views.size()))) return outside;
    const Value& found = views[std::size_t(view)];
    const double buffer = numberOf(found, "buffer", -1);
    const double offset = numberOf(found, "byteOffset", 0);
    const double length = numberOf(found, "byteLength", 0);
    if (!(buffer >= 0 && buffer < double(m_buffers.size()))) return outside;
    const std::string_view bytes = m_buffers[std::size_t(buffer)];
    if (offset + length > double(bytes.size())) return outside; // both were checked to be small whole numbers
    return std::string{bytes.substr(std::size_t(offset), std::size_t(length))};
}

Result<std::shared_ptr<const Image>> Sources::readImage(std::size_t index) const
{
    const Value& image = list(m_text.json, "images")[index];
    const std::string where = "image " + std::to_string(index);
    const Value* uri = image.find("uri");
    const Value* view = image.find("bufferView");
    if (uri && !uri->asString()) return Error{where, "uri must be a text"};
    if (!uri && !(view && view->asNumber())) return Error{where, "names no data"};
    const Result<std::string> bytes = uri ? read(*uri->asString(), kLargestFile) : bytesOfView(*view->asNumber());
    if (!bytes) return Error{where, bytes.error().text()};
    return decodeShared(*bytes, uri && !uri->asString()->starts_with("data:") ? shortened(*uri->asString()) : where);
}

} // namespace io::gltf
