#include "renderer/device.h"

#include <epoxy/gl.h>

namespace renderer {
namespace {

std::string textOf(GLenum name)
{
    const auto* text = reinterpret_cast<const char*>(glGetString(name));
    return text ? text : "";
}

struct Limit {
    const char* name;
    GLenum key;
};
constexpr Limit kLimits[] = {{"max_texture_size", GL_MAX_TEXTURE_SIZE},
                             {"max_array_texture_layers", GL_MAX_ARRAY_TEXTURE_LAYERS},
                             {"max_shader_storage_block_size", GL_MAX_SHADER_STORAGE_BLOCK_SIZE},
                             {"max_uniform_block_size", GL_MAX_UNIFORM_BLOCK_SIZE},
                             {"max_combined_texture_image_units", GL_MAX_COMBINED_TEXTURE_IMAGE_UNITS},
                             {"max_draw_buffers", GL_MAX_DRAW_BUFFERS},
                             {"max_tess_gen_level", GL_MAX_TESS_GEN_LEVEL},
                             {"max_compute_work_group_invocations", GL_MAX_COMPUTE_WORK_GROUP_INVOCATIONS}};
constexpr const char* kExtensions[] = {"GL_ARB_indirect_parameters", "GL_ARB_shader_draw_parameters",
                                       "GL_ARB_shader_viewport_layer_array", "GL_ARB_texture_filter_minmax",
                                       "GL_EXT_texture_filter_anisotropic"};

} // namespace

Device describeDevice()
{
    Device device{
        textOf(GL_VENDOR), textOf(GL_RENDERER), textOf(GL_VERSION), textOf(GL_SHADING_LANGUAGE_VERSION), {}, {}};
    for (const Limit& limit : kLimits) {
        GLint64 value = 0;
        glGetInteger64v(limit.key, &value);
        device.limits.emplace_back(limit.name, double(value));
    }
    for (const char* extension : kExtensions)
        if (epoxy_has_gl_extension(extension)) device.extensions.emplace_back(extension);
    return device;
}

void waitForDevice()
{
    glFinish();
}

} // namespace renderer
