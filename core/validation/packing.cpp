#include "core/validation/packing.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

#include "core/base/convex_hull.h"
#include "core/base/sequence.h"
#include "core/base/unknown.h"
#include "core/engine/world/rigid_world.h"

namespace rubble {

namespace {

constexpr double dieDensity = 2400.0;       // kg/m3
constexpr double stepSeconds = 1.0 / 40.0;  // what a run takes by itself for bodies of 0.3 m
constexpr int perLayer = 3;                 // dice along a side of what is poured at once
constexpr double betweenLayers = 0.3;       // s
constexpr double dropHeight = 0.5;          // m, above the pile
constexpr double restSeconds = 6.0;         // s, after the last
constexpr int probes = 20000;               // points of the middle that are looked at
constexpr double golden = std::numbers::phi;

std::vector<Vec3> signedCorners(double x, double y, double z) {
    std::vector<Vec3> corners;
    for (const double sx : {-1.0, 1.0}) {
        for (const double sy : {-1.0, 1.0}) {
            for (const double sz : {-1.0, 1.0}) {
                const Vec3 corner(sx * x, sy * y, sz * z);
                if (std::none_of(corners.begin(), corners.end(), [&](const Vec3& c) { return c == corner; })) {
                    corners.push_back(corner);
                }
            }
        }
    }
    return corners;
}

void append(std::vector<Vec3>& corners, const std::vector<Vec3>& more) {
    corners.insert(corners.end(), more.begin(), more.end());
}

/// Corners of a regular body of any size, and the volume that it then has.
std::pair<std::vector<Vec3>, double> regularBody(Die die) {
    std::vector<Vec3> corners;
    switch (die) {
        case Die::Cube:
            return {signedCorners(0.5, 0.5, 0.5), 1.0};
        case Die::Tetrahedron:
            return {{{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}}, 8.0 / 3.0};
        case Die::Octahedron:
            append(corners, signedCorners(1, 0, 0));
            append(corners, signedCorners(0, 1, 0));
            append(corners, signedCorners(0, 0, 1));
            return {corners, 4.0 / 3.0};
        case Die::Dodecahedron:
            append(corners, signedCorners(1, 1, 1));
            append(corners, signedCorners(0, 1.0 / golden, golden));
            append(corners, signedCorners(1.0 / golden, golden, 0));
            append(corners, signedCorners(golden, 0, 1.0 / golden));
            return {corners, (15.0 + 7.0 * std::sqrt(5.0)) / 4.0 * std::pow(std::sqrt(5.0) - 1.0, 3)};
        case Die::Icosahedron:
            append(corners, signedCorners(0, 1, golden));
            append(corners, signedCorners(1, golden, 0));
            append(corners, signedCorners(golden, 0, 1));
            break;
    }
    return {corners, 5.0 * (3.0 + std::sqrt(5.0)) / 12.0 * 8.0};
}

/// kg m2 about any axis, of a mass of 1 kg and a volume of 1 m3: all regular bodies turn alike about all axes.
double inertiaOf(Die die) {
    switch (die) {
        case Die::Cube:
            return 1.0 / 6.0;
        case Die::Tetrahedron:
            return std::pow(6.0 * std::sqrt(2.0), 2.0 / 3.0) / 20.0;
        case Die::Octahedron:
            return std::pow(3.0 / std::sqrt(2.0), 2.0 / 3.0) / 10.0;
        case Die::Dodecahedron:
            return (39.0 * golden + 28.0) / 150.0 * std::pow(4.0 / (15.0 + 7.0 * std::sqrt(5.0)), 2.0 / 3.0);
        case Die::Icosahedron:
            break;
    }
    return golden * golden / 10.0 * std::pow(12.0 / (5.0 * (3.0 + std::sqrt(5.0))), 2.0 / 3.0);
}

NewBody bodyOf(const Pour& pour, const std::vector<Vec3>& corners, const std::vector<HullFace>& faces) {
    NewBody body;
    body.volume = pour.size * pour.size * pour.size;
    body.mass = dieDensity * body.volume;
    body.inertia = Vec3::Constant(inertiaOf(pour.die) * body.mass * pour.size * pour.size);
    ConvexPart part;
    Aabb bounds;
    for (const Vec3& corner : corners) {
        bounds.extend(corner);
    }
    part.box.halfExtents = 0.5 * bounds.sizes();
    part.box.centre = bounds.center();
    if (pour.die != Die::Cube) {
        part.points = corners;
    }
    body.shape = {part};
    body.smallestSide = 2.0 * faces.front().distance;
    return body;
}

/// A vessel that is being filled.
class Vessel {
public:
    Vessel(const Pour& pour, const Execution& execution)
        : m_pour(pour), m_execution(execution), m_corners(dieCorners(pour.die)), m_random(pour.seed) {
        for (Vec3& corner : m_corners) {
            corner *= pour.size;
        }
        m_faces = hullFaces(m_corners).faces;
        m_die = bodyOf(pour, m_corners, m_faces);
        WorldSettings settings;
        settings.pairs = PairTable::uniform(pour.friction, 0.1);
        settings.threads = execution.threads();
        settings.reach = Aabb(Vec3(-pour.width, -pour.width, 0.0), Vec3(pour.width, pour.width, 4.0 * pour.width));
        settings.cancelled = [execution] { return execution.cancelled(); };
        m_world = makeWorld(SolverKind::SoftStep, settings);
        addWalls();
    }

    double fill() {
        const int layers = (m_pour.dice + perLayer * perLayer - 1) / (perLayer * perLayer);
        for (int layer = 0; layer < layers; ++layer) {
            addLayer();
            run(betweenLayers);
        }
        run(restSeconds);
        return solidFraction();
    }

private:
    void addWalls() {
        const double width = m_pour.width, height = 6.0 * width, at = 0.5 * width + 0.5;
        for (const double side : {-1.0, 1.0}) {
            addWall({side * at, 0, 0.5 * height}, {1.0, width + 2.0, height});
            addWall({0, side * at, 0.5 * height}, {width, 1.0, height});
        }
    }

    void addWall(const Vec3& centre, const Vec3& size) {
        ConvexPart part;
        part.box.halfExtents = 0.5 * size;
        m_world->addPiece({part}, {centre, Quat::Identity()});
    }

    double top() const {
        double highest = 0.0;
        for (std::size_t i = 0; i < m_world->bodyCount(); ++i) {
            // What is on its way down lies on nothing yet.
            const BodyMotion motion = m_world->motion(idAt<BodyId>(i));
            if (motion.velocity.norm() < 1.0) {
                highest = std::max(highest, motion.pose.position.z());
            }
        }
        return highest;
    }

    void addLayer() {
        const double height = top() + dropHeight + 2.0 * m_pour.size;
        const double cell = (m_pour.width - 2.0 * m_pour.size) / perLayer;
        for (int i = 0; i < perLayer; ++i) {
            for (int j = 0; j < perLayer; ++j) {
                // Far enough from the neighbours, whatever way it is turned.
                const double free = 0.5 * (cell - 2.0 * m_pour.size);
                const double x = (i - 0.5 * (perLayer - 1)) * cell + m_random.between(-free, free);
                const double y = (j - 0.5 * (perLayer - 1)) * cell + m_random.between(-free, free);
                m_die.pose = {{x, y, height}, m_random.turn()};
                m_world->addBody(m_die);
            }
        }
    }

    void run(double seconds) {
        const auto steps = static_cast<int>(std::lround(seconds / stepSeconds));
        for (int i = 0; i < steps; ++i) {
            m_world->step(stepSeconds);
            m_execution.check();
        }
    }

    bool isSolid(const Vec3& place) const {
        for (std::size_t i = 0; i < m_world->bodyCount(); ++i) {
            const Pose pose = m_world->motion(idAt<BodyId>(i)).pose;
            const Vec3 own = pose.orientation.conjugate() * (place - pose.position);
            if (own.squaredNorm() < 4.0 * m_pour.size * m_pour.size &&
                std::all_of(m_faces.begin(), m_faces.end(),
                            [&](const HullFace& face) { return face.normal.dot(own) <= face.distance; })) {
                return true;
            }
        }
        return false;
    }

    double solidFraction() {
        const double half = 0.5 * m_pour.width - 1.5 * m_pour.size;
        const double low = 2.0 * m_pour.size, high = top() - 3.0 * m_pour.size;
        if (high <= low) {
            return unknown;
        }
        int solid = 0;
        for (int i = 0; i < probes; ++i) {
            solid += isSolid({m_random.between(-half, half), m_random.between(-half, half), m_random.between(low, high)});
        }
        return static_cast<double>(solid) / probes;
    }

    const Pour& m_pour;
    const Execution& m_execution;
    std::vector<Vec3> m_corners;
    std::vector<HullFace> m_faces;
    NewBody m_die;
    Sequence m_random;
    std::unique_ptr<RigidWorld> m_world;
};

}  // namespace

std::vector<Vec3> dieCorners(Die die) {
    auto [corners, volume] = regularBody(die);
    for (Vec3& corner : corners) {
        corner /= std::cbrt(volume);
    }
    return corners;
}

double pouredSolidFraction(const Pour& pour, const Execution& execution) {
    return Vessel(pour, execution).fill();
}

}  // namespace rubble
