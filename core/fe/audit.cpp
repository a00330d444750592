#include "core/fe/audit.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <functional>
#include <string_view>

namespace rubble {

namespace {

constexpr std::size_t never = static_cast<std::size_t>(-1);

// An element this thin against its longest edge gives a poor solid; below `zeroRatio` its volume is rounding.
constexpr double sliverRatio = 0.025;
constexpr double zeroRatio = 1e-6;
// Files often keep single precision: a death time may miss its bracket by its rounding.
constexpr double timeRounding = 1e-6;
constexpr double leastVolumeRatio = 0.5;
constexpr double greatestVolumeRatio = 2.0;

std::string placeOf(const FeResult& fe, const Components& components, std::size_t e) {
    return "element " + englishInteger(fe.mesh().elementIds[e]) + " (" + components.list[at(components.of[e])].name + ")";
}

std::string atState(const FeResult& fe, std::size_t k) {
    return " at state " + englishInteger(static_cast<std::int64_t>(k)) + " (" + englishNumber(fe.times()[k]) + " s)";
}

/// Counts anomalies by kind; kinds stay in the order in which they were first met.
class AnomalyCounter {
public:
    /// @param example  makes the text; only asked for the first of a kind, of which there may be very many
    void add(std::string_view kind, const std::function<std::string()>& example) {
        const auto known = std::find_if(m_list.begin(), m_list.end(), [&](const Anomaly& a) { return a.kind == kind; });
        if (known == m_list.end()) {
            m_list.push_back({std::string(kind), 1, example()});
        } else {
            ++known->count;
        }
    }

    std::vector<Anomaly> take() { return std::move(m_list); }

private:
    std::vector<Anomaly> m_list;
};

/// When an element was active, reduced to what the audit asks.
struct Life {
    std::size_t firstActive = never;
    std::size_t lastActiveBeforeDeath = never;  ///< of its first death
    std::size_t revivedAt = never;
};

Life lifeOf(const Activity& activity, std::size_t e) {
    Life life;
    const ElementIndex id = idAt<ElementIndex>(e);
    for (std::size_t k = 0; k < activity.states(); ++k) {
        const bool active = activity.active(k, id);
        if (active && life.firstActive == never) {
            life.firstActive = k;
        }
        const bool before = k > 0 && activity.active(k - 1, id);
        if (!active && before && life.lastActiveBeforeDeath == never) {
            life.lastActiveBeforeDeath = k - 1;
        }
        if (active && !before && life.lastActiveBeforeDeath != never && life.revivedAt == never) {
            life.revivedAt = k;
        }
    }
    return life;
}

// Longest distance between two corners, and the area of the largest face.
std::pair<double, double> lengthAndFace(ElementShape shape, std::span<const Vec3> x) {
    double length = 0.0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        for (std::size_t j = i + 1; j < x.size(); ++j) {
            length = std::max(length, (x[i] - x[j]).norm());
        }
    }
    double face = 0.0;
    for (const auto& f : facesOf(shape)) {
        const auto corner = [&](std::size_t i) { return x[static_cast<std::size_t>(f[i])]; };
        const Vec3 across = f[3] < 0 ? (corner(1) - corner(0)).cross(corner(2) - corner(0)).eval()
                                     : (corner(2) - corner(0)).cross(corner(3) - corner(1)).eval();
        face = std::max(face, 0.5 * across.norm());
    }
    return {length, face};
}

/// Judges the last active shape of dying elements.
class ShapeAudit {
public:
    ShapeAudit(const FeResult& fe, const Components& components, AnomalyCounter& anomalies)
        : m_fe(fe), m_components(components), m_anomalies(anomalies) {}

    void judge(std::size_t e, std::size_t k, const FeState& state) {
        const Mesh& mesh = m_fe.mesh();
        const ElementShape shape = mesh.shapes[e];
        std::array<Vec3, 8> space;
        std::size_t n = 0;
        for (const std::uint32_t node : mesh.cornersOf(idAt<ElementIndex>(e))) {
            space[n++] = state.positions[node];
        }
        const std::span<const Vec3> x(space.data(), n);
        const auto [length, face] = lengthAndFace(shape, x);
        // Shells and beams are judged by area and length: the thickness given to them is not geometry.
        const double measure = elementVolume(shape, x, 1.0);
        const double scale = isSolid(shape) ? length * length * length : isShell(shape) ? length * length : 1.0;
        const double thickness = isSolid(shape)   ? (face > 0.0 ? std::abs(measure) / face : 0.0)
                                 : isShell(shape) ? measure / length
                                                  : 1.0;
        const auto place = [&] { return placeOf(m_fe, m_components, e) + atState(m_fe, k); };
        if (!(std::abs(measure) > zeroRatio * scale) || !(length > 0.0)) {
            m_anomalies.add("zero_volume", place);
            return;
        }
        if (measure < 0.0) {
            m_anomalies.add("inverted", place);
        }
        if (shape != ElementShape::Beam && thickness < sliverRatio * length) {
            m_anomalies.add("sliver", [&] { return place() + ", " + englishNumber(thickness / length) + " thick per length"; });
        }
        const double section = m_components.section[e];
        const double ratio = measure * (isSolid(shape) ? 1.0 : section) / m_components.volume[e];
        if (measure > 0.0 && isFarFromRest(ratio)) {
            m_anomalies.add("large_distortion", [&] { return place() + ", " + englishNumber(ratio) + " times its first volume"; });
        }
    }

private:
    const FeResult& m_fe;
    const Components& m_components;
    AnomalyCounter& m_anomalies;
};

void auditLives(const FeResult& fe, const Components& components, const std::vector<Life>& lives, AnomalyCounter& anomalies) {
    for (std::size_t e = 0; e < lives.size(); ++e) {
        const Life& life = lives[e];
        if (life.firstActive != 0) {
            anomalies.add("inactive_from_start", [&] { return placeOf(fe, components, e); });
            if (life.firstActive != never) {
                anomalies.add("activated_later", [&] { return placeOf(fe, components, e) + atState(fe, life.firstActive); });
            }
        }
        if (life.revivedAt != never) {
            anomalies.add("revived", [&] { return placeOf(fe, components, e) + atState(fe, life.revivedAt); });
        }
    }
}

void auditDeathTimes(const FeResult& fe, const Components& components, const std::vector<Life>& lives, AnomalyCounter& anomalies) {
    const std::vector<double>& exact = fe.contents().deathTime;
    for (std::size_t e = 0; e < exact.size(); ++e) {
        const std::size_t k = lives[e].lastActiveBeforeDeath;
        if (k == never) {
            if (!std::isnan(exact[e]) && lives[e].firstActive == 0) {
                anomalies.add("death_time_of_active",
                              [&] { return placeOf(fe, components, e) + ", " + englishNumber(exact[e]) + " s"; });
            }
            continue;
        }
        if (std::isnan(exact[e])) {
            anomalies.add("no_death_time", [&] { return placeOf(fe, components, e) + atState(fe, k + 1); });
            continue;
        }
        const double slack = timeRounding * std::max(std::abs(exact[e]), fe.times()[k + 1] - fe.times()[k]);
        if (exact[e] < fe.times()[k] - slack || exact[e] > fe.times()[k + 1] + slack) {
            anomalies.add("death_outside_bracket", [&] {
                return placeOf(fe, components, e) + ", " + englishNumber(exact[e]) + " s, but reported" + atState(fe, k + 1);
            });
        }
    }
}

void auditMaterial(const FeResult& fe, const Components& components, AnomalyCounter& anomalies) {
    const Mesh& mesh = fe.mesh();
    for (std::size_t e = 0; e < mesh.elementCount(); ++e) {
        if (!(mesh.density[e] > 0.0)) {
            anomalies.add("no_density", [&] { return placeOf(fe, components, e); });
        }
        if (!isSolid(mesh.shapes[e]) && !(mesh.section[e] > 0.0)) {
            anomalies.add("no_section", [&] { return placeOf(fe, components, e); });
        }
        if (!(components.volume[e] > 0.0)) {
            anomalies.add("zero_volume_at_rest", [&] { return placeOf(fe, components, e); });
        }
    }
}

void auditShapes(const FeResult& fe, const Components& components, const std::vector<Life>& lives, AnomalyCounter& anomalies,
                 const Execution& execution) {
    std::vector<std::vector<std::size_t>> dying(fe.stateCount());
    for (std::size_t e = 0; e < lives.size(); ++e) {
        if (lives[e].lastActiveBeforeDeath != never) {
            dying[lives[e].lastActiveBeforeDeath].push_back(e);
        }
    }
    ShapeAudit shapes(fe, components, anomalies);
    const Message stage{"audit.progress", "Auditing deaths", {}};
    for (std::size_t k = 0; k < dying.size(); ++k) {
        execution.report(stage, static_cast<double>(k) / static_cast<double>(dying.size()));
        if (dying[k].empty()) {
            continue;
        }
        const auto state = fe.state(k);
        for (const std::size_t e : dying[k]) {
            shapes.judge(e, k, *state);
        }
    }
    execution.report(stage, 1.0);
}

}  // namespace

bool isFarFromRest(double ratio) {
    return !(ratio >= leastVolumeRatio && ratio <= greatestVolumeRatio);
}

Audit auditDeaths(const FeResult& fe, const Components& components, const Execution& execution) {
    const Mesh& mesh = fe.mesh();
    const Activity& activity = fe.activity();
    Audit audit;
    for (const Component& component : components.list) {
        audit.components.push_back({component.name, component.kind, static_cast<std::int64_t>(component.elements.size()), 0,
                                    component.density, component.mass, 0.0});
        audit.mass += component.mass;
    }
    std::vector<Life> lives(mesh.elementCount());
    audit.deadPerState.assign(fe.stateCount(), 0);
    for (std::size_t e = 0; e < mesh.elementCount(); ++e) {
        const ElementIndex id = idAt<ElementIndex>(e);
        lives[e] = lifeOf(activity, e);
        for (std::size_t k = 0; k < fe.stateCount(); ++k) {
            audit.deadPerState[k] += lives[e].firstActive < k && !activity.active(k, id);
        }
        if (fe.stateCount() > 0 && lives[e].firstActive != never && !activity.active(fe.stateCount() - 1, id)) {
            ComponentAudit& component = audit.components[at(components.of[e])];
            ++component.dead;
            component.deadMass += components.mass(id);
            audit.deadMass += components.mass(id);
        }
    }
    audit.deadTotal = audit.deadPerState.empty() ? 0 : audit.deadPerState.back();

    AnomalyCounter anomalies;
    auditLives(fe, components, lives, anomalies);
    auditDeathTimes(fe, components, lives, anomalies);
    auditMaterial(fe, components, anomalies);
    auditShapes(fe, components, lives, anomalies, execution);
    audit.anomalies = anomalies.take();
    return audit;
}

}  // namespace rubble
