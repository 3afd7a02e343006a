// The structs that both compilers read lie alike in both.
#include "renderer/shader_library.h"
#include "renderer/shaders/shared/clouds.h"
#include "renderer/shaders/shared/heavens.h"
#include "renderer/shaders/shared/instance.h"
#include "renderer/shaders/shared/light.h"
#include "renderer/shaders/shared/material.h"
#include "renderer/shaders/shared/shadows.h"
#include "renderer/shaders/shared/terrain.h"
#include "renderer/shaders/shared/view.h"
#include "tests/gl/support/shared_renderer.h"

#include <cstddef>
#include <gtest/gtest.h>

namespace {

GLint offsetIn(const renderer::gl::Program& program, const char* name)
{
    const GLuint index = glGetProgramResourceIndex(program.id(), GL_UNIFORM, name);
    if (index == GL_INVALID_INDEX) return -1;
    constexpr GLenum kOffset = GL_OFFSET;
    GLint offset = -1;
    glGetProgramResourceiv(program.id(), GL_UNIFORM, index, 1, &kOffset, 1, nullptr, &offset);
    return offset;
}

class Layout : public testing::Test {
protected:
    void SetUp() override { ASSERT_TRUE(test::haveContext()); }
    renderer::ShaderLibrary shaders{WOLD_SOURCE_DIR "/renderer/shaders"};
};

TEST_F(Layout, ViewAndLightAgree)
{
    const renderer::gl::Program& p = shaders.fullScreen("lighting", {"SHADOWS", "SHADOW_TAPS 2", "CLOUD_SHADOWS"});
    ASSERT_TRUE(p);
    EXPECT_EQ(offsetIn(p, "view.clipFromRelative"), offsetof(glsl::View, clipFromRelative));
    EXPECT_EQ(offsetIn(p, "view.eyeLow"), offsetof(glsl::View, eyeLow));
    EXPECT_EQ(offsetIn(p, "view.exposure"), offsetof(glsl::View, exposure));
    EXPECT_EQ(offsetIn(p, "view.eyeHeight"), offsetof(glsl::View, eyeHeight));
    EXPECT_EQ(offsetIn(p, "view.texel"), offsetof(glsl::View, texel));

    EXPECT_EQ(offsetIn(p, "light.sunRadius"), offsetof(glsl::Light, sunRadius));
    EXPECT_EQ(offsetIn(p, "light.sunAtClouds"), offsetof(glsl::Light, sunAtClouds));
    EXPECT_EQ(offsetIn(p, "light.sunAt[0]"), offsetof(glsl::Light, sunAt));
    EXPECT_EQ(offsetIn(p, "light.atmosphere.rayleigh"), offsetof(glsl::Light, atmosphere.rayleigh));
    EXPECT_EQ(offsetIn(p, "light.atmosphere.horizon"), offsetof(glsl::Light, atmosphere.horizon));
    EXPECT_EQ(offsetIn(p, "skyLight.irradiance[0]"), 0);
    EXPECT_EQ(offsetIn(p, "clouds.perMetre"), offsetof(glsl::Clouds, perMetre));
    EXPECT_EQ(offsetIn(p, "clouds.sun"), offsetof(glsl::Clouds, sun));
    EXPECT_EQ(offsetIn(p, "clouds.map"), offsetof(glsl::Clouds, map));
    EXPECT_EQ(offsetIn(p, "clouds.sunward"), offsetof(glsl::Clouds, sunward));
    EXPECT_EQ(offsetIn(p, "clouds.through"), offsetof(glsl::Clouds, through));
    EXPECT_EQ(offsetIn(p, "clouds.mapLod"), offsetof(glsl::Clouds, mapLod));

    EXPECT_EQ(offsetIn(p, "shadows.cascade[1].textureFromRelative"), sizeof(glsl::ShadowCascade));
    EXPECT_EQ(offsetIn(p, "shadows.cascade[1].penumbra"), sizeof(glsl::ShadowCascade) + offsetof(glsl::ShadowCascade, penumbra));
    EXPECT_EQ(offsetIn(p, "shadows.cascade[1].low"), sizeof(glsl::ShadowCascade) + offsetof(glsl::ShadowCascade, low));
    EXPECT_EQ(offsetIn(p, "shadows.ends"), offsetof(glsl::Shadows, ends));
    EXPECT_EQ(offsetIn(p, "shadows.resolution"), offsetof(glsl::Shadows, resolution));
    EXPECT_EQ(offsetIn(p, "shadows.fadeScale"), offsetof(glsl::Shadows, fadeScale));
    EXPECT_EQ(offsetIn(p, "shadows.climb"), offsetof(glsl::Shadows, climb));
}

TEST_F(Layout, HeavensAgree)
{
    const renderer::gl::Program& p = shaders.fullScreen("sky", {"STARS", "MOON"});
    ASSERT_TRUE(p);
    EXPECT_EQ(offsetIn(p, "heavens.towardSun"), offsetof(glsl::Heavens, towardSun));
    EXPECT_EQ(offsetIn(p, "heavens.moonRadius"), offsetof(glsl::Heavens, moonRadius));
    EXPECT_EQ(offsetIn(p, "heavens.milkyWay"), offsetof(glsl::Heavens, milkyWay));
    EXPECT_EQ(offsetIn(p, "heavens.glowOverhead"), offsetof(glsl::Heavens, glowOverhead));
    EXPECT_EQ(offsetIn(p, "heavens.equatorFromWorld[0]"), offsetof(glsl::Heavens, equatorFromWorld));
}

TEST_F(Layout, TerrainAgrees)
{
    const renderer::gl::Program& p = shaders.program(
        {.label = "ground", .stages = {"terrain.vert.glsl", "terrain.frag.glsl"}, .defines = {"LAYERS 8"}});
    ASSERT_TRUE(p);
    EXPECT_EQ(offsetIn(p, "terrain.levelsFrom"), offsetof(glsl::Terrain, levelsFrom));
    EXPECT_EQ(offsetIn(p, "terrain.eyeHeight"), offsetof(glsl::Terrain, eyeHeight));
    EXPECT_EQ(offsetIn(p, "terrain.segmentAngle"), offsetof(glsl::Terrain, segmentAngle));
    EXPECT_EQ(offsetIn(p, "terrain.flowScale"), offsetof(glsl::Terrain, flowScale));
    EXPECT_EQ(offsetIn(p, "terrain.layer[0].flowRamps"), offsetof(glsl::Terrain, layer) + offsetof(glsl::TerrainLayer, flowRamps));
    EXPECT_EQ(offsetIn(p, "terrain.layer[0].colour"), offsetof(glsl::Terrain, layer));
    EXPECT_EQ(offsetIn(p, "terrain.layer[1].normalLayer"),
              offsetof(glsl::Terrain, layer) + sizeof(glsl::TerrainLayer) + offsetof(glsl::TerrainLayer, normalLayer));
}

// Vertices read these by the number of the texel.
TEST_F(Layout, RecordsLieAsTheirTexelsSay)
{
    constexpr std::size_t kTexel = 16;
    EXPECT_EQ(sizeof(glsl::Material), MATERIAL_TEXELS * kTexel);
    EXPECT_EQ(offsetof(glsl::Material, emissive), MATERIAL_EMISSIVE_TEXEL * kTexel);
    EXPECT_EQ(offsetof(glsl::Material, metallic), MATERIAL_FACTORS_TEXEL * kTexel);
    EXPECT_EQ(offsetof(glsl::Material, alphaCutoff), MATERIAL_FACTORS_TEXEL * kTexel + 12);
    EXPECT_EQ(offsetof(glsl::Material, quick), MATERIAL_QUICK_TEXEL * kTexel);
    EXPECT_EQ(offsetof(glsl::Material, textures), MATERIAL_TEXTURE_TEXEL * kTexel);
}

} // namespace
