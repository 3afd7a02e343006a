#include "io/files/shared_images.h"

#include "io/base/content_hash.h"
#include "io/files/image_file.h"

#include <map>
#include <mutex>

namespace io {
namespace {

struct Entry {
    std::mutex decoding;
    std::weak_ptr<const Image> image;
};

class Entries {
public:
    std::shared_ptr<Entry> of(std::string_view bytes)
    {
        const std::pair key{contentKey(bytes), bytes.size()};
        const std::lock_guard lock{m_mutex};
        if (const auto known = m_entries.find(key); known != m_entries.end()) return known->second;
        std::erase_if(m_entries, [](const auto& item) { return item.second.use_count() == 1 && item.second->image.expired(); });
        return m_entries.emplace(key, std::make_shared<Entry>()).first->second;
    }

private:
    std::mutex m_mutex;
    std::map<std::pair<ContentKey, std::size_t>, std::shared_ptr<Entry>> m_entries;
};

} // namespace

Result<std::shared_ptr<const Image>> decodeShared(std::string_view bytes, const std::string& where)
{
    static Entries entries;
    const std::shared_ptr<Entry> entry = entries.of(bytes);
    const std::lock_guard lock{entry->decoding};

    if (std::shared_ptr<const Image> known = entry->image.lock()) return known;
    Result<Image> image = decodeImage(bytes, where);
    if (!image) return image.error();
    const auto shared = std::make_shared<const Image>(std::move(*image));
    entry->image = shared;
    return shared;
}

} // namespace io
