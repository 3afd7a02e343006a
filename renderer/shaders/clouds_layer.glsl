// The cheap clouds: one layer on a shell over the planet.
#include "cloud_field.glsl"
#include "cloud_light.glsl"
#include "fog.glsl"
#include "view.glsl"

struct LayerSeen {
    vec3 radiance;  // of the cloud behind the air before it, times what it hides
    float through;  // share of what is behind
    float straight; // share of the sun's disc
    float metres;   // to it; negative: none
};

// Share of light that the layer takes from what is behind it: all in its thick where that is thick enough.
float layerHiding(float field)
{
    return cloudThickness(field) * (1.0 - exp(-0.1 * clouds.density * clouds.thickness)) * clouds.on;
}

// Optical depth through the layer from top to base; relief goes on where a cover is closed.
float layerDepth(float field)
{
    float relief = 0.2 + clamp(field * clouds.width + clouds.edge, 0.0, 1.0);
    return clouds.density * clouds.thickness * relief * cloudThickness(field);
}

LayerSeen layerTowards(vec3 direction)
{
    LayerSeen seen = LayerSeen(vec3(0.0), 1.0, 1.0, -1.0);
    vec2 shell = cloudShell(clouds.planet, direction.y, clouds.base);
    float t = shell.x > 0.0 ? shell.x : shell.y;
    if (t <= 0.0) return seen;
    vec2 relative = direction.xz * t;
    float texels = t * view.pixelAngle * clouds.perMetre * float(CLOUD_SHAPE_SIZE);
    float lod = clamp(log2(max(texels * inversesqrt(max(abs(direction.y), 0.03)), 1.0)) * 0.75, 0.0, 4.0);
    float field = cloudField(cloudPlace(relative), lod);
    float hiding = layerHiding(field) * smoothstep(0.0, 150.0, abs(clouds.base)); // one flies through it
    if (hiding <= 0.001) return seen;

    // What lies between here and the sun, looked at twice.
    float depth = layerDepth(field);
    vec2 aside = clouds.sunward * clouds.thickness;
    float near = layerDepth(cloudField(cloudPlace(relative + aside * 0.12), lod + 0.5));
    float far = layerDepth(cloudField(cloudPlace(relative + aside * 0.4), lod + 1.0));
    bool below = clouds.base > 0.0;
    // Where few clouds stand one sees their lit sides, where they close their dark bases.
    float sides = mix(0.1, 1.0, smoothstep(0.3, 1.0, clouds.cover));
    float under = (depth * 0.5 + near * 0.3 + far * 0.2) * sides;
    float over = min(depth, 2.0) * 0.3 + (max(near - depth, 0.0) + max(far - depth, 0.0)) * 0.05; // the sun meets its top
    float tauSun = below ? under : over;
    vec3 source = cloudSource(tauSun, 1.0 - exp(-depth), below ? depth * sides : 0.0, below ? 0.0 : depth * sides, dot(direction, light.towardSun));

    // From below, whoever draws the sky lays the haze over all of it.
    float haze = (below ? 1.0 : fogTransmittance(direction * t)) * smoothstep(0.0, 0.05, abs(direction.y));
    seen.radiance = throughAir(source * hiding, hiding, direction, t, clouds.base, haze);
    seen.through = 1.0 - hiding;
    seen.straight = exp(-depth * clouds.on);
    seen.metres = t;
    return seen;
}

// Lays the clouds over `sky`; the share of the sun's disc that comes through.
vec4 withClouds(vec3 sky, vec3 direction)
{
    LayerSeen seen = layerTowards(direction);
    return vec4(sky * seen.through + seen.radiance, seen.straight);
}
