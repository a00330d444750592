#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/base/standard_gravity.h"
#include "core/fe/components.h"
#include "core/fe/regrouping.h"
#include "core/scenario/materials.h"

namespace rubble {

enum class BirthTime { State, Exact };
enum class Revival { Latch, Follow, Refuse };
enum class BirthVelocity { Fe, Rest };
/// How the fragments of one birth become clusters.
enum class Grouping { Nested, Axes };
/// Auto is settled by shapeOfClusters().
enum class ClusterShape { AxisBox, OrientedBox, Hull, Compound, Bricks, Auto };
enum class PieceKind { None, ComponentBox, GridBoxes, Surface };
enum class SolverKind { SoftStep, Bullet };
enum class EffectSwitch { Off, On, Auto };
enum class LiveIslandPolicy { Released, Held };
/// Who moves live structure that has come loose: the FE result to its end, or the engine from then on.
enum class LooseStructurePolicy { Fe, AtOnce };

/// The optional physics of a scene, in the order in which it is listed everywhere.
enum class EffectKind : std::uint8_t { Ground, Terrain, StructureContact, FragmentContact, Water, AirDrag, Ties, BreakUp };
inline constexpr std::size_t effectCount = 8;

/// What the reader is told about the FE file; empty means: recognise it.
struct ImportSettings {
    std::string statusVariable;      ///< name of the active flag
    std::optional<int> activeValue;  ///< its value on active elements
    std::string displacement;        ///< prefix of the displacement components; "none": nodes do not move
    std::size_t units = 0;           ///< of the file, in the order of unitChoices()
    std::size_t upAxis = 0;          ///< of the file, in the order of upAxisChoices()
    bool onlyThisFile = false;       ///< files whose names differ in a number alone are no states
    std::string deadParts;           ///< parts whose elements are dead, by name or number, between semicolons
    friend bool operator==(const ImportSettings&, const ImportSettings&) = default;
};

struct FragmentSettings {
    BirthTime birthTime = BirthTime::State;
    Revival revival = Revival::Latch;
    double birthWindow = 0.1;  ///< s; what dies within it is handed over together, at the first state; 0: each state by itself
    BirthVelocity birthVelocity = BirthVelocity::Fe;
    double minimumThicknessRatio = 0.025;  ///< smallest half extent of a fragment over its longest
    double minimumHalfExtent = 0.005;      ///< m
    double birthShift = 0.0;               ///< m, every birth place moved at random by this much (repeat floor)
    std::int64_t seed = 1;                 ///< of the birth shift
    friend bool operator==(const FragmentSettings&, const FragmentSettings&) = default;
};

struct GridSettings {
    double fpsTarget = 24.0;        ///< live FPS
    std::int64_t bodiesMax = 4500;  ///< N_A^max
    double awakeTime = 10.0;        ///< s, longest that a body is taken to stay awake after its birth
    Grouping grouping = Grouping::Nested;
    std::optional<double> multiple;   ///< common multiple of the mean distance; unset: searched
    std::optional<double> length;     ///< l, m along x; unset: from the multiple
    std::optional<double> width;      ///< w, m along y
    std::optional<double> height;     ///< h, m along z
    bool acrossComponents = false;    ///< the paper's failure mode
    bool oneBodyPerFragment = false;  ///< the reference run
    double velocityTolerance = 0.5;   ///< m/s from the cluster's rigid motion; 0: no split
    friend bool operator==(const GridSettings&, const GridSettings&) = default;
};

struct SimulationSettings {
    SolverKind solver = SolverKind::SoftStep;
    std::optional<double> stepRate;  ///< steps per second at least; unset: by the size of the bodies
    std::optional<int> substeps;     ///< of a step, soft-step solver; unset: substepsOf()
    int iterations = 10;             ///< solver iterations per step, Bullet's solver
    ClusterShape shape = ClusterShape::Auto;
    double boxBulking = 1.0;  ///< largest volume of a cluster's box over that of its fragments' boxes
    PieceKind pieces = PieceKind::GridBoxes;
    double pieceSize = 4.0;                  ///< m, cells of the grid boxes
    double gravity = standardGravity;        ///< m/s2, downwards
    double groundHeight = 0.0;               ///< m
    std::optional<double> friction;          ///< of every pair of materials; unset: by pair
    std::optional<double> restitution;       ///< the same
    std::optional<double> frictionLevel;     ///< in the range of the source of each pair, 0 to 1; unset: the number of the table
    std::optional<double> restitutionLevel;  ///< the same
    bool freeze = true;
    double freezeSpeed = 0.02;          ///< m/s of the fastest corner
    double freezeDelay = 0.5;           ///< s below it
    double overlapSpeed = 1.5;          ///< m/s at which overlap at birth is brought apart
    std::optional<double> overlapTime;  ///< s; unset: overlapTimeOf()
    bool bounceFriction = false;        ///< impulses of a bounce rub as well, soft-step solver
    double settleTime = 10.0;           ///< s at most after the last FE state
    double frameRate = 25.0;            ///< recorded frames per second
    bool autoRemedy = false;            ///< halve the steps for a while after a health breach
    friend bool operator==(const SimulationSettings&, const SimulationSettings&) = default;
};

/// Effects and what each needs to know (DESIGN.md 2.5).
struct EffectSettings {
    std::array<EffectSwitch, effectCount> switches{EffectSwitch::Auto, EffectSwitch::Auto, EffectSwitch::Auto, EffectSwitch::Auto,
                                                   EffectSwitch::Auto, EffectSwitch::Auto, EffectSwitch::Auto, EffectSwitch::Auto};
    EffectSwitch& of(EffectKind kind) { return switches[static_cast<std::size_t>(kind)]; }
    EffectSwitch of(EffectKind kind) const { return switches[static_cast<std::size_t>(kind)]; }

    PairTable pairs;
    Material groundMaterial = Material::Soil;
    std::optional<double> waterLevel;  ///< m, z of the still surface; unset: no water
    double waterDensity = 1000.0;      ///< kg/m3
    double currentX = 0.0;             ///< m/s, of the water
    double currentY = 0.0;             ///< m/s
    double waterDrag = 1.05;           ///< C_d of a box in water
    double waterLinearDrag = 0.5;      ///< 1/s, of the displaced mass, near rest
    double addedMass = 0.5;            ///< share of the displaced mass that moves along
    double airDensity = 1.225;         ///< kg/m3
    double airDrag = 1.05;             ///< C_d of a box in air
    double tieRatio = 0.01;            ///< steel area over the area of a shared face
    double tieStrength = 500e6;        ///< Pa, f_y
    double tieElongation = 0.15;       ///< of the length of the tie, at which it breaks
    double breakUpSpeed = 6.0;         ///< m/s, impulse per mass above which a cluster of stone or masonry breaks up
    LiveIslandPolicy islands = LiveIslandPolicy::Released;
    LooseStructurePolicy loose = LooseStructurePolicy::AtOnce;
    double terrainRoughness = 0.0;   ///< m, mean height of obstacles that the raster does not hold
    double roughnessSpacing = 0.25;  ///< m, between them
    std::int64_t roughnessSeed = 1;
    friend bool operator==(const EffectSettings&, const EffectSettings&) = default;
};

/// Everything a user can set for one run, as one value. Every member is reached through the parameter table
/// (core/scenario/parameters.h), except the list of regrouping steps, which is a structure of its own.
struct Scenario {
    ImportSettings import;
    std::vector<RegroupStep> regrouping;
    std::map<std::string, ComponentSettings> components;  ///< by component name, after regrouping
    MaterialAssumptions assumptions;
    FragmentSettings fragments;
    GridSettings grid;
    SimulationSettings simulation;
    EffectSettings effects;

    friend bool operator==(const Scenario&, const Scenario&) = default;
};

/// Parts in which the soft-step solver takes a step: 4, or 12 where the engine moves loose structure. What lies under spans that
/// are a hundred times as heavy trembles and sinks in longer ones (docs/solver.md).
inline int substepsOf(const Scenario& scenario) {
    return scenario.simulation.substeps.value_or(scenario.effects.loose == LooseStructurePolicy::Fe ? 4 : 12);
}
/// The same from the end of the FE result on, when few spans are left that press on debris and little still falls.
inline int settlingSubstepsOf(const Scenario& scenario) {
    return scenario.simulation.substeps.value_or(scenario.effects.loose == LooseStructurePolicy::Fe ? 4 : 8);
}

/// s, for which overlap at birth is brought apart: 7 for each contact, or 1 from when the later of two bodies was born where the
/// engine moves loose structure. What falls there goes on being pressed together; a pile that is parted meanwhile does not rest.
inline double overlapTimeOf(const Scenario& scenario) {
    return scenario.simulation.overlapTime.value_or(scenario.effects.loose == LooseStructurePolicy::Fe ? 7.0 : 1.0);
}

/// Friction and restitution of every pair of materials as a run takes them: at its levels, less what was set for pairs or for all.
inline PairTable actingPairs(const Scenario& scenario) {
    const SimulationSettings& s = scenario.simulation;
    return scenario.effects.pairs.atLevels(s.frictionLevel, s.restitutionLevel).overriddenBy(s.friction, s.restitution);
}

/// The collision shape that clusters take, settled where it is left to the program.
inline ClusterShape shapeOfClusters(const Scenario& scenario) {
    if (scenario.simulation.shape != ClusterShape::Auto) {
        return scenario.simulation.shape;
    }
    return scenario.effects.loose == LooseStructurePolicy::Fe ? ClusterShape::OrientedBox : ClusterShape::Bricks;
}

}  // namespace rubble
