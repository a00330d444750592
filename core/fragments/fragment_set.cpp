#include "core/fragments/fragment_set.h"

#include <algorithm>
#include <cmath>
#include <future>
#include <limits>
#include <string>

#include "core/base/error.h"
#include "core/fe/audit.h"
#include "core/fragments/birth_shift.h"
#include "core/fragments/birth_windows.h"
#include "core/fragments/corner_motion.h"
#include "core/fragments/element_place.h"
#include "core/fragments/element_solid.h"
#include "core/fragments/lifetimes.h"

namespace rubble {

namespace {

/// An exact death time may miss the interval that the states give by this share of it: files keep times in single precision.
constexpr double deathTimeSlack = 1e-3;
/// Cancel is looked at after so many fragments.
constexpr std::size_t checkInterval = 1024;

/// Reads the next state on a thread of its own while fragments are made of this one.
class StateAhead {
public:
    StateAhead(const FeResult& fe, bool threads) : m_fe(fe), m_threads(threads) {}

    void read(std::uint32_t state) {
        if (m_threads) {
            m_state = std::async(std::launch::async, [this, state] { return m_fe.state(state); });
        }
    }
    /// Until it is there. Who takes it from the result then meets what went wrong.
    void wait() {
        if (m_state.valid()) {
            m_state.wait();
            m_state = {};
        }
    }

private:
    const FeResult& m_fe;
    const bool m_threads;
    std::future<std::shared_ptr<const FeState>> m_state;
};

/// Makes the fragments of one FE result, one lifetime at a time.
class FragmentMaker {
public:
    FragmentMaker(const FeResult& fe, const Components& components, const FragmentSettings& settings)
        : m_fe(fe), m_components(components), m_settings(settings), m_motion(fe, settings.revival) {}

    FragmentSet make(const Execution& execution);

private:
    std::vector<Lifetime> handedOver(const Execution& execution);
    void noteWindow(const std::vector<Lifetime>& ended, double window);
    void addFragment(const Lifetime& life);
    void setTimes(Fragment& fragment, const Lifetime& life);
    double exactDeathTime(const Lifetime& life);
    double massOf(ElementIndex element, const SoundSolid& solid);
    void noteVelocity(const CornerMotion& motion, const Lifetime& life);
    void noteShape(const ElementSolid& element, const Lifetime& life);
    void append(Fragment& fragment, const SoundSolid& solid);
    void add(const char* id, const char* what, const char* remedy, const Lifetime& life);

    const FeResult& m_fe;
    const Components& m_components;
    const FragmentSettings& m_settings;
    CornerMotionReader m_motion;
    FragmentSet m_set;
};

FragmentSet FragmentMaker::make(const Execution& execution) {
    const Message stage{"fragments.progress", "Making fragments", {}};
    execution.report(stage, 0.0);
    const std::vector<Lifetime> lives = handedOver(execution);
    m_set.list.reserve(lives.size());
    m_set.solid.reserve(lives.size());
    m_set.vertices.reserve(8 * lives.size());
    m_set.vertexOffsets.reserve(lives.size() + 1);
    m_set.vertexOffsets.push_back(0);
    const std::vector<bool> needed = m_motion.statesNeeded(lives);
    std::vector<std::uint32_t> states;
    for (std::uint32_t state = 0; state < m_fe.stateCount(); ++state) {
        if (needed[state]) {
            states.push_back(state);
        }
    }
    std::size_t next = 0;
    StateAhead ahead(m_fe, execution.threads() > 1);
    for (std::size_t i = 0; i < states.size(); ++i) {
        const std::uint32_t state = states[i];
        ahead.wait();
        m_motion.advance(state);
        if (i + 1 < states.size()) {
            ahead.read(states[i + 1]);
        }
        for (; next < lives.size() && lives[next].lastActive == state; ++next) {
            if (next % checkInterval == 0) {
                execution.report(stage, static_cast<double>(next) / static_cast<double>(lives.size()));
            }
            addFragment(lives[next]);
        }
        execution.check();
    }
    execution.report(stage, 1.0);
    return std::move(m_set);
}

/// The lifetimes as they are handed over. Their order does not depend on the birth window.
std::vector<Lifetime> FragmentMaker::handedOver(const Execution& execution) {
    std::vector<Lifetime> lives = endedLifetimes(m_fe, m_components, m_settings.revival, m_set.findings, execution);
    const double window = birthWindowOf(m_settings);
    noteWindow(lives, window);
    const BirthWindows windows(lives, m_fe.times(), window);
    for (Lifetime& life : lives) {
        life.lastActive = windows.handOver(life.lastActive);
        life.firstDead = life.lastActive + 1;
    }
    return lives;
}

/// A window that is short for a collapse of seconds makes one birth of all of a blast.
void FragmentMaker::noteWindow(const std::vector<Lifetime>& ended, double window) {
    const WindowCover cover = coverOf(ended, m_fe.times(), window);
    if (!cover.wide()) {
        return;
    }
    m_set.findings.add(
        {"fragments.birth_window",
         "The birth window of {0} is long for a result that lasts {1}: deaths of {2} states become debris at {3}, up to {4} early",
         {{cover.window, "s"}, {cover.span, "s"}, cover.instants, cover.births, {cover.earliest, "s"}}},
        {"fragments.birth_window.remedy",
         "Set birth_window to a hundredth of that, {0}, as the default is of ten seconds, or to 0 for each state by itself.",
         {{fittingBirthWindow(cover.span), "s"}}});
}

void FragmentMaker::addFragment(const Lifetime& life) {
    const Mesh& mesh = m_fe.mesh();
    CornerMotion motion = m_motion.motionOf(life);
    if (!motion.finite) {
        add("fragments.no_position", "A dying element has positions that are not numbers and makes no fragment",
            "The result file is damaged there, or its solver diverged: its mass is missing from the debris.", life);
        return;
    }
    if (m_settings.birthShift != 0.0) {
        motion.positions.colwise() += birthShift(m_settings.birthShift, m_settings.seed, mesh.elementIds[at(life.element)]);
    }
    const LeastExtents extents{m_settings.minimumThicknessRatio, m_settings.minimumHalfExtent};
    const ElementSolid element = elementSolid(mesh, life.element, motion, m_components.section[at(life.element)], extents);
    const SoundSolid& solid = element.sound;

    Fragment fragment;
    fragment.element = life.element;
    fragment.component = m_components.of[at(life.element)];
    fragment.mass = massOf(life.element, solid);
    const RigidFit fit = fitRigidMotion(element, fragment.mass, extents);
    fragment.centre = fit.centre;
    fragment.inertia = fit.inertia;
    fragment.fe = fit.field;
    if (m_settings.birthVelocity == BirthVelocity::Fe) {
        fragment.velocity = fit.velocity;
        fragment.angularVelocity = fit.angularVelocity;
    }
    if (!fragment.inertia.allFinite() || !fragment.fe.angular.allFinite() || !std::isfinite(fragment.fe.kineticEnergy) ||
        !fit.angularVelocity.allFinite()) {
        add("fragments.out_of_range", "A dying element is too large or too fast for numbers and makes no fragment",
            "The result file is damaged there, or its solver diverged: its mass is missing from the debris.", life);
        return;
    }
    setTimes(fragment, life);
    noteVelocity(motion, life);
    noteShape(element, life);
    append(fragment, solid);
}

void FragmentMaker::setTimes(Fragment& fragment, const Lifetime& life) {
    const std::vector<double>& times = m_fe.times();
    fragment.handOverState = life.lastActive;
    fragment.birthState = life.firstDead;
    fragment.handOverTime = times[life.lastActive];
    fragment.birthTime = m_settings.birthTime == BirthTime::Exact ? exactDeathTime(life) : times[life.firstDead];
    fragment.endTime = life.backAt ? times[*life.backAt] : std::numeric_limits<double>::infinity();
}

double FragmentMaker::exactDeathTime(const Lifetime& life) {
    const std::vector<double>& exact = m_fe.contents().deathTime;
    const double before = m_fe.times()[life.lastActive];
    const double after = m_fe.times()[life.firstDead];
    const double time = exact.empty() ? std::numeric_limits<double>::quiet_NaN() : exact[at(life.element)];
    if (!std::isfinite(time)) {
        add("fragments.no_death_time", "No exact death time is known: the first state that reports the death is taken",
            "Set birth_time = state to treat all elements alike.", life);
        return after;
    }
    const double slack = deathTimeSlack * (after - before);
    if (time < before - slack || time > after + slack) {
        add("fragments.death_time_outside", "An exact death time lies outside the states between which the element dies",
            "The first state that reports the death is taken instead; birth_time = state does so for all.", life);
        return after;
    }
    return std::clamp(time, before, after);
}

double FragmentMaker::massOf(ElementIndex element, const SoundSolid& solid) {
    const double mass = m_components.mass(element);
    if (mass > 0.0 && std::isfinite(mass)) {
        return mass;
    }
    const double density = m_components.density[at(element)];
    const std::string& component = m_components.list[at(m_components.of[at(element)])].name;
    if (!(density > 0.0) || !std::isfinite(density)) {
        throw UsageError({"fragments.density",
                          "The density of element {0} (\"{1}\") is {2}",
                          {m_fe.mesh().elementIds[at(element)], component, {density, "kg/m3"}}},
                         {"fragments.density.remedy", "Set component[{0}].density to a positive number.", {component}});
    }
    const double volume = std::abs(consistentMass(asHexahedron(solid.shape, solid.corners), 1.0).volume);
    m_set.findings.add(
        {"fragments.no_volume_at_rest", "An element without volume at rest weighs what its fragment's solid would", {}},
        {"fragments.no_volume_at_rest.remedy", "Check the element's nodes, or its thickness or section.", {}},
        elementPlace(m_fe.mesh(), m_components, element, 0));
    return density * volume;
}

void FragmentMaker::noteVelocity(const CornerMotion& motion, const Lifetime& life) {
    if (motion.known == 0) {
        add("fragments.no_velocity", "The velocity of a dying element is not known: it is born at rest",
            "It was active at a single state of a result without velocities: ask the solver for velocities or for more states.",
            life);
    } else if (motion.known < motion.corners) {
        add("fragments.part_velocity", "The velocity of some corners of a dying element is not known",
            "They move with the mean of the others; ask the solver for velocities or for more states.", life);
    }
}

void FragmentMaker::noteShape(const ElementSolid& element, const Lifetime& life) {
    const SoundSolid& solid = element.sound;
    const SolidState state = element.unit.state;
    if (state == SolidState::Mirrored) {
        add("fragments.inverted", "An element is inside out at its death: its corners are numbered anew",
            "Check the node order of the element; a solver that lets elements invert may need other limits.", life);
    } else if (state == SolidState::Tangled) {
        add("fragments.tangled", "An element is folded through itself at its death: a box stands for it",
            "Let the solver delete such elements earlier if they matter.", life);
    } else if (state == SolidState::Collapsed) {
        add("fragments.collapsed", "An element has no volume at its death: a box of the minimum thickness stands for it",
            "Let the solver delete such elements earlier if they matter.", life);
    } else if (solid.boxed) {
        add("fragments.sliver", "An element is a sliver at its death: a box of the minimum thickness stands for it",
            "Let the solver delete such elements earlier if they matter.", life);
    } else if (const double atRest = m_components.volume[at(life.element)];
               atRest > 0.0 && isFarFromRest(std::abs(element.unit.volume) / atRest)) {
        add("fragments.far_from_rest",
            "An element has less than half or more than twice its volume at rest when it dies: its fragment has that volume, and "
            "the mass at rest",
            "Let the solver delete such elements earlier if they matter: their fragments are too dense or too light.", life);
    }
    if (solid.thickened && !solid.boxed) {
        add("fragments.thickened", "A fragment is thinner than the engine can bear: its solid is thickened, its mass is not",
            "Lower minimum_thickness_ratio or minimum_half_extent if stability allows it.", life);
    }
}

void FragmentMaker::append(Fragment& fragment, const SoundSolid& solid) {
    fragment.box = solid.box;
    fragment.bounds.setEmpty();
    for (int a = 0; a < cornerCount(solid.shape); ++a) {
        m_set.vertices.emplace_back(solid.corners.col(a));
        fragment.bounds.extend(m_set.vertices.back());
    }
    m_set.vertexOffsets.push_back(static_cast<std::uint32_t>(m_set.vertices.size()));
    m_set.solid.push_back(solid.shape);
    m_set.list.push_back(fragment);
}

void FragmentMaker::add(const char* id, const char* what, const char* remedy, const Lifetime& life) {
    m_set.findings.add({id, what, {}}, {std::string(id) + ".remedy", remedy, {}},
                       elementPlace(m_fe.mesh(), m_components, life.element, life.lastActive));
}

}  // namespace

FragmentSet makeFragments(const FeResult& fe, const Components& components, const FragmentSettings& settings,
                          const Execution& execution) {
    return FragmentMaker(fe, components, settings).make(execution);
}

}  // namespace rubble
