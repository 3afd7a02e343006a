#include "renderer/cascades.h"

#include "renderer/shaders/shared/shadows.h"

#include <algorithm>
#include <cmath>

namespace renderer {
namespace {

constexpr double kFirstDistance = 0.5; // m; splits are counted from here, for nothing nearer needs a cascade of its own
constexpr int kSteps = 16;             // a window moves by whole steps of this part of its width, so that few strips come at once
constexpr double kDepthStep = 4;       // of the radius: what depth is counted from moves seldom, for all is drawn anew then
constexpr double kLongestContact = 60; // of the radius: farther blockers of a small light count as being there
constexpr double kDiscAsTent = 1.22;   // half the width of a tent that blurs as a disc of radius 1 does: of the same variance

struct Sphere {
    double along = 0; // m, of its centre on the camera's axis
    double radius = 0;
};

// The smallest sphere on the axis around what of the view pyramid lies at such distances; it does not change when the camera
// turns. With m the cosine between the axis and the pyramid's edges, a corner at a distance d is away from a centre at c by
// d^2 - 2 d m c + c^2: the far corners count, the near ones too where the view is narrow, and the far end of the axis never.
Sphere sphereAround(double begin, double end, double tanX, double tanY)
{
    const double cosine = 1 / std::sqrt(1 + tanX * tanX + tanY * tanY);
    const double centre = std::min(end * cosine, (begin + end) / (2 * cosine));
    const auto squaredTo = [&](double distance) { return distance * distance - 2 * distance * cosine * centre + centre * centre; };
    return {centre, std::sqrt(std::max({squaredTo(begin), squaredTo(end), (end - centre) * (end - centre)}))};
}

// Texels of a window beside what the camera sees, for the filter of what lies at the edge and for what bias lifts it aside.
int roomOf(const io::Shadows& shadows)
{
    const double reach = std::max(double(filterReach(shadows)), shadows.contact ? double(MOST_PENUMBRA) : 0.0);
    return 2 * int(std::ceil(reach) + std::ceil(reach / 2 * double(shadows.bias)) + 2);
}

double roundedUp(double radius)
{
    return std::ceil(radius * 16) / 16;
}

io::Texel floorModulo(const io::Texel& value, std::int64_t period)
{
    const io::Texel rest = value % period;
    return rest + io::Texel{rest.x < 0 ? period : 0, rest.y < 0 ? period : 0};
}

// To the copy of the texture that begins at the texel `first`.
glm::dmat4 textureFromRelative(const Cascade& c, const io::Texel& first, const glm::dmat3& axes, const glm::dvec3& eye)
{
    const double size = c.texel * c.resolution, range = c.depthRange;
    const glm::dvec3 place = axes * eye;
    glm::dmat4 matrix{1};
    for (int column = 0; column < 3; ++column)
        matrix[column] = {axes[column].x / size, axes[column].y / size, -axes[column].z / range, 0};
    const glm::dvec2 offset = (glm::dvec2{place} - glm::dvec2{first} * c.texel) / size;
    matrix[3] = {offset, 1 - (place.z - c.bottom) / range, 1};
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

// By hand, or after Zhang et al., "Parallel-Split Shadow Maps" (2006): a mix of even and logarithmic slices. Whatever is asked
// for, they rise: an end that does not leaves its cascade out.
std::vector<double> cascadeEnds(const io::Shadows& shadows)
{
    const int count = std::clamp(shadows.cascades, 1, MAX_CASCADES);
    const double last = shadows.distance > kFirstDistance * 2 ? double(shadows.distance) : kFirstDistance * 2;
    const float byHand[] = {shadows.end1, shadows.end2, shadows.end3, shadows.end4, shadows.end5};
    std::vector<double> ends;
    for (int i = 1; i < count; ++i) {
        const double share = double(i) / count;
        const double logarithmic = kFirstDistance * std::pow(last / kFirstDistance, share);
        const double uniform = kFirstDistance + (last - kFirstDistance) * share;
        const double practical = glm::mix(uniform, logarithmic, double(glm::clamp(shadows.lambda, 0.0f, 1.0f)));
        const double end = shadows.splits == io::Splits::Manual ? double(byHand[i - 1]) : practical;
        if (end > (ends.empty() ? kFirstDistance : ends.back()) && end < last) ends.push_back(end);
    }
    ends.push_back(last);
    return ends;
}

double cascadeBlend(const io::Shadows& shadows)
{
    return glm::clamp(double(shadows.blend), 0.0, 1.0);
}

float filterReach(const io::Shadows& shadows)
{
    const float tent = 2 + float(shadows.filter); // 3 x 3 texels and their neighbours, as a tent weighs them
    return std::max(tent * shadows.softness, 1.0f);
}

std::vector<Cascade> cascadesOf(const Eye& eye, const io::Shadows& shadows, const glm::dvec3& towardSun, double lightRadius)
{
    const glm::dmat3 axes = lightAxes(towardSun);
    const int resolution = std::clamp(shadows.resolution, 64, 16384);
    const int step = resolution / kSteps; // texels; the slice lies up to half a step from the window's middle
    const int inside = std::max(resolution - roomOf(shadows) - step, resolution / kSteps);
    std::vector<Cascade> cascades;
    double begin = 0, seenFrom = 0; // the blend with the cascade before shows this one earlier
    for (const double end : cascadeEnds(shadows)) {
        const Sphere sphere = sphereAround(seenFrom, end, eye.tanHalfFov * eye.aspect, eye.tanHalfFov);
        Cascade c{.begin = begin, .end = end, .resolution = resolution};
        c.radius = roundedUp(sphere.radius * resolution / double(inside));
        c.texel = 2 * c.radius / resolution;
        if (shadows.contact && cascades.size() < CONTACT_CASCADES) {
            c.penumbra = std::max(kDiscAsTent * std::tan(lightRadius) * double(shadows.softness) / c.texel, 1e-6);
            c.contactReach = std::min(double(MOST_PENUMBRA) / c.penumbra, c.radius * kLongestContact);
        }

        const glm::dvec3 centre = axes * (eye.position + eye.forward * sphere.along);
        c.low = io::Texel{glm::round(glm::dvec2{centre} / (c.texel * step))} * std::int64_t(step) - std::int64_t(resolution / 2);
        const double depthStep = c.radius * kDepthStep, reach = c.radius + depthStep / 2; // m, of the sphere from where the steps leave it
        c.bottom = std::round(centre.z / depthStep) * depthStep - reach;
        c.depthRange = 2 * reach + c.contactReach;
        const io::Texel first = c.low - floorModulo(c.low, resolution); // so that the window lies within [0, 2)
        c.textureFromRelative = textureFromRelative(c, first, axes, eye.position);
        cascades.push_back(c);
        seenFrom = end - (end - begin) * cascadeBlend(shadows);
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
                                       plane({0, -1, 0}, high.y), plane({0, 0, 1}, -cascade.bottom)}}});
    }
    return pieces;
}

io::TexelRect shadowOf(const Cascade& cascade, const glm::dvec4& sphere, const glm::dvec3& towardSun)
{
    const glm::dvec3 centre = lightAxes(towardSun) * glm::dvec3{sphere};
    if (centre.z + sphere.w < cascade.bottom) return {};
    const glm::dvec2 reach{sphere.w + cascade.texel};
    return {io::Texel{glm::floor((glm::dvec2{centre} - reach) / cascade.texel)}, io::Texel{glm::ceil((glm::dvec2{centre} + reach) / cascade.texel)}};
}

} // namespace renderer
