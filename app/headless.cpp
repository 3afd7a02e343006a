#include "app/headless.h"

#include <array>
#include <epoxy/egl.h>
#include <fmt/format.h>
#include <string_view>
#include <vector>

namespace app {
namespace {

class EglContext final : public GlContext {
public:
    EglContext(EGLDisplay display, EGLContext context, std::string platform)
        : m_display{display}, m_context{context}, m_platform{std::move(platform)}
    {
    }
    ~EglContext() override
    {
        eglMakeCurrent(m_display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
        eglDestroyContext(m_display, m_context);
        eglTerminate(m_display);
    }
    EglContext(const EglContext&) = delete;
    EglContext& operator=(const EglContext&) = delete;
    std::string platform() const override { return m_platform; }
    bool makeCurrent() { return eglMakeCurrent(m_display, EGL_NO_SURFACE, EGL_NO_SURFACE, m_context); }

private:
    EGLDisplay m_display;
    EGLContext m_context;
    std::string m_platform;
};

bool contains(const char* extensions, std::string_view name)
{
    return extensions && std::string_view{extensions}.find(name) != std::string_view::npos;
}

// One way to reach a device, and what came of it.
struct Attempt {
    std::string platform;
    EGLDisplay display = EGL_NO_DISPLAY;
    bool software = false;
    std::string fault;
    std::unique_ptr<EglContext> context;
};

// Mesa marks the devices that are no hardware; other drivers have none of those.
bool isSoftwareDevice(EGLDeviceEXT device)
{
    return contains(eglQueryDeviceStringEXT(device, EGL_EXTENSIONS), "EGL_MESA_device_software");
}

bool drawsInSoftware(EGLDisplay display)
{
    if (!contains(eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS), "EGL_EXT_device_query")) return false;
    EGLAttrib device = 0;
    if (!eglQueryDisplayAttribEXT(display, EGL_DEVICE_EXT, &device)) return false;
    return isSoftwareDevice(EGLDeviceEXT(device));
}

EGLContext makeContext(EGLDisplay display)
{
    constexpr std::array<EGLint, 5> kConfig{EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_SURFACE_TYPE, 0, EGL_NONE};
    EGLConfig config = nullptr;
    EGLint count = 0;
    if (!eglChooseConfig(display, kConfig.data(), &config, 1, &count) || count == 0) config = EGL_NO_CONFIG_KHR;
    constexpr std::array<EGLint, 7> kContext{
        EGL_CONTEXT_MAJOR_VERSION,           4,       EGL_CONTEXT_MINOR_VERSION, 5, EGL_CONTEXT_OPENGL_PROFILE_MASK,
        EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT, EGL_NONE};
    return eglCreateContext(display, config, EGL_NO_CONTEXT, kContext.data());
}

void open(Attempt& attempt)
{
    if (attempt.display == EGL_NO_DISPLAY || !eglInitialize(attempt.display, nullptr, nullptr)) {
        attempt.fault = "does not start";
        return;
    }
    const EGLContext context = eglBindAPI(EGL_OPENGL_API) ? makeContext(attempt.display) : EGL_NO_CONTEXT;
    if (context == EGL_NO_CONTEXT || !eglMakeCurrent(attempt.display, EGL_NO_SURFACE, EGL_NO_SURFACE, context)) {
        attempt.fault = fmt::format("{} gives no OpenGL 4.5 core context", eglQueryString(attempt.display, EGL_VENDOR));
        if (context != EGL_NO_CONTEXT) eglDestroyContext(attempt.display, context);
        eglTerminate(attempt.display);
        return;
    }
    attempt.software = drawsInSoftware(attempt.display);
    attempt.context = std::make_unique<EglContext>(attempt.display, context, attempt.platform);
}

std::vector<Attempt> waysToDevices()
{
    std::vector<Attempt> ways;
    const char* client = eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
    if (contains(client, "EGL_MESA_platform_surfaceless"))
        ways.push_back(
            {"EGL surfaceless", eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr)});
    if (!contains(client, "EGL_EXT_platform_device") || !contains(client, "EGL_EXT_device_enumeration")) return ways;
    std::array<EGLDeviceEXT, 32> devices{};
    EGLint count = 0;
    if (!eglQueryDevicesEXT(EGLint(devices.size()), devices.data(), &count)) return ways;
    for (EGLint i = 0; i < count; ++i)
        ways.push_back({fmt::format("EGL device {}", i),
                        eglGetPlatformDisplayEXT(EGL_PLATFORM_DEVICE_EXT, devices[std::size_t(i)], nullptr),
                        isSoftwareDevice(devices[std::size_t(i)])});
    return ways;
}

} // namespace

// The first that works, but hardware before software: a server with Mesa installed beside its GPU's driver answers
// the surfaceless platform in software.
io::Result<std::unique_ptr<GlContext>> makeHeadless()
{
    std::unique_ptr<EglContext> fallback;
    std::string faults;
    for (Attempt& way : waysToDevices()) {
        if (way.software && fallback) continue;
        open(way);
        if (way.context && !way.software) return std::unique_ptr<GlContext>{std::move(way.context)};
        if (way.context && !fallback) fallback = std::move(way.context);
        if (!way.fault.empty()) faults += fmt::format("; {}: {}", way.platform, way.fault);
    }
    if (!fallback || !fallback->makeCurrent())
        return io::Error{"OpenGL",
                         fmt::format("a device with OpenGL 4.5 core is needed and EGL has none{}; install its "
                                     "driver, or Mesa (libgl1-mesa-dri, libegl-mesa0)",
                                     faults.empty() ? "; no platform without a display is known here" : faults)};
    return std::unique_ptr<GlContext>{std::move(fallback)};
}

} // namespace app
