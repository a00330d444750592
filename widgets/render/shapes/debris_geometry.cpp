#include "widgets/render/shapes/debris_geometry.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <tuple>

#include "core/fe/mesh.h"
#include "widgets/render/shapes/vertex_cells.h"

namespace rubble::render {
namespace {

using Key = std::array<std::uint32_t, 4>;

struct Corner {
    Vec3 place;
    FragmentId fragment;
    std::uint32_t corner = 0;    ///< of its solid
    std::uint32_t place_id = 0;  ///< equal for corners at the same place
    std::uint32_t vertex = 0;    ///< equal for corners that are drawn as one
};

bool before(const Vec3& a, const Vec3& b) {
    return std::tie(a.x(), a.y(), a.z()) < std::tie(b.x(), b.y(), b.z());
}

/// Six times the volume of a closed surface; negative if its faces run the wrong way round.
double signedVolume(std::span<const Vec3> corners, ElementShape shape) {
    double volume = 0.0;
    for (const auto& face : facesOf(shape)) {
        const auto p = [&](int i) -> const Vec3& { return corners[static_cast<std::size_t>(face[static_cast<std::size_t>(i)])]; };
        const Vec3 o = corners[0];
        volume += (p(0) - o).dot((p(1) - o).cross(p(2) - o));
        if (face[3] >= 0) {
            volume += (p(0) - o).dot((p(2) - o).cross(p(3) - o));
        }
    }
    return volume;
}

struct OpenFace {
    Key key{};     ///< places ascending
    Key places{};  ///< in order
    DebrisGeometry::Face face;
};

/// Two faces over the same places that look at each other; both lie inside the group.
bool facing(const OpenFace& a, const OpenFace& b) {
    const int n = a.places[3] == DebrisGeometry::none ? 3 : 4;
    for (int start = 0; start < n; ++start) {
        bool same = true;
        for (int i = 0; i < n && same; ++i) {
            same = a.places[static_cast<std::size_t>(i)] == b.places[static_cast<std::size_t>((start - i + n) % n)];
        }
        if (same) {
            return true;
        }
    }
    return false;
}

/// The last body of a group has left the engine.
bool gone(const TrajectoryFrame& frame, std::uint32_t body, double to, double time) {
    return time >= to || (body < frame.states.size() && frame.states[body] == BodyState::Removed);
}

void dropInner(std::vector<OpenFace>& faces) {
    std::vector<std::size_t> order(faces.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(),
              [&](std::size_t a, std::size_t b) { return faces[a].key != faces[b].key ? faces[a].key < faces[b].key : a < b; });
    std::vector<std::uint8_t> inner(faces.size(), 0);
    for (std::size_t i = 0; i + 1 < order.size(); ++i) {
        const std::size_t a = order[i], b = order[i + 1];
        if (!inner[a] && faces[a].key == faces[b].key && faces[a].face.fragment != faces[b].face.fragment &&
            facing(faces[a], faces[b])) {
            inner[a] = inner[b] = 1;
        }
    }
    std::size_t kept = 0;
    for (std::size_t i = 0; i < faces.size(); ++i) {
        if (!inner[i]) {
            faces[kept++] = faces[i];
        }
    }
    faces.resize(kept);
}

}  // namespace

DebrisGeometry::DebrisGeometry(const FragmentSet& fragments, const Clustering* clusters, bool hideInner,
                               std::span<const std::uint8_t> hidden)
    : m_fragments(fragments), m_clusters(clusters), m_hideInner(hideInner) {
    std::vector<std::vector<FragmentId>> members;
    if (clusters) {
        for (std::size_t c = 0; c < clusters->list.size(); ++c) {
            const auto of = clusters->membersOf(idAt<ClusterId>(c));
            members.emplace_back(of.begin(), of.end());
        }
    } else {
        for (std::size_t f = 0; f < fragments.size(); ++f) {
            members.push_back({idAt<FragmentId>(f)});
        }
    }
    for (auto& group : members) {
        std::erase_if(group, [&](FragmentId f) { return !hidden.empty() && hidden[at(f)] != 0; });
    }
    build(members);
}

void DebrisGeometry::build(const std::vector<std::vector<FragmentId>>& members) {
    m_vertices.clear();
    m_faces.clear();
    m_groups.clear();
    m_members = members;
    std::erase_if(m_members, [](const auto& group) { return group.empty(); });
    std::sort(m_members.begin(), m_members.end(), [](const auto& a, const auto& b) { return a.front() < b.front(); });
    for (const auto& group : m_members) {
        addGroup(group);
    }
    m_rides.assign(m_groups.size(), {});
    noteGroups();
}

void DebrisGeometry::noteGroups() {
    m_groupOf.assign(m_fragments.size(), none);
    for (std::size_t g = 0; g < m_members.size(); ++g) {
        for (const FragmentId f : m_members[g]) {
            m_groupOf[at(f)] = static_cast<std::uint32_t>(g);
        }
    }
}

void DebrisGeometry::addGroup(std::span<const FragmentId> members) {
    Group group;
    group.firstVertex = static_cast<std::uint32_t>(m_vertices.size());
    group.first = members.front();
    std::vector<Corner> corners;
    for (const FragmentId f : members) {
        group.centre += m_fragments.list[at(f)].centre / static_cast<double>(members.size());
        std::uint32_t corner = 0;
        for (const Vec3& p : m_fragments.verticesOf(f)) {
            corners.push_back({p, f, corner++});
        }
    }
    // Corners at bit-equal places are one place; those of one look (same birth, same component) are one vertex.
    std::vector<std::uint32_t> order(corners.size());
    std::iota(order.begin(), order.end(), 0u);
    const auto look = [&](const Corner& c) {
        const Fragment& f = m_fragments.list[at(c.fragment)];
        return std::tie(f.birthTime, f.component);
    };
    std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
        if (corners[a].place != corners[b].place) {
            return before(corners[a].place, corners[b].place);
        }
        const auto la = look(corners[a]), lb = look(corners[b]);
        return la != lb ? la < lb : a < b;
    });
    std::uint32_t place = 0;
    for (std::size_t i = 0; i < order.size(); ++i) {
        Corner& corner = corners[order[i]];
        const Corner* last = i > 0 ? &corners[order[i - 1]] : nullptr;
        const bool samePlace = last && last->place == corner.place;
        place += last && !samePlace ? 1 : 0;
        corner.place_id = place;
        corner.vertex = samePlace && look(*last) == look(corner) ? last->vertex : order[i];
    }
    std::vector<OpenFace> open;
    std::size_t first = 0;
    for (const FragmentId f : members) {
        const auto own = m_fragments.verticesOf(f);
        const ElementShape shape = m_fragments.solid[at(f)];
        const bool inverted = signedVolume(own, shape) < 0;
        for (const auto& local : facesOf(shape)) {
            OpenFace face;
            const int n = local[3] < 0 ? 3 : 4;
            face.places.fill(none);
            face.face.vertices.fill(none);
            face.face.fragment = f;
            for (int i = 0; i < n; ++i) {
                const auto slot = static_cast<std::size_t>(inverted ? n - 1 - i : i);
                const auto corner = first + static_cast<std::size_t>(local[static_cast<std::size_t>(i)]);
                face.places[slot] = corners[corner].place_id;
                face.face.vertices[slot] = corners[corner].vertex;
            }
            face.key = face.places;
            std::sort(face.key.begin(), face.key.end());
            open.push_back(face);
        }
        first += own.size();
    }
    if (m_hideInner && members.size() > 1) {
        dropInner(open);
    }
    // Only vertices that a remaining face uses are kept.
    std::vector<std::uint32_t> kept(corners.size(), none);
    for (OpenFace& face : open) {
        for (std::uint32_t& vertex : face.face.vertices) {
            if (vertex == none) {
                continue;
            }
            if (kept[vertex] == none) {
                kept[vertex] = static_cast<std::uint32_t>(m_vertices.size());
                m_vertices.push_back(
                    {(corners[vertex].place - group.centre).cast<float>(), corners[vertex].fragment, corners[vertex].corner});
            }
            vertex = kept[vertex];
        }
        m_faces.push_back(face.face);
    }
    group.vertexCount = static_cast<std::uint32_t>(m_vertices.size()) - group.firstVertex;
    m_groups.push_back(group);
}

DebrisGeometry DebrisGeometry::simplified(double cell) const {
    DebrisGeometry coarse(*this);
    coarse.m_vertices.clear();
    coarse.m_faces.clear();
    VertexCells cells(cell);
    std::vector<Eigen::Vector3f> own;
    auto face = m_faces.begin();
    for (std::size_t g = 0; g < m_groups.size(); ++g) {
        const Group& group = m_groups[g];
        own.clear();
        Eigen::AlignedBox3f box;
        for (std::uint32_t i = 0; i < group.vertexCount; ++i) {
            own.push_back(m_vertices[group.firstVertex + i].local);
            box.extend(own.back());
        }
        // Faces stand group by group, as their vertices do.
        const auto first = face;
        while (face != m_faces.end() && face->vertices[0] < group.firstVertex + group.vertexCount) {
            ++face;
        }
        coarse.m_groups[g].firstVertex = static_cast<std::uint32_t>(coarse.m_vertices.size());
        const std::span<const Face> faces(first, face);
        constexpr double cellsAcross = 2.0;
        const bool narrow = static_cast<double>(box.sizes().minCoeff()) < cellsAcross * cell;
        if (narrow && faces.size() > facesOf(ElementShape::Hexahedron).size()) {
            // Fragments that lie apart fill a part of it: drawn in until it holds no more than they do, boxes of a pile stand as
            // high as the pile, and cover each other less.
            double material = 0.0;
            for (const FragmentId f : m_members[g]) {
                material += std::abs(signedVolume(m_fragments.verticesOf(f), m_fragments.solid[at(f)])) / 6.0;
            }
            const double share = std::cbrt(material / std::max(static_cast<double>(box.volume()), material));
            coarse.addBox({static_cast<float>(share) * box.min(), static_cast<float>(share) * box.max()}, group.first);
        } else {
            std::vector<std::uint32_t> joined(own.size());
            std::iota(joined.begin(), joined.end(), 0u);
            coarse.addJoined(m_vertices, faces, group.firstVertex, narrow ? joined : cells.join(own));
        }
        coarse.m_groups[g].vertexCount = static_cast<std::uint32_t>(coarse.m_vertices.size()) - coarse.m_groups[g].firstVertex;
    }
    return coarse;
}

void DebrisGeometry::addBox(const Eigen::AlignedBox3f& box, FragmentId fragment) {
    const auto first = static_cast<std::uint32_t>(m_vertices.size());
    for (const int corner : {0, 1, 3, 2, 4, 5, 7, 6}) {  // Eigen counts binary, Exodus II round about
        m_vertices.push_back({box.corner(static_cast<Eigen::AlignedBox3f::CornerType>(corner)), fragment,
                              static_cast<std::uint32_t>(m_vertices.size()) - first});
    }
    for (const auto& local : facesOf(ElementShape::Hexahedron)) {
        Face face;
        face.fragment = fragment;
        for (std::size_t i = 0; i < 4; ++i) {
            face.vertices[i] = first + static_cast<std::uint32_t>(local[i]);
        }
        m_faces.push_back(face);
    }
}

/// Takes over what is left of a group's faces, with the vertices that they use.
/// @param joined  for each vertex of the group the one that stands for it
void DebrisGeometry::addJoined(std::span<const Vertex> vertices, std::span<const Face> faces, std::uint32_t first,
                               const std::vector<std::uint32_t>& joined) {
    std::vector<std::uint32_t> drawn(joined.size(), none);
    for (Face face : faces) {
        for (std::uint32_t& vertex : face.vertices) {
            vertex = vertex == none ? none : joined[vertex - first];
        }
        if (!withoutRepeats(face.vertices, none)) {
            continue;
        }
        for (std::uint32_t& vertex : face.vertices) {
            if (vertex == none) {
                continue;
            }
            if (drawn[vertex] == none) {
                drawn[vertex] = static_cast<std::uint32_t>(m_vertices.size());
                m_vertices.push_back(vertices[first + vertex]);
            }
            vertex = drawn[vertex];
        }
        m_faces.push_back(face);
    }
}

void DebrisGeometry::bind(std::span<const Carrier> carriers) {
    std::vector<std::vector<Ride>> rides(m_fragments.size());
    for (const Carrier& carrier : carriers) {
        if (at(carrier.fragment) < rides.size()) {
            rides[at(carrier.fragment)].push_back(
                {static_cast<std::uint32_t>(carrier.body), carrier.from, carrier.to, carrier.handOverToBody});
        }
    }
    const auto sameRides = [&](FragmentId a, FragmentId b) {
        return std::equal(rides[at(a)].begin(), rides[at(a)].end(), rides[at(b)].begin(), rides[at(b)].end(),
                          [](const Ride& x, const Ride& y) {
                              return x.body == y.body && x.from == y.from && x.to == y.to &&
                                     x.handOverToBody.position == y.handOverToBody.position &&
                                     x.handOverToBody.orientation.coeffs() == y.handOverToBody.orientation.coeffs();
                          });
    };
    std::vector<std::vector<FragmentId>> groups;
    bool split = false;
    for (const auto& members : m_members) {
        const std::size_t first = groups.size();
        for (const FragmentId f : members) {
            auto home = groups.begin() + static_cast<std::ptrdiff_t>(first);
            while (home != groups.end() && !sameRides(home->front(), f)) {
                ++home;
            }
            if (home == groups.end()) {
                groups.push_back({f});
            } else {
                home->push_back(f);
            }
        }
        split = split || groups.size() > first + 1;
    }
    if (split) {
        build(groups);
    }
    for (std::size_t g = 0; g < m_groups.size(); ++g) {
        m_rides[g] = rides[at(m_groups[g].first)];
    }
}

const DebrisGeometry::Ride* DebrisGeometry::rideAt(std::size_t group, double time) const {
    const Ride* current = nullptr;
    for (const Ride& ride : m_rides[group]) {
        if (ride.from <= time || !current) {
            current = &ride;
        }
    }
    return current;
}

void DebrisGeometry::place(const TrajectoryFrame& frame, double time, std::size_t count, float* out) const {
    for (std::size_t g = 0; g < count; ++g) {
        const Group& group = m_groups[g];
        const Ride* ride = rideAt(g, time);
        Eigen::Matrix3f turn = Eigen::Matrix3f::Identity();
        Eigen::Vector3f shift = group.centre.cast<float>();
        if (ride && gone(frame, ride->body, ride->to, time)) {
            turn.setZero();  // a point: its faces cover nothing
        } else if (ride && ride->body < frame.bodies()) {
            const Quat body = frame.orientations[ride->body].cast<double>();
            const Vec3 centre = frame.positions[ride->body].cast<double>() + body * (ride->handOverToBody * group.centre);
            turn = (body * ride->handOverToBody.orientation).toRotationMatrix().cast<float>();
            shift = centre.cast<float>();
        }
        const Vertex* vertex = m_vertices.data() + group.firstVertex;
        float* p = out + 3 * std::size_t{group.firstVertex};
        for (std::uint32_t i = 0; i < group.vertexCount; ++i, p += 3) {
            Eigen::Map<Eigen::Vector3f> target(p);
            target.noalias() = turn * vertex[i].local;
            target += shift;
        }
    }
}

std::optional<Vec3> DebrisGeometry::centreOf(FragmentId fragment, const TrajectoryFrame& frame, double time) const {
    const std::uint32_t group = m_groupOf[at(fragment)];
    if (group == none) {
        return std::nullopt;
    }
    const Vec3 centre = m_fragments.list[at(fragment)].centre;
    const Ride* ride = rideAt(group, time);
    if (!ride) {
        return centre;
    }
    if (gone(frame, ride->body, ride->to, time)) {
        return std::nullopt;
    }
    if (ride->body >= frame.bodies()) {
        return centre;
    }
    return frame.positions[ride->body].cast<double>() +
           frame.orientations[ride->body].cast<double>() * (ride->handOverToBody * centre);
}

std::vector<float> DebrisGeometry::speeds(const TrajectoryFrame& frame, double time, std::size_t count) const {
    std::vector<float> speeds(count, 0.0f);
    for (std::size_t g = 0; g < count; ++g) {
        const Ride* ride = rideAt(g, time);
        if (ride && ride->body < frame.speeds.size()) {
            speeds[g] = frame.speeds[ride->body];
        }
    }
    return speeds;
}

}  // namespace rubble::render
