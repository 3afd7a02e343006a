// Splitting edges until a mesh has exactly as many triangles as asked.
#include "io/base/contract.h"
#include "projects/make/mesh.h"

#include <algorithm>
#include <map>
#include <queue>
#include <tuple>

namespace make {
namespace {

using Point = std::tuple<int, int, int>; // a position, in units of 0.05 mm
using Edge = std::pair<Point, Point>;

Point pointOf(const io::Vertex& v)
{
    const glm::ivec3 p{glm::round(v.position * 20000.0f)};
    return {p.x, p.y, p.z};
}

Edge edgeOf(const Triangle& t, int side)
{
    const Point a = pointOf(t.corners[std::size_t(side)]), b = pointOf(t.corners[std::size_t(side + 1) % 3]);
    return a < b ? Edge{a, b} : Edge{b, a};
}

double lengthOf(const Edge& edge)
{
    const auto [ax, ay, az] = edge.first;
    const auto [bx, by, bz] = edge.second;
    return glm::length(glm::dvec3{ax - bx, ay - by, az - bz});
}

io::Vertex middle(const io::Vertex& a, const io::Vertex& b)
{
    io::Vertex m;
    m.position = (a.position + b.position) * 0.5f;
    const glm::vec3 normal = a.normal + b.normal;
    m.normal = glm::dot(normal, normal) > 0 ? glm::normalize(normal) : a.normal;
    m.uv0 = (a.uv0 + b.uv0) * 0.5f;
    m.colour = glm::u8vec4{(glm::uvec4{a.colour} + glm::uvec4{b.colour}) / 2u};
    return m;
}

class Refiner {
public:
    Refiner(Mesh& mesh, const std::function<void(io::Vertex&)>& move) : m_mesh{mesh}, m_move{move}
    {
        for (int i = 0; i < int(mesh.count()); ++i)
            link(i);
    }

    void to(std::size_t count)
    {
        EXPECTS(m_mesh.count() <= count);
        while (m_mesh.count() < count)
            split(m_mesh.count() + 1 == count ? border() : longest());
    }

private:
    Triangle& triangle(int i) { return m_mesh.triangles()[std::size_t(i)]; }

    void link(int i)
    {
        for (int side = 0; side < 3; ++side) {
            const Edge edge = edgeOf(triangle(i), side);
            m_users[edge].push_back(i);
            m_queue.emplace(lengthOf(edge), edge);
        }
    }

    void unlink(int i)
    {
        for (int side = 0; side < 3; ++side)
            std::erase(m_users[edgeOf(triangle(i), side)], i);
    }

    Edge longest()
    {
        while (true) {
            EXPECTS(!m_queue.empty());
            const Edge edge = m_queue.top().second;
            m_queue.pop();
            const std::size_t users = m_users[edge].size();
            if (users == 1 || users == 2) return edge;
        }
    }

    Edge border() // the longest edge of one triangle alone, so that one is added and not two
    {
        Edge best;
        double length = -1;
        for (const auto& [edge, users] : m_users)
            if (users.size() == 1 && lengthOf(edge) > length) {
                best = edge;
                length = lengthOf(edge);
            }
        EXPECTS(length >= 0);
        return best;
    }

    void split(const Edge& edge)
    {
        const std::vector<int> users = m_users[edge];
        for (const int i : users) {
            unlink(i);
            const Triangle old = triangle(i);
            std::size_t side = 0;
            while (edgeOf(old, int(side)) != edge)
                ++side;
            const io::Vertex &a = old.corners[side], &b = old.corners[(side + 1) % 3], &c = old.corners[(side + 2) % 3];
            io::Vertex m = pointOf(a) < pointOf(b) ? middle(a, b) : middle(b, a);
            if (m_move) m_move(m);
            triangle(i) = {{a, m, c}, old.surface};
            m_mesh.add({{m, b, c}, old.surface});
            link(i);
            link(int(m_mesh.count()) - 1);
        }
    }

    Mesh& m_mesh;
    const std::function<void(io::Vertex&)>& m_move;
    std::map<Edge, std::vector<int>> m_users;
    std::priority_queue<std::pair<double, Edge>> m_queue;
};

} // namespace

void refineTo(Mesh& mesh, std::size_t count, const std::function<void(io::Vertex&)>& move)
{
    if (mesh.count() != count) Refiner{mesh, move}.to(count);
}

} // namespace make
