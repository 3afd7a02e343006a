// The rich clouds: volumes that rays march through. The field says where they stand and how high they reach, noise in space
// carves them (Schneider and Vos 2015; Hillaire, "Physically Based Sky, Atmosphere and Cloud Rendering in Frostbite" 2016).
#include "cloud_field.glsl"

const float kCarving = 3.0;  // repeats of the shape's noise in a repeat of the field
const float kWisps = 15.0;   // and of the detail's
const float kSteepness = 2.2; // of the field at their edges: carving takes from there
const float kSkirt = 0.5;     // and what they have beyond them, for wisps to be torn from
const float kFirmness = 0.4; // range of the noise over which a cloud turns from air to its full density
const float kRagged = 2.2;    // by how much of that noise wisps eat into it

// Extinction at `relative`, per m; `h` is the height in the layer of clouds, 0 at the base and 1 at the top.
float cloudExtinction(vec3 relative, float h, float lod, bool fine)
{
    if (h <= 0.0 || h >= 1.0) return 0.0;
    vec2 place = cloudPlace(relative.xz);
    float billows = textureLod(cloudShape, vec3(place, clouds.phase.x), lod).r;
    float broad = textureLod(cloudShape, vec3(place.yx * CLOUD_BROAD + 0.37, clouds.phase.y), lod - 1.7).g;
    float field = (billows * CLOUD_BILLOWS_SHARE + broad * CLOUD_BROAD_SHARE + 0.5 * CLOUD_FINE_SHARE - clouds.edge) / clouds.width;
    float stands = cloudThickness(field * kSteepness + kSkirt);
    if (stands <= 0.0) return 0.0;

    // Flat below, where a cover closes in waves, round above, and the higher the deeper within.
    vec3 at = vec3(place, h * clouds.thickness * clouds.perMetre);
    h = max(h - 0.25 * (1.0 - billows), 0.0);
    float top = mix(0.25, 1.0, clamp(field * 0.6, 0.0, 1.0));
    float shape = stands * smoothstep(0.0, 0.07, h) * (1.0 - smoothstep(top * 0.35, top, h));
    float carved = textureLod(cloudShape, vec3(at.xy * kCarving, at.z * (kCarving * 4.0) + clouds.phase.x * 2.0), lod + 1.6).r;
    float ragged = kRagged * (1.0 - 0.65 * smoothstep(0.6, 0.9, clouds.cover)); // a closed cover has no holes
    float solid = shape * (1.0 + kFirmness + 0.25 * ragged) - 1.0 + carved;
    if (solid <= 0.0) return 0.0;
    float torn = 0.5; // in the mean
    if (fine && solid < kFirmness + ragged) {
        float wisps = textureLod(cloudDetail, at * kWisps + vec3(0.0, 0.0, clouds.phase.z), lod + 2.0).r;
        float threads = textureLod(cloudDetail, at.yzx * (kWisps * 2.9) + clouds.phase.z, lod + 3.5).r;
        wisps = mix(wisps, threads, 0.35);
        torn = mix(1.0 - wisps, wisps, clamp(1.0 - h * 5.0, 0.0, 1.0)); // billows above, threads below
    }
    solid -= ragged * torn;
    return clouds.density * clouds.on * clamp(solid / kFirmness, 0.0, 1.0) * mix(0.4, 1.0, carved);
}

float cloudHeight(vec3 direction, float t) // in the layer, over a round planet
{
    float rise = direction.y * t + 0.5 * t * t * (1.0 - direction.y * direction.y) / clouds.planet;
    return (rise - clouds.base) / clouds.thickness;
}
