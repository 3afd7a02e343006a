#include "app/play/ground_shape.h"

#include "app/play/bullet.h"

#include <BulletCollision/CollisionShapes/btConcaveShape.h>
#include <algorithm>
#include <cmath>

namespace play {
namespace {

constexpr double kBelow = 20, kAbove = 0.1; // m, of the box around the ground, in which contacts are looked for

class GroundShape final : public btConcaveShape {
public:
    explicit GroundShape(const io::Scene& scene) : m_scene{scene}
    {
        setMargin(0);
        m_shapeType = FAST_CONCAVE_MESH_PROXYTYPE; // of nothing else here
    }

    void processAllTriangles(btTriangleCallback* callback, const btVector3& from, const btVector3& to) const override
    {
        const io::HeightMap& map = *m_scene.heights();
        const io::CoverMap* cover = m_scene.cover() && m_scene.cover()->size() == map.size ? m_scene.cover().get() : nullptr;
        const glm::dvec2 last{map.size - 2};
        const auto cellOf = [&](double x, double z) { return glm::ivec2{glm::clamp(glm::floor((glm::dvec2{x, z} - map.origin) / map.metresPerTexel), glm::dvec2{0}, last)}; };
        const glm::ivec2 low = cellOf(from.x(), from.z()), high = cellOf(to.x(), to.z());
        const auto corner = [&](int x, int z) {
            const glm::dvec2 at = map.origin + glm::dvec2{x, z} * map.metresPerTexel;
            return glm::dvec3{at.x, map.at(x, z), at.y};
        };
        for (int z = low.y; z <= high.y; ++z)
            for (int x = low.x; x <= high.x; ++x) {
                if (cover && (cover->at(x, z) & io::kHoleBit)) continue;
                const glm::dvec3 a = corner(x, z), b = corner(x + 1, z), c = corner(x, z + 1), d = corner(x + 1, z + 1);
                if (std::max({a.y, b.y, c.y, d.y}) < from.y() || std::min({a.y, b.y, c.y, d.y}) > to.y()) continue;
                btVector3 first[]{bullet(a), bullet(c), bullet(b)}, second[]{bullet(b), bullet(c), bullet(d)};
                callback->processTriangle(first, z, 2 * x);
                callback->processTriangle(second, z, 2 * x + 1);
            }
    }
    void getAabb(const btTransform&, btVector3& low, btVector3& high) const override
    {
        const io::HeightMap& map = *m_scene.heights();
        const glm::dvec2 end = map.origin + glm::dvec2{map.size - 1} * map.metresPerTexel;
        low = {map.origin.x, map.min - kBelow, map.origin.y};
        high = {end.x, map.max + kAbove, end.y};
    }
    void setLocalScaling(const btVector3&) override {}
    const btVector3& getLocalScaling() const override
    {
        static const btVector3 kOne{1, 1, 1};
        return kOne;
    }
    void calculateLocalInertia(btScalar, btVector3& inertia) const override { inertia = {0, 0, 0}; }
    const char* getName() const override { return "ground"; }

    const io::Scene& scene() const { return m_scene; }

private:
    const io::Scene& m_scene;
};

} // namespace

std::unique_ptr<btConcaveShape> groundShape(const io::Scene& scene)
{
    const auto& heights = scene.heights();
    if (!heights || heights->size.x < 2 || heights->size.y < 2) return nullptr;
    return std::make_unique<GroundShape>(scene);
}

bool isGround(const btCollisionShape& shape)
{
    return shape.getShapeType() == FAST_CONCAVE_MESH_PROXYTYPE;
}

const io::Scene& sceneOf(const btCollisionShape& ground)
{
    return static_cast<const GroundShape&>(ground).scene();
}

} // namespace play
