#include "renderer/cascades.h"

#include <algorithm>
#include <cmath>

namespace renderer {
namespace {

constexpr double kFirstDepth = 0.5; // m; splits are counted from here, for nothing nearer needs a cascade of its own
constexpr int kSteps = 16;          // a window moves by whole steps of this part of its width, so that few strips come at once
constexpr int kFilterTexels = 12;   // room for the filter
constexpr double kDepthStep = 4;    // of the radius: what depth is counted from moves seldom, for all is drawn anew then

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

// m along the light: the window's sphere, wherever the steps leave it. What is nearer to the sun is pressed onto depth 0.
double depthRange(const Cascade& cascade)
{
    return cascade.radius * (2 + kDepthStep);
}

io::Texel floorModulo(const io::Texel& value, std::int64_t period)
{
    const io::Texel rest = value % period;
    return rest + io::Texel{rest.x < 0 ? period : 0, rest.y < 0 ? period : 0};
}

// To the copy of the texture that begins at the texel `first`.
glm::dmat4 textureFromRelative(const Cascade& c, const io::Texel& first, const glm::dmat3& axes, const glm::dvec3& eye)
{
    const double size = c.texel * c.resolution, range = depthRange(c);
    const glm::dvec3 place = axes * eye;
    glm::dmat4 matrix{1};
    for (int column = 0; column < 3; ++column)
        matrix[column] = {axes[column].x / size, axes[column].y / size, -axes[column].z / range, 0};
    const glm::dvec2 offset = (glm::dvec2{place} - glm::dvec2{first} * c.texel) / size;
    matrix[3] = {offset, 0.5 - (place.z - c.middle) / range, 1};
    return matrix;
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
    const int resolution = std::clamp(shadows.resolution, 64, 16384);
    std::vector<Cascade> cascades;
    double begin = kNear;
    for (const double end : cascadeEnds(shadows)) {
        const Sphere sphere = sphereAround(begin, end, eye.tanHalfFov * eye.aspect, eye.tanHalfFov);
        Cascade c{.beginDepth = begin, .endDepth = end, .resolution = resolution};
        const int step = resolution / kSteps; // texels; the slice lies up to half a step from the window's middle
        c.radius = roundedUp(sphere.radius * resolution / double(resolution - kFilterTexels - step));
        c.texel = 2 * c.radius / resolution;

        const glm::dvec3 centre = axes * (eye.position + eye.forward * sphere.depth);
        c.low = io::Texel{glm::round(glm::dvec2{centre} / (c.texel * step))} * std::int64_t(step) - std::int64_t(resolution / 2);
        const double depthStep = c.radius * kDepthStep;
        c.middle = std::round(centre.z / depthStep) * depthStep;
        const io::Texel first = c.low - floorModulo(c.low, resolution); // so that the window lies within [0, 2)
        c.textureFromRelative = textureFromRelative(c, first, axes, eye.position);
        cascades.push_back(c);
        begin = end;
    }
    return cascades;
}

std::vector<CascadePiece> piecesOf(const Cascade& cascade, const io::TexelRect& part, const glm::dvec3& eye, const glm::dvec3& towardSun)
{
    const glm::dmat3 axes = lightAxes(towardSun), back = glm::transpose(axes);
    const auto plane = [&](const glm::dvec3& lightNormal, double d) { return glm::dvec4{back * lightNormal, d}; };
    glm::dmat4 clipFromTexture{1};
    clipFromTexture[0][0] = clipFromTexture[1][1] = 2;
    clipFromTexture[3] = {-1, -1, 0, 1};

    std::vector<CascadePiece> pieces;
    for (const io::TexelRect& rect : cutAtMultiples(part, cascade.resolution)) {
        const io::Texel at = floorModulo(rect.low, cascade.resolution);
        const glm::dvec2 low = glm::dvec2{rect.low} * cascade.texel, high = glm::dvec2{rect.high} * cascade.texel;
        pieces.push_back({.at = glm::ivec2{at},
                          .size = glm::ivec2{rect.high - rect.low},
                          .clipFromRelative = clipFromTexture * textureFromRelative(cascade, rect.low - at, axes, eye),
                          .casters = {{plane({1, 0, 0}, -low.x), plane({-1, 0, 0}, high.x), plane({0, 1, 0}, -low.y),
                                       plane({0, -1, 0}, high.y), plane({0, 0, 1}, depthRange(cascade) / 2 - cascade.middle)}}});
    }
    return pieces;
}

io::TexelRect shadowOf(const Cascade& cascade, const glm::dvec4& sphere, const glm::dvec3& towardSun)
{
    const glm::dvec3 centre = lightAxes(towardSun) * glm::dvec3{sphere};
    if (centre.z + sphere.w < cascade.middle - depthRange(cascade) / 2) return {};
    const glm::dvec2 reach{sphere.w + cascade.texel};
    return {io::Texel{glm::floor((glm::dvec2{centre} - reach) / cascade.texel)}, io::Texel{glm::ceil((glm::dvec2{centre} + reach) / cascade.texel)}};
}

} // namespace renderer
