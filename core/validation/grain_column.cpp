#include "core/validation/grain_column.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <vector>

#include "core/base/same_bits.h"
#include "core/base/sequence.h"
#include "core/base/standard_gravity.h"
#include "core/engine/world/rigid_world.h"
#include "core/validation/box_overlap.h"
#include "core/validation/heap_form.h"

namespace rubble {

namespace {

constexpr double grainDensity = 2400.0;   // kg/m3
constexpr double grainStep = 1.0 / 60.0;  // s
constexpr double pouredFraction = 0.6;    // solid fraction that a column is poured for
constexpr int layersAtOnce = 6;           // few, so that none falls deep and none is born in another
constexpr double landingSeconds = 0.3;    // s, after a pour has come down
constexpr double standingSeconds = 2.0;   // s, before the vessel vanishes
constexpr int vesselSides = 16;
/// Walls that meet the grains without friction.
constexpr Material smoothWall = Material::Steel;

/// One column from its first grain to its deposit.
class ColumnScene {
public:
    ColumnScene(const GrainColumn& column, const Execution& execution)
        : m_column(column), m_execution(execution), m_random(column.seed) {
        WorldSettings settings;
        settings.pairs = PairTable::uniform(column.friction, 0.1);
        for (const Material other : {Material::Concrete, Material::Soil}) {
            settings.pairs.of(smoothWall, other) = {0.0, 0.1};
        }
        settings.threads = execution.threads();
        settings.cancelled = [execution] { return execution.cancelled(); };
        m_world = makeWorld(SolverKind::SoftStep, settings);
        const Vec3& sides = column.grain;
        const Vec3 squares = sides.cwiseProduct(sides);
        m_grain.volume = sides.prod();
        m_grain.mass = grainDensity * m_grain.volume;
        m_grain.inertia =
            m_grain.mass / 12.0 * Vec3(squares.y() + squares.z(), squares.x() + squares.z(), squares.x() + squares.y());
        ConvexPart part;
        part.box.halfExtents = 0.5 * sides;
        m_grain.shape = {part};
        m_grain.smallestSide = sides.minCoeff();
    }

    ColumnDeposit run() {
        addVessel();
        pour();
        ColumnDeposit deposit = standing();
        for (const PieceId wall : m_vessel) {
            m_world->removePiece(wall);
        }
        run(5.0 + 0.5 * std::sqrt(deposit.aspect * m_column.radius));
        measure(deposit);
        return deposit;
    }

private:
    double size() const { return cubeRootOf(m_grain.volume); }
    double area() const { return std::numbers::pi * m_column.radius * m_column.radius; }

    void addVessel() {
        const double radius = m_column.radius, tall = 3.0 * m_column.aspect * radius + 2.0 + layersAtOnce * m_column.grain.norm();
        ConvexPart part;
        // A side of the polygon around the circle, and some more, so that its corners are closed.
        part.box.halfExtents = {0.5, 1.05 * radius * std::tan(std::numbers::pi / vesselSides) + 0.2, 0.5 * tall};
        for (int i = 0; i < vesselSides; ++i) {
            const Quat turn(turnAbout(Vec3::UnitZ(), 2.0 * std::numbers::pi * i / vesselSides));
            m_vessel.push_back(m_world->addPiece({part}, {turn * Vec3(radius + 0.5, 0, 0.5 * tall), turn}, smoothWall));
        }
    }

    void pour() {
        // So far apart that none touches its neighbour or the vessel, whatever way it is turned.
        const double spacing = 1.02 * m_column.grain.norm(), within = m_column.radius - 0.5 * spacing;
        std::vector<Vec3> places;
        const auto reach = static_cast<int>(within / spacing);
        for (int i = -reach; i <= reach; ++i) {
            for (int j = -reach; j <= reach; ++j) {
                const Vec3 place(spacing * i, spacing * j, 0.0);
                if (place.norm() <= within) {
                    places.push_back(place);
                }
            }
        }
        const auto grains =
            static_cast<std::size_t>(std::lround(pouredFraction * area() * m_column.aspect * m_column.radius / m_grain.volume));
        while (m_world->bodyCount() < grains) {
            const double top = m_world->bodyCount() > 0 ? highest() : 0.0;
            for (int layer = 0; layer < layersAtOnce; ++layer) {
                for (std::size_t p = 0; p < places.size() && m_world->bodyCount() < grains; ++p) {
                    m_grain.pose = {places[p] + Vec3(0, 0, top + spacing * (layer + 1.0)), m_random.turn()};
                    m_world->addBody(m_grain);
                }
            }
            // What is still on its way down would be taken for the top.
            run(std::sqrt(2.0 * layersAtOnce * spacing / standardGravity) + landingSeconds);
        }
        run(standingSeconds);
    }

    double highest() const {
        double top = 0.0;
        for (std::size_t i = 0; i < m_world->bodyCount(); ++i) {
            top = std::max(top, m_world->motion(idAt<BodyId>(i)).pose.position.z());
        }
        return top;
    }

    void run(double seconds) {
        const auto steps = static_cast<int>(std::lround(seconds / grainStep));
        for (int i = 0; i < steps; ++i) {
            m_world->step(grainStep);
            m_execution.check();
        }
    }

    std::vector<OrientedBox> boxes() const {
        return placedBoxes(*m_world, std::vector<Vec3>(m_world->bodyCount(), m_column.grain));
    }

    ColumnDeposit standing() const {
        ColumnDeposit deposit;
        deposit.grains = static_cast<int>(m_world->bodyCount());
        double sum = 0.0, cells = 0.0;
        const double radius = m_column.radius;
        HeapSurface(boxes(), radius, radius).each([&](double x, double y, double top) {
            // The outermost ring has the gaps that any grain leaves at a wall.
            if (std::hypot(x, y) < radius - 0.5 * size()) {
                sum += std::max(top, 0.0);
                cells += 1.0;
            }
        });
        const double height = sum / cells;
        deposit.aspect = height / radius;
        deposit.solidFraction = deposit.grains * m_grain.volume / (area() * height);
        return deposit;
    }

    void measure(ColumnDeposit& deposit) const {
        const std::vector<OrientedBox> heap = joinedBoxes(boxes(), Vec3::Zero(), 0.5 * size());
        const double radius = m_column.radius;
        double reach = radius;
        for (const OrientedBox& box : heap) {
            reach = std::max(reach, box.centre.head<2>().norm() + box.halfExtents.norm());
        }
        HeapProfile profile(size());
        HeapSurface(heap, reach, reach).each([&](double x, double y, double top) { profile.add(std::hypot(x, y), top); });
        profile.finish();
        const double edge = meanFront(
            heap, vesselSides,
            [](const OrientedBox& box) {
                const double turns = std::atan2(box.centre.y(), box.centre.x()) / (2.0 * std::numbers::pi) + 0.5;
                return static_cast<std::size_t>(turns * vesselSides);
            },
            [&](const OrientedBox& box) { return box.centre.head<2>().norm() + 0.5 * size(); });
        deposit.runOut = (edge - radius) / radius;
        deposit.height = 0.5 * (profile.height()[0] + profile.height()[1]) / radius;
    }

    const GrainColumn& m_column;
    const Execution& m_execution;
    Sequence m_random;
    NewBody m_grain;
    std::vector<PieceId> m_vessel;
    std::unique_ptr<RigidWorld> m_world;
};

}  // namespace

ColumnDeposit collapseOf(const GrainColumn& column, const Execution& execution) {
    return ColumnScene(column, execution).run();
}

}  // namespace rubble
