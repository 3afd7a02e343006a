#include "io/files/picture_module.h"

#include "io/base/paths.h"

#include <dlfcn.h>

namespace io {
namespace {

Result<PictureModule> load()
{
    const std::string file = programModule("wold_pictures.so").string();
    void* const module = dlopen(file.c_str(), RTLD_LAZY | RTLD_LOCAL);
    void* const entry = module ? dlsym(module, "woldPictures") : nullptr;
    if (!entry) {
        const char* why = dlerror();
        return Error{file, std::string{"what reads and writes TIFF, EXR, HDR and DDS cannot be loaded: "} +
                               (why ? why : "it is damaged") + "; install Wold again"};
    }
    return reinterpret_cast<PictureModule (*)()>(entry)();
}

} // namespace

Result<PictureModule> pictureModule()
{
    static const Result<PictureModule> loaded = load();
    return loaded;
}

} // namespace io
