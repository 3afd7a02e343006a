#include "tests/gl/support/gl_context.h"

#include <epoxy/egl.h>

namespace test {
namespace {

EGLDisplay displayOf(EGLenum platform, void* native)
{
    const EGLDisplay display = eglGetPlatformDisplayEXT(platform, native, nullptr);
    return display != EGL_NO_DISPLAY && eglInitialize(display, nullptr, nullptr) ? display : EGL_NO_DISPLAY;
}

EGLDisplay anyDisplay()
{
    if (epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_MESA_platform_surfaceless"))
        if (const EGLDisplay display = displayOf(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY)) return display;
    EGLDeviceEXT device = nullptr;
    EGLint count = 0;
    if (epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_EXT_device_enumeration") && eglQueryDevicesEXT(1, &device, &count) && count > 0)
        return displayOf(EGL_PLATFORM_DEVICE_EXT, device);
    return EGL_NO_DISPLAY;
}

} // namespace

GlContext::GlContext()
{
    m_display = anyDisplay();
    if (!m_display) {
        m_fault = "no EGL display";
        return;
    }
    eglBindAPI(EGL_OPENGL_API);
    constexpr EGLint kAttributes[] = {EGL_CONTEXT_MAJOR_VERSION, 4, EGL_CONTEXT_MINOR_VERSION, 5,
                                      EGL_CONTEXT_OPENGL_PROFILE_MASK, EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                      EGL_CONTEXT_OPENGL_DEBUG, EGL_TRUE, EGL_NONE};
    EGLConfig config = nullptr;
    EGLint count = 0;
    constexpr EGLint kConfig[] = {EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_NONE};
    eglChooseConfig(m_display, kConfig, &config, 1, &count);
    m_context = eglCreateContext(m_display, count ? config : nullptr, EGL_NO_CONTEXT, kAttributes);
    if (!m_context || !eglMakeCurrent(m_display, EGL_NO_SURFACE, EGL_NO_SURFACE, m_context)) {
        m_fault = "no OpenGL 4.5 core context";
        m_context = nullptr;
    }
}

GlContext::~GlContext()
{
    if (!m_display) return;
    eglMakeCurrent(m_display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    if (m_context) eglDestroyContext(m_display, m_context);
    eglTerminate(m_display);
}

} // namespace test
