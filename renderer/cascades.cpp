#include "renderer/cascades.h"

#include <algorithm>
#include <cmath>

namespace renderer {
namespace {

constexpr double kFirstDepth = 0.5; // m; splits are counted from here, for nothing nearer needs a cascade of its own
constexpr int kSteps = 8;           // a box moves by whole steps of this part of its width, so that its map can be kept
constexpr int kFilterTexels = 12;   // room for the filter

struct Sphere {
    double depth = 0; // m, of its centre along the camera's axis
    double radius = 0;
};

// The smallest sphere on the axis around a slice of the view pyramid; it does not change when the camera turns.
Sphere sphereAround(double begin, double end, double tanX, double tanY)
{
    const double k2 = tanX * tanX + tanY * tanY; // squared slope of the pyramid's edges
    const double middle = std::min((begin + end) / 2 * (1 + k2), end);
    const double farCorner = (end - middle) * (end - middle) + end * end * k2;
    const double nearCorner = (begin - middle) * (begin - middle) + begin * begin * k2;
    return {middle, std::sqrt(std::max(farCorner, nearCorner))};
}

double roundedUp(double radius)
{
    return std::ceil(radius * 16) / 16;
}

} // namespace

glm::dmat3 lightAxes(const glm::dvec3& towardSun)
{
    const glm::dvec3 z = glm::normalize(towardSun);
    const glm::dvec3 reference = std::abs(z.y) > 0.999 ? glm::dvec3{0, 0, -1} : glm::dvec3{0, 1, 0};
    const glm::dvec3 x = glm::normalize(glm::cross(reference, z));
    return glm::transpose(glm::dmat3{x, glm::cross(z, x), z});
}

// Zhang et al., "Parallel-Split Shadow Maps" (2006): a mix of even and logarithmic slices.
std::vector<double> cascadeEnds(const io::Shadows& shadows)
{
    const int count = std::clamp(shadows.cascades, 1, 4);
    const double last = std::max(double(shadows.distance), kFirstDepth * 2);
    std::vector<double> ends;
    for (int i = 1; i <= count; ++i) {
        const double share = double(i) / count;
        const double logarithmic = kFirstDepth * std::pow(last / kFirstDepth, share);
        const double uniform = kFirstDepth + (last - kFirstDepth) * share;
        ends.push_back(glm::mix(uniform, logarithmic, double(glm::clamp(shadows.lambda, 0.0f, 1.0f))));
    }
    return ends;
}

std::vector<Cascade> cascadesOf(const Eye& eye, const io::Shadows& shadows, const glm::dvec3& towardSun)
{
    const glm::dmat3 axes = lightAxes(towardSun);
    const glm::dmat3 back = glm::transpose(axes);
    const int resolution = std::clamp(shadows.resolution, 64, 16384);
    std::vector<Cascade> cascades;
    double begin = kNear;
    for (const double end : cascadeEnds(shadows)) {
        const Sphere sphere = sphereAround(begin, end, eye.tanHalfFov * eye.aspect, eye.tanHalfFov);
        Cascade c{.beginDepth = begin, .endDepth = end};
        const int step = resolution / kSteps; // texels; the slice lies up to half a step from the box's middle
        c.radius = roundedUp(sphere.radius * resolution / double(resolution - kFilterTexels - step));
        c.texel = 2 * c.radius / resolution;

        const glm::dvec3 centre = axes * (eye.position + eye.forward * sphere.depth);
        c.snapped = glm::round(centre / (c.texel * step)) * (c.texel * step);

        // clip = ((axes * (relative + eye)) - snapped) / radius; what is nearer to the sun is pressed onto depth 0.
        const glm::dvec3 offset = axes * eye.position - c.snapped;
        glm::dmat4 clip{1};
        for (int column = 0; column < 3; ++column)
            clip[column] = {axes[column].x / c.radius, axes[column].y / c.radius, -axes[column].z / (2 * c.radius), 0};
        clip[3] = {offset.x / c.radius, offset.y / c.radius, 0.5 - offset.z / (2 * c.radius), 1};
        c.clipFromRelative = clip;
        glm::dmat4 half{1};
        half[0][0] = half[1][1] = 0.5;
        half[3] = {0.5, 0.5, 0, 1};
        c.textureFromRelative = half * clip;

        const auto plane = [&](const glm::dvec3& lightNormal, double d) { return glm::dvec4{back * lightNormal, d}; };
        c.volume = {{plane({1, 0, 0}, c.radius - c.snapped.x), plane({-1, 0, 0}, c.radius + c.snapped.x),
                     plane({0, 1, 0}, c.radius - c.snapped.y), plane({0, -1, 0}, c.radius + c.snapped.y),
                     plane({0, 0, 1}, c.radius - c.snapped.z)}};
        cascades.push_back(c);
        begin = end;
    }
    return cascades;
}

} // namespace renderer
