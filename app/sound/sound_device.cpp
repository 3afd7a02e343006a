#include "app/sound/sound_device.h"

#include <AL/al.h>
#include <AL/alc.h>
#include <AL/alext.h>
#include <cstdlib>
#include <dlfcn.h>
#include <string_view>

namespace app {
namespace {

void saysNothing(const char*, int, const char*, int, const char*, ...) {}

// On a machine without sound OpenAL and ALSA print a dozen lines of their own; ours is the one notice.
void keepLibrariesQuiet()
{
    setenv("ALSOFT_LOGLEVEL", "0", 0);
    using Handler = void (*)(const char*, int, const char*, int, const char*, ...);
    if (void* const alsa = dlopen("libasound.so.2", RTLD_LAZY))
        if (void* const set = dlsym(alsa, "snd_lib_error_set_handler"))
            reinterpret_cast<int (*)(Handler)>(set)(saysNothing);
}

} // namespace

void SoundDevice::Close::operator()(ALCdevice_struct* device) const
{
    alcCloseDevice(device);
}

void SoundDevice::Close::operator()(ALCcontext_struct* context) const
{
    if (alcGetCurrentContext() == context) alcMakeContextCurrent(nullptr);
    alcDestroyContext(context);
}

io::Result<SoundDevice> SoundDevice::withContext(ALCdevice_struct* device, const int* attributes)
{
    SoundDevice result;
    result.m_device.reset(device);
    result.m_context.reset(alcCreateContext(device, attributes));
    if (!result.m_context) return io::Error{"sound", "the sound device could not be set up; it is quiet"};
    result.use();
    alDistanceModel(AL_NONE); // levels are ours
    return result;
}

io::Result<SoundDevice> SoundDevice::open(const std::string& name)
{
    keepLibrariesQuiet();
    ALCdevice* const device = alcOpenDevice(name.empty() ? nullptr : name.c_str());
    if (!device) return io::Error{"sound", name.empty() ? "there is no sound device; it is quiet" : "there is no sound device \"" + name + "\"; it is quiet"};
    // What OpenAL offers where nothing else is: it plays into the void.
    const char* const opened = alcGetString(device, ALC_DEVICE_SPECIFIER);
    if (name.empty() && opened && std::string_view{opened} == "No Output") {
        alcCloseDevice(device);
        return io::Error{"sound", "there is no sound device; it is quiet"};
    }
    return withContext(device, nullptr);
}

io::Result<SoundDevice> SoundDevice::loopback(int rate)
{
    keepLibrariesQuiet();
    const auto open = LPALCLOOPBACKOPENDEVICESOFT(alcGetProcAddress(nullptr, "alcLoopbackOpenDeviceSOFT"));
    ALCdevice* const device = open ? open(nullptr) : nullptr;
    if (!device) return io::Error{"sound", "this OpenAL has no loopback device"};
    const ALCint attributes[] = {ALC_FORMAT_CHANNELS_SOFT, ALC_STEREO_SOFT, ALC_FORMAT_TYPE_SOFT, ALC_FLOAT_SOFT, ALC_FREQUENCY, rate, ALC_HRTF_SOFT, ALC_FALSE, 0};
    return withContext(device, attributes);
}

void SoundDevice::use() const
{
    if (alcGetCurrentContext() != m_context.get()) alcMakeContextCurrent(m_context.get());
}

bool SoundDevice::connected() const
{
    if (!alcIsExtensionPresent(m_device.get(), "ALC_EXT_disconnect")) return true;
    ALCint there = 1;
    alcGetIntegerv(m_device.get(), ALC_CONNECTED, 1, &there);
    return there != 0;
}

void SoundDevice::render(std::span<float> stereo) const
{
    static const auto samples = LPALCRENDERSAMPLESSOFT(alcGetProcAddress(m_device.get(), "alcRenderSamplesSOFT"));
    if (samples) samples(m_device.get(), stereo.data(), ALCsizei(stereo.size() / 2));
}

} // namespace app
