#include "editor/memory.h"

#include "editor/document.h"

#include <memory>
#include <set>

namespace editor {
namespace {

constexpr std::uint64_t kIndexed = 40; // bytes that finding an object by its id takes

std::uint64_t bytesOf(const auto& values)
{
    return std::size(values) * sizeof(*std::data(values));
}

class Counted { // what several share counts once
public:
    void add(const std::shared_ptr<const io::Image>& image)
    {
        if (image && m_known.insert(image.get()).second) memory.pictures += bytesOf(image->bytes);
    }
    void add(const std::shared_ptr<const io::Model>& model)
    {
        if (!model || !m_known.insert(model.get()).second) return;
        memory.geometry += bytesOf(model->vertices) + bytesOf(model->indices);
        for (const io::Level& level : model->levels)
            memory.geometry += bytesOf(level.indices);
        for (const auto& image : model->images)
            add(image);
    }

    WorldMemory memory;

private:
    std::set<const void*> m_known;
};

} // namespace

WorldMemory memoryOf(const Document& document)
{
    Counted counted;
    for (const auto& model : document.assets().models)
        counted.add(model);
    for (const io::LayerImages& layer : document.assets().layers) {
        for (const auto& image : {layer.colour, layer.normal, layer.roughness, layer.height})
            counted.add(image);
    }
    const auto objects = document.scene().objects();
    counted.memory.objects = bytesOf(objects) + objects.size() * kIndexed;
    if (document.scene().heights()) counted.memory.heights = document.scene().heights()->field().bytes();
    return counted.memory;
}

} // namespace editor
