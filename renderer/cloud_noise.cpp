#include "renderer/cloud_noise.h"

#include "renderer/shaders/shared/bindings.h"
#include "renderer/shaders/shared/clouds.h"

#include <algorithm>
#include <array>
#include <bit>
#include <vector>

namespace renderer {
namespace {

constexpr int kChannels = 2;

// Each texel the mean of the up to eight that it covers.
std::vector<std::uint8_t> halved(const std::vector<std::uint8_t>& texels, const glm::ivec3& size, const glm::ivec3& half)
{
    const glm::ivec3 step = size / half;
    const int count = step.x * step.y * step.z;
    std::vector<std::uint8_t> result;
    result.reserve(std::size_t(half.x) * half.y * half.z * kChannels);
    for (int z = 0; z < half.z; ++z)
        for (int y = 0; y < half.y; ++y)
            for (int x = 0; x < half.x; ++x)
                for (int channel = 0; channel < kChannels; ++channel) {
                    int sum = count / 2;
                    for (int i = 0; i < count; ++i) {
                        const glm::ivec3 at = glm::ivec3{x, y, z} * step + glm::ivec3{i % step.x, i / step.x % step.y, i / (step.x * step.y)};
                        sum += texels[((std::size_t(at.z) * size.y + at.y) * size.x + at.x) * kChannels + channel];
                    }
                    result.push_back(std::uint8_t(sum / count));
                }
    return result;
}

void make(GpuFrame& gpu, const gl::Program& program, const gl::VolumeTexture& texture)
{
    if (!gpu.use(program)) return;
    const glm::ivec3 size = texture.size();
    texture.bindImage(0);
    glDispatchCompute(GLuint(size.x / 8), GLuint(size.y / 8), GLuint(size.z));
    glMemoryBarrier(GL_TEXTURE_UPDATE_BARRIER_BIT | GL_TEXTURE_FETCH_BARRIER_BIT);

    std::vector<std::uint8_t> texels(std::size_t(size.x) * size.y * size.z * kChannels);
    glGetTextureImage(texture.id(), 0, GL_RG, GL_UNSIGNED_BYTE, GLsizei(texels.size()), texels.data());
    for (int channel = 0; channel < kChannels; ++channel)
        spreadEvenly(texels, kChannels, channel);
    for (int mip = 0; mip < texture.mips(); ++mip) {
        const glm::ivec3 extent = texture.size(mip);
        if (mip > 0) texels = halved(texels, texture.size(mip - 1), extent);
        glTextureSubImage3D(texture.id(), mip, 0, 0, 0, extent.x, extent.y, extent.z, GL_RG, GL_UNSIGNED_BYTE, texels.data());
    }
}

} // namespace

void spreadEvenly(std::span<std::uint8_t> texels, int channels, int channel)
{
    std::array<std::uint64_t, 256> count{};
    for (std::size_t i = std::size_t(channel); i < texels.size(); i += std::size_t(channels))
        ++count[texels[i]];
    std::array<std::uint8_t, 256> rank{};
    const std::uint64_t all = texels.size() / std::size_t(channels);
    std::uint64_t below = 0;
    for (std::size_t value = 0; value < count.size(); ++value) {
        rank[value] = std::uint8_t((2 * below + count[value]) * 255 / (2 * std::max<std::uint64_t>(all, 1)));
        below += count[value];
    }
    for (std::size_t i = std::size_t(channel); i < texels.size(); i += std::size_t(channels))
        texels[i] = rank[texels[i]];
}

CloudNoise::CloudNoise(ShaderLibrary& shaders)
    : m_shapeProgram{shaders.program({.label = "clouds' shape", .stages = {"cloud_noise.comp.glsl"}})},
      m_detailProgram{shaders.program({.label = "clouds' detail", .stages = {"cloud_noise.comp.glsl"}, .defines = {"DETAIL"}})}
{
}

void CloudNoise::makeOnce(GpuFrame& gpu)
{
    if (m_shape) return;
    const glm::ivec3 shape{CLOUD_SHAPE_SIZE, CLOUD_SHAPE_SIZE, CLOUD_SHAPE_DEPTH};
    m_shape = gl::VolumeTexture{{.label = "clouds' shape", .size = shape, .mips = std::bit_width(unsigned(CLOUD_SHAPE_DEPTH))}};
    m_detail = gl::VolumeTexture{
        {.label = "clouds' detail", .size = glm::ivec3{CLOUD_DETAIL_SIZE}, .mips = std::bit_width(unsigned(CLOUD_DETAIL_SIZE))}};
    make(gpu, m_shapeProgram, m_shape);
    make(gpu, m_detailProgram, m_detail);
}

void CloudNoise::bind() const
{
    if (!m_shape) return;
    m_shape.bind(CLOUD_SHAPE_UNIT);
    m_detail.bind(CLOUD_DETAIL_UNIT);
}

} // namespace renderer
