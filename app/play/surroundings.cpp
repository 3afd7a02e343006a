#include "app/play/surroundings.h"

#include "io/scene/ground.h"
#include "io/scene/instance_walk.h"

#include <BulletCollision/CollisionShapes/btBoxShape.h>
#include <BulletCollision/CollisionShapes/btCapsuleShape.h>
#include <BulletCollision/CollisionShapes/btConvexPointCloudShape.h>
#include <BulletCollision/CollisionShapes/btShapeHull.h>
#include <algorithm>
#include <cmath>

namespace play {
namespace {

constexpr std::size_t kMostKept = 8192; // solids and grids; then all are made anew
constexpr double kHighest = 1e5;        // m, of the walls around the map
constexpr int kGridCell = 8;            // m
constexpr int kGridSide = io::kInstanceTile / kGridCell;

bool touch(const io::WorldBox& a, const io::WorldBox& b)
{
    return glm::all(glm::lessThanEqual(a.min, b.max)) && glm::all(glm::lessThanEqual(b.min, a.max));
}

bool finite(const io::Transform& t)
{
    const auto ok = [](const auto& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); };
    return ok(t.position) && ok(t.rotation) && ok(t.scale);
}

void boxAround(Thing& thing)
{
    thing.box = {};
    if (thing.kind == Thing::Kind::Capsule) {
        thing.box.add(glm::min(thing.corners[0], thing.corners[1]) - thing.radius);
        thing.box.add(glm::max(thing.corners[0], thing.corners[1]) + thing.radius);
    } else if (thing.kind == Thing::Kind::Triangle) {
        for (const glm::dvec3& corner : thing.corners)
            thing.box.add(corner);
    } else {
        for (const glm::dvec3& point : thing.solid->points)
            thing.box.add(point);
    }
}

void addDirection(std::vector<glm::dvec3>& list, const glm::dvec3& direction)
{
    const double length = glm::length(direction);
    if (length < 1e-9) return;
    const glm::dvec3 unit = direction / length;
    for (const glm::dvec3& other : list)
        if (std::abs(glm::dot(other, unit)) > 1 - 1e-9) return;
    list.push_back(unit);
}

// Corners, faces and edges of a convex shape, as 42 directions find them.
std::shared_ptr<Solid> outline(const btConvexShape& shape, const glm::dmat3& turn, const glm::dvec3& at)
{
    auto solid = std::make_shared<Solid>();
    btShapeHull hull{&shape};
    hull.buildHull(0);
    const auto point = [&](unsigned i) {
        const btVector3& p = hull.getVertexPointer()[i];
        return turn * glm::dvec3{p.x(), p.y(), p.z()} + at;
    };
    for (int i = 0; i < hull.numVertices(); ++i)
        solid->points.push_back(point(unsigned(i)));
    for (int i = 0; i + 2 < hull.numIndices(); i += 3) {
        const unsigned int* index = hull.getIndexPointer() + i;
        const Triangle face{point(index[0]), point(index[1]), point(index[2])};
        addDirection(solid->normals, faceNormal(face));
        for (std::size_t k = 0; k < 3; ++k)
            addDirection(solid->edges, face[(k + 1) % 3] - face[k]);
    }
    return solid;
}

std::shared_ptr<Solid> boxOutline(const glm::dvec3& half, const glm::dmat3& turn, const glm::dvec3& at)
{
    auto solid = std::make_shared<Solid>();
    for (int i = 0; i < 8; ++i)
        solid->points.push_back(turn * (half * glm::dvec3{i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1}) + at);
    solid->normals = solid->edges = {turn[0], turn[1], turn[2]};
    return solid;
}

} // namespace

// One object or instance that is no mesh, as it stands in the world.
struct Surroundings::Placed {
    io::Transform transform;
    const Shape* of = nullptr;
    std::vector<btVector3> points; // of a hull
    std::unique_ptr<btConvexShape> shape;
    Thing thing;
};

// Instances of a tile by squares, without what cannot be run into.
struct Surroundings::Grid {
    struct Entry {
        io::ObjectId id;
        io::TemplateId templateId;
        std::uint32_t index;
    };
    std::array<std::vector<Entry>, kGridSide * kGridSide> cells;
    std::shared_ptr<const io::InstanceTile> tile;
    double reach = 0; // m, the farthest that one of them sticks out of the place it stands at
};

Surroundings::Surroundings(const io::Scene& scene, const io::Assets& assets) : m_scene{scene}, m_assets{assets}, m_shapes{scene, assets}
{
    index();
}
Surroundings::~Surroundings() = default;

void Surroundings::index()
{
    std::vector<io::ObjectId> ids;
    std::vector<io::WorldBox> boxes(0);
    std::unordered_map<std::uint32_t, io::WorldBox> boxOf;
    for (const io::Object& object : m_scene.objects()) {
        const io::Template* value = m_scene.find(object.templateId);
        if (!value || !isMet(*value) || !finite(object.transform)) continue;
        ids.push_back(object.id);
        boxes.push_back(io::worldBounds(m_assets, object));
        boxOf.emplace(number(object.id), boxes.back());
    }
    m_tree.build(std::span<const io::ObjectId>{ids}, [&](io::ObjectId id) { return boxOf.at(number(id)); });
}

void Surroundings::follow(const io::Changes& changes)
{
    if (changes.everything || !changes.templates.empty()) {
        m_solids.clear();
        m_grids.clear();
        m_tree.clear();
        return index();
    }
    for (const io::ObjectId id : changes.objects) {
        m_solids.erase(number(id));
        const io::Object* object = m_scene.find(id);
        const io::Template* value = object ? m_scene.find(object->templateId) : nullptr;
        if (value && isMet(*value) && finite(object->transform)) m_tree.set(id, io::worldBounds(m_assets, *object));
        else m_tree.remove(id);
    }
    if (changes.scatter) m_grids.clear();
    for (const io::LayerTile& tile : changes.instances)
        m_grids.erase(tile);
}

const std::vector<Thing>& Surroundings::find(const io::WorldBox& box)
{
    if (m_solids.size() > kMostKept) m_solids.clear();
    m_found.clear();
    addGround(box);
    m_ids.clear();
    m_tree.touching(box, [&](const auto& item) { m_ids.push_back(item.value); });
    std::ranges::sort(m_ids);
    for (const io::ObjectId id : m_ids)
        addObject(id, box, m_found);
    // What was made of an instance before is told apart by where it stands: numbers are used again.
    eachInstance(box, [&](const Standing& thing) { add(thing.id, thing.templateId, thing.transform, box, m_found); });
    return m_found;
}

bool Surroundings::buried(const glm::dvec3& at)
{
    std::vector<Standing> around;
    standing({at, at}, around);
    return std::ranges::any_of(around, [&](const Standing& thing) {
        const Shape& shape = m_shapes.of(thing.templateId);
        if (shape.form != Form::Mesh) return false;
        return inside(shape, m_shapes.tree(thing.templateId), glm::dvec3{glm::inverse(io::worldFromModel(thing.transform)) * glm::dvec4{at, 1}});
    });
}

void Surroundings::standing(const io::WorldBox& box, std::vector<Standing>& things)
{
    const std::size_t first = things.size();
    m_tree.touching(box, [&](const auto& item) {
        const io::Object& object = m_scene.at(item.value);
        things.push_back({object.id, object.templateId, object.transform});
    });
    std::sort(things.begin() + std::ptrdiff_t(first), things.end(), [](const Standing& a, const Standing& b) { return a.id < b.id; });
    eachInstance(box, [&](const Standing& thing) { things.push_back(thing); });
}

void Surroundings::addObject(io::ObjectId id, const io::WorldBox& box, std::vector<Thing>& things)
{
    if (const io::Object* object = m_scene.find(id)) add(id, object->templateId, object->transform, box, things);
}

void Surroundings::addGround(const io::WorldBox& box)
{
    const auto& heights = m_scene.heights();
    if (!heights || heights->size.x < 2 || heights->size.y < 2) return;
    addEdges(box);
    const glm::dvec2 low = (glm::dvec2{box.min.x, box.min.z} - heights->origin) / heights->metresPerTexel;
    const glm::dvec2 high = (glm::dvec2{box.max.x, box.max.z} - heights->origin) / heights->metresPerTexel;
    const glm::dvec2 last{heights->size - 2};
    const glm::ivec2 from{glm::clamp(glm::floor(low), glm::dvec2{0}, last)}, to{glm::clamp(glm::floor(high), glm::dvec2{0}, last)};
    const io::CoverMap* cover = m_scene.cover() && m_scene.cover()->size() == heights->size ? m_scene.cover().get() : nullptr;
    const auto corner = [&](int x, int z) {
        const glm::dvec2 at = heights->origin + glm::dvec2{x, z} * heights->metresPerTexel;
        return glm::dvec3{at.x, heights->at(x, z), at.y};
    };
    for (int z = from.y; z <= to.y; ++z)
        for (int x = from.x; x <= to.x; ++x) {
            if (cover && (cover->at(x, z) & io::kHoleBit)) continue;
            const glm::dvec3 a = corner(x, z), b = corner(x + 1, z), c = corner(x, z + 1), d = corner(x + 1, z + 1);
            for (const Triangle& corners : {Triangle{a, c, b}, Triangle{b, c, d}}) {
                Thing thing{.corners = corners};
                boxAround(thing);
                if (touch(thing.box, box)) m_found.push_back(std::move(thing));
            }
        }
}

// Nobody walks off the map.
void Surroundings::addEdges(const io::WorldBox& box)
{
    const io::HeightMap& map = *m_scene.heights();
    const glm::dvec2 low = map.origin, high = map.origin + glm::dvec2{map.size - 1} * map.metresPerTexel;
    const auto wall = [&](const glm::dvec3& a, const glm::dvec3& b) {
        const glm::dvec3 up{0, kHighest, 0};
        for (const Triangle& corners : {Triangle{a - up, b - up, a + up}, Triangle{a + up, b - up, b + up}}) {
            Thing thing{.corners = corners};
            boxAround(thing);
            m_found.push_back(std::move(thing));
        }
    };
    if (box.min.x < low.x) wall({low.x, 0, low.y - 1}, {low.x, 0, high.y + 1});
    if (box.max.x > high.x) wall({high.x, 0, high.y + 1}, {high.x, 0, low.y - 1});
    if (box.min.z < low.y) wall({high.x + 1, 0, low.y}, {low.x - 1, 0, low.y});
    if (box.max.z > high.y) wall({low.x - 1, 0, high.y}, {high.x + 1, 0, high.y});
}

const Surroundings::Grid& Surroundings::gridOf(const io::LayerTile& at)
{
    std::unique_ptr<Grid>& kept = m_grids[at];
    if (kept) return *kept;
    kept = std::make_unique<Grid>();
    const io::ScatterLayer* layer = m_scene.find(at.layer);
    kept->tile = m_scene.instances(at.layer).at(at.tile);
    std::vector<io::TemplateId> templates = io::templatesOf(m_scene, *layer);
    std::vector<double> reaches;
    for (io::TemplateId& id : templates) {
        const Shape& shape = m_shapes.of(id);
        // What could fall does so as an object; planted by the thousand it stands, as its collision says.
        if (const io::Template* value = m_scene.find(id); shape.form == Form::None || value->collision == io::Collision::None) id = io::TemplateId::None;
        reaches.push_back(id == io::TemplateId::None ? 0 : glm::length(glm::max(glm::abs(glm::dvec3{shape.box.min}), glm::abs(glm::dvec3{shape.box.max}))));
    }
    std::uint32_t number = io::number(m_scene.idOf({at, 0}));
    std::uint32_t index = 0;
    for (const io::Instance& instance : kept->tile->instances) {
        const io::ObjectId id{number++};
        const std::uint32_t place = index++;
        if (instance.species >= templates.size() || templates[instance.species] == io::TemplateId::None) continue;
        const int cell = int(instance.z * io::kInstanceStep) / kGridCell * kGridSide + int(instance.x * io::kInstanceStep) / kGridCell;
        kept->cells[std::size_t(cell)].push_back({id, templates[instance.species], place});
        kept->reach = std::max(kept->reach, std::min(reaches[instance.species] * double(instance.scale), 64.0));
    }
    return *kept;
}

void Surroundings::eachInstance(const io::WorldBox& box, const std::function<void(const Standing&)>& visit)
{
    if (m_grids.size() > kMostKept) m_grids.clear();
    for (const io::ScatterLayer& layer : m_scene.scatterLayers()) {
        const io::InstanceTiles& tiles = m_scene.instances(layer.id);
        if (tiles.empty()) continue;
        const glm::ivec2 from = io::instanceTileAt(box.min - double(io::kInstanceTile)), to = io::instanceTileAt(box.max + double(io::kInstanceTile));
        for (glm::ivec2 t{0, from.y}; t.y <= to.y; ++t.y)
            for (t.x = from.x; t.x <= to.x; ++t.x) {
                const auto found = tiles.find(t);
                if (found == tiles.end()) continue;
                const Grid& grid = gridOf({layer.id, t});
                const glm::dvec2 corner = glm::dvec2{t * io::kInstanceTile};
                const glm::dvec2 low = (glm::dvec2{box.min.x, box.min.z} - grid.reach - corner) / double(kGridCell);
                const glm::dvec2 high = (glm::dvec2{box.max.x, box.max.z} + grid.reach - corner) / double(kGridCell);
                for (int z = std::max(0, int(std::floor(low.y))); z <= std::min(kGridSide - 1, int(std::floor(high.y))); ++z)
                    for (int x = std::max(0, int(std::floor(low.x))); x <= std::min(kGridSide - 1, int(std::floor(high.x))); ++x)
                        for (const Grid::Entry& entry : grid.cells[std::size_t(z * kGridSide + x)])
                            visit({entry.id, entry.templateId, io::transformOf(t, grid.tile->instances[entry.index])});
            }
    }
}

void Surroundings::add(io::ObjectId id, io::TemplateId templateId, const io::Transform& transform, const io::WorldBox& box, std::vector<Thing>& things)
{
    const Shape& shape = m_shapes.of(templateId);
    if (shape.form == Form::None) return;
    if (shape.form == Form::Mesh) return addMesh(id, templateId, io::worldFromModel(transform), box, things);
    const Thing& thing = solidOf(id, shape, transform);
    if (touch(thing.box, box)) things.push_back(thing);
}

void Surroundings::addMesh(io::ObjectId id, io::TemplateId templateId, const glm::dmat4& world, const io::WorldBox& box, std::vector<Thing>& things)
{
    const double volume = glm::determinant(world);
    if (!(std::abs(volume) > 1e-15)) return; // flattened to nothing
    const Shape& shape = m_shapes.of(templateId);
    const glm::dmat4 model = glm::inverse(world);
    io::WorldBox inModel;
    for (int i = 0; i < 8; ++i) {
        const glm::dvec3 corner{i & 1 ? box.max.x : box.min.x, i & 2 ? box.max.y : box.min.y, i & 4 ? box.max.z : box.min.z};
        inModel.add(glm::dvec3{model * glm::dvec4{corner, 1}});
    }
    m_triangles.clear();
    m_shapes.tree(templateId).touching(inModel, m_triangles);
    for (const std::uint32_t first : m_triangles) {
        Thing thing{.id = id};
        for (std::uint32_t i = 0; i < 3; ++i)
            thing.corners[i] = glm::dvec3{world * glm::dvec4{shape.vertices[shape.indices[first + i]], 1}};
        boxAround(thing);
        if (touch(thing.box, box)) things.push_back(std::move(thing));
    }
}

const Thing& Surroundings::solidOf(io::ObjectId id, const Shape& shape, const io::Transform& transform)
{
    std::unique_ptr<Placed>& kept = m_solids[number(id)];
    if (kept && kept->transform == transform && kept->of == &shape) return kept->thing;
    kept = std::make_unique<Placed>();
    kept->transform = transform;
    kept->of = &shape;
    Thing& thing = kept->thing;
    thing.id = id;
    const glm::dvec3 scale{transform.scale}, size = glm::max(glm::abs(scale), 1e-6);
    thing.turn = glm::mat3_cast(io::orientation(transform.rotation));
    thing.at = transform.position + thing.turn * (scale * shape.centre);
    if (shape.form == Form::Capsule) {
        const double radius = shape.radius * std::max(size[(shape.axis + 1) % 3], size[(shape.axis + 2) % 3]);
        const double reach = (shape.stem + shape.radius) * size[shape.axis];
        const double stem = std::max(0.0, reach - radius);
        thing.kind = Thing::Kind::Capsule;
        thing.radius = radius;
        thing.corners = {thing.at - thing.turn[shape.axis] * stem, thing.at + thing.turn[shape.axis] * stem, thing.at};
        const glm::dvec3 along = thing.turn[shape.axis], side = glm::abs(along.y) < 0.9 ? glm::cross(along, glm::dvec3{0, 1, 0}) : glm::cross(along, glm::dvec3{1, 0, 0});
        const glm::dmat3 upright{glm::normalize(side), along, glm::cross(glm::normalize(side), along)};
        thing.solid = outline(btCapsuleShape{radius, 2 * stem}, upright, thing.at);
    } else if (shape.form == Form::Box) {
        const glm::dvec3 half = shape.half * size;
        thing.kind = Thing::Kind::Convex;
        kept->shape = std::make_unique<btBoxShape>(btVector3{half.x, half.y, half.z});
        kept->shape->setMargin(0);
        thing.solid = boxOutline(half, thing.turn, thing.at);
    } else {
        thing.kind = Thing::Kind::Convex;
        for (const glm::dvec3& point : shape.points)
            kept->points.emplace_back(scale.x * point.x, scale.y * point.y, scale.z * point.z);
        kept->shape = std::make_unique<btConvexPointCloudShape>(kept->points.data(), int(kept->points.size()), btVector3{1, 1, 1}, true);
        kept->shape->setMargin(0);
        thing.solid = outline(*kept->shape, thing.turn, thing.at);
        auto all = std::make_shared<play::Solid>(*thing.solid);
        for (const btVector3& p : kept->points)
            all->points.push_back(thing.turn * glm::dvec3{p.x(), p.y(), p.z()} + thing.at);
        thing.solid = all;
    }
    thing.shape = kept->shape.get();
    boxAround(thing);
    return thing;
}

} // namespace play
