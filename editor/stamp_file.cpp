#include "editor/stamp_file.h"

#include "io/base/paths.h"
#include "io/files/image_file.h"

#include <algorithm>

namespace editor {

io::Result<std::shared_ptr<const io::HeightGrid>> readStamp(const std::filesystem::path& project, const std::string& file)
{
    const io::Result<std::filesystem::path> path = io::insideFolder(project, file);
    if (!path) return path.error();
    const io::Result<io::Image> image = io::readImage(*path);
    if (!image) return image.error();
    auto stamp = std::make_shared<io::HeightGrid>(io::HeightGrid{.size = image->size});
    for (int z = 0; z < image->size.y; ++z)
        for (int x = 0; x < image->size.x; ++x) {
            const std::size_t i = std::size_t(x) * std::size_t(image->channels);
            stamp->metres.push_back(image->type == io::PixelType::U8    ? float(image->row<std::uint8_t>(z)[i]) / 255
                                    : image->type == io::PixelType::U16 ? float(image->row<std::uint16_t>(z)[i]) / 65535
                                                                        : std::clamp(image->row<float>(z)[i], 0.0f, 1.0f));
        }
    return std::shared_ptr<const io::HeightGrid>{std::move(stamp)};
}

} // namespace editor
