#include "renderer/gl/machine.h"

#include <epoxy/gl.h>
#include <string_view>

namespace renderer::gl {

bool drawsInSoftware()
{
    static const bool result = [] {
        const auto* name = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
        const std::string_view device{name ? name : ""};
        for (const std::string_view software : {"llvmpipe", "softpipe", "SwiftShader"})
            if (device.find(software) != device.npos) return true;
        return false;
    }();
    return result;
}

} // namespace renderer::gl
