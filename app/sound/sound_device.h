// Where sound goes: a device of the machine, or with loopback memory, for tests.
#pragma once

#include "io/base/result.h"

#include <memory>
#include <span>
#include <string>

struct ALCdevice_struct;
struct ALCcontext_struct;

namespace app {

class SoundDevice {
public:
    static io::Result<SoundDevice> open(const std::string& name); // as OpenAL lists it; empty: the machine's own choice
    static io::Result<SoundDevice> loopback(int rate);            // Hz; stereo floats

    void use() const;       // what follows is said to it
    bool connected() const; // false once it was unplugged or its server went
    void render(std::span<float> stereo) const; // of loopback: the next frames

private:
    struct Close {
        void operator()(ALCdevice_struct* device) const;
        void operator()(ALCcontext_struct* context) const;
    };
    SoundDevice() = default;
    static io::Result<SoundDevice> withContext(ALCdevice_struct* device, const int* attributes);

    std::unique_ptr<ALCdevice_struct, Close> m_device;
    std::unique_ptr<ALCcontext_struct, Close> m_context; // goes before its device
};

} // namespace app
