#include "projects/make/models.h"

#include "io/base/contract.h"

#include <string>

namespace make {

const Entry& entryOf(std::string_view name)
{
    for (const std::span<const Entry> entries : {valleyEntries(), forestEntries()})
        for (const Entry& entry : entries)
            if (entry.name == name) return entry;
    EXPECTS(!"a name of the catalogue");
    return valleyEntries().front();
}

io::Model buildModel(std::string_view name, Textures& textures)
{
    return modelOf(entryOf(name).build(), std::string{name}, textures);
}

io::Template templateOf(const Entry& entry)
{
    io::Template result = entry.look;
    result.name = entry.name;
    result.category = entry.category;
    result.model = "models/" + std::string{entry.name} + ".glb";
    return result;
}

} // namespace make
