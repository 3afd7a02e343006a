#include "projects/make/sounds.h"

#include "io/files/atomic_file.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <sndfile.h>

namespace make {
namespace {

struct Memory {
    std::string bytes;
    std::size_t at = 0;
};

SF_VIRTUAL_IO memoryFile()
{
    return {.get_filelen = [](void* user) { return sf_count_t(static_cast<Memory*>(user)->bytes.size()); },
            .seek =
                [](sf_count_t offset, int from, void* user) {
                    auto& memory = *static_cast<Memory*>(user);
                    const std::size_t base = from == SEEK_SET ? 0 : from == SEEK_CUR ? memory.at : memory.bytes.size();
                    memory.at = base + std::size_t(offset);
                    return sf_count_t(memory.at);
                },
            .read = [](void*, sf_count_t, void*) { return sf_count_t{0}; },
            .write =
                [](const void* data, sf_count_t count, void* user) {
                    auto& memory = *static_cast<Memory*>(user);
                    memory.bytes.resize(std::max(memory.bytes.size(), memory.at + std::size_t(count)));
                    std::memcpy(memory.bytes.data() + memory.at, data, std::size_t(count));
                    memory.at += std::size_t(count);
                    return count;
                },
            .tell = [](void* user) { return sf_count_t(static_cast<Memory*>(user)->at); }};
}

// Ogg's checksum: a CRC of 32 bits by 0x04c11db7, neither reflected nor inverted.
std::uint32_t oggChecksum(std::string_view page)
{
    std::uint32_t crc = 0;
    for (const char c : page) {
        crc ^= std::uint32_t(std::uint8_t(c)) << 24;
        for (int bit = 0; bit < 8; ++bit)
            crc = (crc << 1) ^ (crc & 0x80000000u ? 0x04c11db7u : 0);
    }
    return crc;
}

void putLittle(std::string& bytes, std::size_t at, std::uint32_t value)
{
    for (int i = 0; i < 4; ++i)
        bytes[at + std::size_t(i)] = char(value >> (8 * i));
}

// The library draws each stream's number from the clock. With another in its place files are the same bytes again.
void settleStreamNumber(std::string& ogg)
{
    for (std::size_t page = 0; page + 27 <= ogg.size() && ogg.compare(page, 4, "OggS") == 0;) {
        const std::size_t segments = std::uint8_t(ogg[page + 26]);
        std::size_t size = 27 + segments;
        for (std::size_t i = 0; i < segments; ++i)
            size += std::uint8_t(ogg[page + 27 + i]);
        putLittle(ogg, page + 14, 1);
        putLittle(ogg, page + 22, 0);
        putLittle(ogg, page + 22, oggChecksum(std::string_view{ogg}.substr(page, size)));
        page += size;
    }
}

} // namespace

std::span<const SoundPlan> soundPlans()
{
    static constexpr SoundPlan kPlans[] = {
        {.name = "wind", .make = makeWindSound, .quality = 0},
        {.name = "birds", .make = makeBirdsSound, .quality = 0.1},
        {.name = "stream", .make = makeStreamSound, .quality = 0.05},
        {.name = "fire", .make = makeFireSound, .quality = 0},
        {.name = "steps_grass", .make = makeGrassSteps, .repeats = false, .quality = 0.05},
        {.name = "steps_gravel", .make = makeGravelSteps, .repeats = false, .quality = 0.05},
        {.name = "steps_sand", .make = makeSandSteps, .repeats = false, .quality = 0.05},
        {.name = "steps_snow", .make = makeSnowSteps, .repeats = false, .quality = 0.05},
        {.name = "steps_wood", .make = makeWoodSteps, .repeats = false, .quality = 0.05},
    };
    return kPlans;
}

io::Result<std::string> encodeOgg(const Wave& wave, double quality)
{
    Memory memory;
    SF_VIRTUAL_IO file = memoryFile();
    SF_INFO info{.samplerate = wave.rate, .channels = 1, .format = SF_FORMAT_OGG | SF_FORMAT_VORBIS};
    SNDFILE* const out = sf_open_virtual(&file, SFM_WRITE, &info, &memory);
    if (!out) return io::Error{"sound", std::string{"cannot be encoded: "} + sf_strerror(nullptr)};
    sf_command(out, SFC_SET_VBR_ENCODING_QUALITY, &quality, sizeof quality);
    // In pieces: the library's encoder keeps what it is handed at once on its stack.
    sf_count_t written = 0;
    for (std::size_t i = 0; i < wave.samples.size(); i += 4096)
        written += sf_writef_float(out, wave.samples.data() + i, sf_count_t(std::min<std::size_t>(4096, wave.samples.size() - i)));
    sf_close(out);
    if (written != sf_count_t(wave.samples.size())) return io::Error{"sound", "cannot be encoded whole"};
    settleStreamNumber(memory.bytes);
    return std::move(memory.bytes);
}

io::Status writeSounds(const std::filesystem::path& project)
{
    std::error_code fault;
    std::filesystem::create_directories(project / "sounds", fault);
    for (const SoundPlan& plan : soundPlans()) {
        const io::Result<std::string> bytes = encodeOgg(plan.make(), plan.quality);
        if (!bytes) return bytes.error();
        if (io::Status written = io::writeFile(project / "sounds" / (std::string{plan.name} + ".ogg"), *bytes); !written) return written;
    }
    return {};
}

} // namespace make
