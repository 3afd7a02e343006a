// Table: the light that the air scatters before things at 32 distances, in all directions around the eye. One thread a
// direction; it goes on from each distance to the next. The planet's ground does not end a ray: worlds are flat, and what lies
// in a valley is seen through air of sea level. The last slice is all of the air above the horizon: the sky itself.
#include "air_light.glsl"
#include "heavens.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(rgba16f, binding = 0) writeonly uniform image2DArray aerial;

void main()
{
    ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
    Atmosphere air = light.atmosphere;
    vec2 place = aerialTexel(vec2(texel) + 0.5);
    float muView = place.x;
    float muSun = heavens.towardSun.y;
    float nu = muView * muSun + sqrt(max((1.0 - muView * muView) * (1.0 - muSun * muSun), 0.0)) * place.y;
    bool up = muView >= horizonCosine(air, air.eyeAltitude);
    float top = distanceToTop(air, air.eyeAltitude, muView);
    float phaseRayleigh = rayleighPhase(nu);
    float phaseMie = miePhase(air.mieG, nu);
    float onward = straightOn(air);

    vec3 radiance = vec3(0.0);
    vec3 through = vec3(1.0);
    imageStore(aerial, ivec3(texel, 0), vec4(0.0));
    for (int slice = 1; slice < AERIAL_SIZE; ++slice) {
        bool last = slice == AERIAL_SIZE - 1;
        float from = min(aerialDistance(float(slice - 1)), top);
        float to = last && up ? top : min(aerialDistance(float(slice)), top);
        int steps = to <= from ? 0 : last && up ? 12 : 2;
        for (int i = 0; i < steps; ++i) {
            float dt = (to - from) / float(steps);
            float t = from + (float(i) + 0.5) * dt;
            float h = max(altitudeAlong(air, air.eyeAltitude, muView, t), 0.0);
            float mu = cosineAlong(air, air.eyeAltitude, muView, muSun, nu, t);
            Medium medium = mediumAt(air, h);
            vec3 source = (medium.rayleigh * phaseRayleigh + vec3(medium.mieScattering * phaseMie)) * sunTransmittance(air, h, mu) +
                          (medium.rayleigh + vec3(medium.mieScattering * (1.0 - onward))) * multipleScattering(air, h, mu);
            vec3 extinction = max(medium.extinction - vec3(medium.mieScattering * onward), vec3(1e-9));
            vec3 stepThrough = exp(-extinction * dt);
            radiance += through * source * (vec3(1.0) - stepThrough) / extinction;
            through *= stepThrough;
        }
        imageStore(aerial, ivec3(texel, slice), vec4(radiance, 1.0));
    }
}
