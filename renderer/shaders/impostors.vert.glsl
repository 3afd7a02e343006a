// Quads of impostors. Everything happens in the model's own space, where its frames were made, so that any turn, scale
// and mirror image of a copy comes out right.
#include "records.glsl"
#include "light.glsl"
#include "shared/gbuffer.h"
#include "shared/impostor.h"
#ifdef SHADOW
#include "shadows_block.glsl"
#endif
#include "view.glsl"

layout(location = 0) in vec3 inCentre;    // m
layout(location = 1) in vec2 inRoughness; // of leaves and of the rest
layout(location = 3) in vec4 inExtent;    // half the bounds' size, of the radius; how much of their depth the quad stands before
                                          // the centre
layout(location = 4) in vec2 inCorner;    // -1 or 1
layout(location = 5) in vec2 inPlace;     // radius in m, layer

invariant gl_Position; // passes that draw the same surface again compare depths for equality

#ifdef SHADOW
layout(location = 0) out vec2 place;         // in its frame, in the frame's sides
layout(location = 1) flat out vec4 frame;    // where it begins, layer, mip
#elif !defined(POSITION_ONLY)
layout(location = 0) out vec4 places01;     // in frames 0 and 1, in frames' sides
layout(location = 1) out vec2 place2;
layout(location = 2) flat out vec4 frames01; // where they begin
layout(location = 3) flat out vec4 frame2;   // and layer, mip
layout(location = 4) flat out vec4 shifts01; // of places, for each radius of depth
layout(location = 5) flat out vec4 shift2;   // and the weights of frames 0 and 1
layout(location = 6) flat out vec3 normalX;  // images of the normal's axes
layout(location = 7) flat out vec3 normalY;
layout(location = 8) flat out vec3 normalZ;
layout(location = 9) flat out uvec4 ids;     // object; flags, reach towards the sun; roughness of leaves and of the rest (unorm16); a pixel that moves along
#endif

const float kSteepest = 0.7; // tangent of the angle from below beyond which it is seen as from there

void main()
{
    mat3 model = mat3(inAxisX, inAxisY, inAxisZ);
    vec3 origin = instancePlace(view.eyeHigh, view.eyeLow);
    float radius = inPlace.x;

    // From here on lengths are shares of the radius, seen from the centre.
#ifdef SHADOW
    vec3 eye = normalize(inverse(model) * shadows.towardLight) * 1e4; // as the maps are drawn
#else
    vec3 eye = -(inverse(model) * origin + inCentre) / radius;
#endif
    eye.y = max(eye.y, -kSteepest * length(eye.xz));
    float distance_ = max(length(eye), 1.5);
    vec3 towardEye = normalize(eye);
    vec3 right = dot(towardEye.xz, towardEye.xz) > 1e-8 ? frameRight(towardEye) : vec3(1.0, 0.0, 0.0);
    vec3 up = cross(towardEye, right);
    vec2 extent = vec2(dot(abs(right), inExtent.xyz), dot(abs(up), inExtent.xyz)) * (distance_ / (distance_ - 1.0));
    vec3 corner = right * (inCorner.x * extent.x) + up * (inCorner.y * extent.y);
    vec3 ray = corner - towardEye * distance_;
    float forward = inExtent.w * dot(abs(towardEye), inExtent.xyz);
#ifdef SHADOW
    forward *= 0.4; // or the sunward half of what it stands for would lie in its shadow
#endif
    vec3 stands = corner - ray * (forward / distance_);
    gl_Position = view.clipFromRelative * vec4(origin + model * (inCentre + stands * radius), 1.0);
    passOnLevel();

#ifdef SHADOW
    vec3 f = frameDirection(floor(frameGrid(normalize(vec3(towardEye.x, max(towardEye.y, 0.0), towardEye.z))) + 0.5));
    vec3 r = frameRight(f);
    vec3 hit = corner - ray * (dot(corner, f) / dot(ray, f));
    place = vec2(dot(hit, r), dot(hit, cross(f, r))) * (0.5 * IMPOSTOR_FILL) + 0.5;
    float size = radius * pow(abs(determinant(model)), 1.0 / 3.0); // m
    float texel = 0.5 * IMPOSTOR_FILL * float(IMPOSTOR_FRAME_TEXELS) * view.pixelAngle / size;
    frame = vec4(floor(frameGrid(f) + 0.5), inPlace.y, clamp(floor(log2(texel)), 0.0, float(IMPOSTOR_MIPS - 1)));
#elif !defined(POSITION_ONLY)
    // The cell's two corners on the diagonal, and the third of the triangle that the direction lies in.
    vec2 grid = frameGrid(normalize(vec3(towardEye.x, max(towardEye.y, 0.0), towardEye.z)));
    vec2 cell = min(floor(grid), float(IMPOSTOR_FRAMES - 2));
    vec2 part = grid - cell;
    vec2 third = part.x > part.y ? vec2(1.0, 0.0) : vec2(0.0, 1.0);
    vec2 frames[3] = vec2[3](cell, cell + third, cell + 1.0);
    vec3 share = vec3(1.0 - max(part.x, part.y), abs(part.x - part.y), min(part.x, part.y));
    share *= share; // the nearest picture lacks least of what is to be seen from here
    vec2 weights = share.xy / (share.x + share.y + share.z);

    vec2 places[3];
    vec2 shifts[3];
    for (int i = 0; i < 3; ++i) {
        vec3 f = frameDirection(frames[i]);
        vec3 r = frameRight(f);
        vec3 u = cross(f, r);
        vec3 hit = corner - ray * (dot(corner, f) / dot(ray, f));
        places[i] = vec2(dot(hit, r), dot(hit, u)) * (0.5 * IMPOSTOR_FILL) + 0.5;
        shifts[i] = vec2(dot(towardEye, r), dot(towardEye, u)) * (0.5 * IMPOSTOR_FILL / dot(towardEye, f));
    }
    places01 = vec4(places[0], places[1]);
    place2 = places[2];
    frames01 = vec4(frames[0], frames[1]);
    shifts01 = vec4(shifts[0], shifts[1]);
    shift2 = vec4(shifts[2], weights);
    float texels = 0.5 * IMPOSTOR_FILL * float(IMPOSTOR_FRAME_TEXELS) * distance_ * view.pixelAngle; // a pixel
    frame2 = vec4(frames[2], inPlace.y, clamp(floor(log2(texels) + 0.5), 0.0, float(IMPOSTOR_MIPS - 1)));

    normalX = cross(model[1], model[2]);
    normalY = cross(model[2], model[0]);
    normalZ = cross(model[0], model[1]);
    float mirror = sign(dot(model[0], normalX));
    normalX *= mirror;
    normalY *= mirror;
    normalZ *= mirror;
    vec4 centre = view.clipFromRelative * vec4(origin + model * inCentre, 1.0);
    ivec2 pixel = ivec2(floor((centre.xy / centre.w * 0.5 + 0.5) * vec2(view.size)));
    vec3 towardSun = inverse(model) * light.towardSun;
    float reach = radius / length(towardSun / max(inExtent.xyz, vec3(0.01))); // m, of an ellipsoid towards the sun
    uint across = uint(min(reach, IMPOSTOR_MOST_REACH) * (255.0 / IMPOSTOR_MOST_REACH));
    ids = uvec4(instanceObject(), instanceFlags() | across << 8, packUnorm2x16(inRoughness), uint(pixel.x & 0xffff) | uint(pixel.y) << 16);
#endif
}
