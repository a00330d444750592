#include "io/fe/result_frame.h"

#include <cmath>
#include <memory>
#include <optional>
#include <utility>

#include "core/base/error.h"
#include "core/base/standard_gravity.h"
#include "core/fe/frame_transform.h"
#include "core/fe/unit_evidence.h"
#include "io/fe/mesh_builder.h"

namespace rubble::io {

namespace {

// Frames are recorded in single precision, which resolves a millimetre up to here.
constexpr double farAway = 10000.0;   // m
constexpr double originStep = 100.0;  // m

/// A source of SI values in the local frame on top of one in units of the file.
class FramedSource : public StateSource {
public:
    FramedSource(std::shared_ptr<const StateSource> source, const Frame& frame, double seconds)
        : m_source(std::move(source)), m_frame(frame), m_seconds(seconds) {}

    FeState read(std::size_t k) const override {
        FeState state = m_source->read(k);
        state.time *= m_seconds;
        for (Vec3& position : state.positions) {
            position = m_frame.point(position);
        }
        for (Vec3& velocity : state.velocities) {
            velocity = m_frame.vector(velocity) / m_seconds;
        }
        return state;
    }

private:
    std::shared_ptr<const StateSource> m_source;
    FrameTransform m_frame;
    double m_seconds;
};

/// What was decided about a file, and why.
struct Decision {
    Frame frame;
    FileUnits units;
    std::string unitsWhy, axisWhy;
};

std::string englishUnits(const FileUnits& units) {
    if (const UnitSystem* system = systemOf(units)) {
        return std::string(system->id);
    }
    return "a unit of length of " + englishNumber(units.metres) + " m" +
           (units.kilograms > 0.0 ? "" : ", of mass by the densities");
}

// The frame alone says lengths. Centimetres and millimetres go with several units of mass, of which the densities tell one.
FileUnits unitsOf(const Frame& frame) {
    const bool metric = std::abs(frame.metresPerUnit - 0.001) < 1e-9 || std::abs(frame.metresPerUnit - 0.01) < 1e-9;
    const double volume = frame.metresPerUnit * frame.metresPerUnit * frame.metresPerUnit;
    return {frame.metresPerUnit, metric ? 0.0 : volume, 1.0};
}

/// Settles units and axis of one result.
class Decider {
public:
    Decider(const UnitEvidence& evidence, const ImportSettings& settings, const Frame& frame)
        : m_settings(settings), m_evidence(evidence) {
        m_decision.frame = frame;
        m_decision.units = unitsOf(frame);
        m_decision.unitsWhy = "by the frame of the case";
        m_decision.axisWhy = "by the frame of the case";
    }

    Decision decide(Findings& findings) {
        decideUnits(findings);
        decideUpAxis(findings);
        m_decision.frame.metresPerUnit = m_decision.units.metres;
        return std::move(m_decision);
    }

private:
    void decideUnits(Findings& findings) {
        std::string id(unitChoices()[m_settings.units]);
        if (decidedBy(m_settings.units) == Decided::ByFrame) {
            return;
        }
        m_decision.unitsWhy = "by the setting units";
        if (decidedBy(m_settings.units) == Decided::ByEvidence) {
            const Proposal proposal = proposeUnits(m_evidence);
            if (proposal.choice.empty()) {
                findings.add({"fe.units_open", "The units of the file cannot be told: {0}", {englishText(proposal.reason)}},
                             {"fe.units_open.remedy",
                              "Set units to the system of the analysis; the frame of the case holds until then.",
                              {}});
                return;
            }
            id = proposal.choice;
            m_decision.unitsWhy = englishText(proposal.reason);
        }
        for (const UnitSystem& system : unitSystems()) {
            if (system.id == id) {
                m_decision.units = system.units;
            }
        }
    }

    void decideUpAxis(Findings& findings) {
        if (decidedBy(m_settings.upAxis) == Decided::ByFrame) {
            return;
        }
        std::string axis(upAxisChoices()[m_settings.upAxis]);
        m_decision.axisWhy = "by the setting up_axis";
        if (decidedBy(m_settings.upAxis) == Decided::ByEvidence) {
            const Proposal proposal = proposeUpAxis(m_evidence);
            if (proposal.choice.empty()) {
                findings.add({"fe.up_axis_open", "The up axis of the file cannot be told: {0}", {englishText(proposal.reason)}},
                             {"fe.up_axis_open.remedy", "Set up_axis; the frame of the case holds until then.", {}});
                return;
            }
            axis = proposal.choice;
            m_decision.axisWhy = englishText(proposal.reason);
        }
        m_decision.frame.upAxis = axis;
    }

    const ImportSettings& m_settings;
    const UnitEvidence& m_evidence;
    Decision m_decision;
};

// The middle of a structure that lies far from the origin, in whole hundreds of metres of the file's axes.
std::optional<Eigen::Matrix<std::int64_t, 3, 1>> farOrigin(const Mesh& mesh, double metres) {
    Aabb bounds;
    for (const std::uint32_t node : mesh.corners) {
        bounds.extend(mesh.nodes[node] * metres);
    }
    const Vec3 middle = bounds.isEmpty() ? Vec3(Vec3::Zero()) : Vec3(bounds.center());
    // A structure whose size is nonsense is no place.
    if (middle.cwiseAbs().maxCoeff() <= farAway || implausibleSize(bounds.sizes().maxCoeff())) {
        return std::nullopt;
    }
    Eigen::Matrix<std::int64_t, 3, 1> origin;
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
        const bool isFar = std::abs(middle[axis]) > farAway;
        origin[axis] = isFar ? static_cast<std::int64_t>(std::round(middle[axis] / originStep) * originStep) : 0;
    }
    return origin;
}

std::shared_ptr<const Mesh> framedMesh(const Mesh& inFile, const FileUnits& units, const FrameTransform& transform,
                                       Findings& findings) {
    auto mesh = std::make_shared<Mesh>(inFile);
    for (Vec3& node : mesh->nodes) {
        node = transform.point(node);
    }
    for (std::size_t e = 0; e < mesh->elementCount(); ++e) {
        mesh->section[e] *= isShell(mesh->shapes[e]) ? units.metres : units.metres * units.metres;
        if (!(mesh->density[e] > 0.0)) {
            continue;
        }
        mesh->density[e] = units.kilograms > 0.0
                               ? mesh->density[e] * units.density()
                               : densityInSi(mesh->density[e], units.metres, findings, mesh->parts[mesh->part[e]].name);
    }
    return mesh;
}

// At opening, gravity is looked for where reading a few states costs little, or where somebody asks.
constexpr std::size_t mostNodesAtOnce = 100'000;

bool looksForFall(const FeResult::Contents& contents, const ImportSettings& settings) {
    return decidedBy(settings.units) == Decided::ByEvidence || decidedBy(settings.upAxis) == Decided::ByEvidence ||
           contents.mesh->nodeCount() <= mostNodesAtOnce;
}

UnitEvidence evidenceInMotion(const FeResult::Contents& contents, const ImportSettings& settings, const Execution& execution) {
    UnitEvidence evidence = evidenceOf(contents);
    if (looksForFall(contents, settings)) {
        try {
            addSeenFall(evidence, contents, execution);
        } catch (const ParseError&) {
            // A state that cannot be read is an error once somebody asks for it.
        } catch (const WorldError&) {
        }
    }
    return evidence;
}

// Gravity as the file shows it, against what was taken; it changes nothing by itself.
void noteFall(const FeResult::Contents& contents, const UnitEvidence& inFile, Findings& findings) {
    if (!fallsByGravity(inFile)) {
        return;
    }
    constexpr double gravity = standardGravity;
    const double times = inFile.fall->norm() * contents.units.acceleration() / gravity;
    const bool isGravity = times > 0.5 && times < 2.0;
    const Proposal up = proposeUpAxis(inFile);
    if (isGravity && !up.choice.empty() && up.choice != contents.frame.upAxis) {
        findings.add({"fe.up_axis_fall", "Up was taken to be {0}, but {1}", {contents.frame.upAxis, englishText(up.reason)}},
                     {"fe.up_axis_fall.remedy", "Set up_axis={0} unless something else drives them.", {up.choice}});
    }
    const Proposal units = proposeUnits(inFile);
    const UnitSystem* const taken = systemOf(contents.units);
    if (!isGravity && !units.choice.empty() && taken != nullptr && taken->id != units.choice) {
        findings.add({"fe.units_fall", "Things would fall at {0}", {{times * gravity, "m/s2"}}},
                     {"fe.units_fit.remedy", "Set units={0}. {1}.", {units.choice, englishText(units.reason)}});
    }
}

/// Ids of the systems that fit about as well as the one that was taken, or better.
std::string rivalsOf(const std::vector<UnitFit>& fits, const UnitSystem* taken) {
    std::string others;
    for (const std::string& id : rivalSystems(fits)) {
        if (taken == nullptr || id != taken->id) {
            others += (others.empty() ? "" : ", ") + id;
        }
    }
    return others;
}

// What nobody has chosen and the file does not decide, and what fits better than a choice. A choice among equals is a fact.
void noteRivals(FeResult::Contents& contents, const UnitEvidence& inFile, const ImportSettings& settings) {
    Findings& findings = contents.findings;
    for (const char* const said :
         {"fe.units_open", "fe.units_declared", "fe.units_fall", "fe.units.too_large", "fe.units.too_small"}) {
        if (findings.count(said) > 0) {
            return;
        }
    }
    const UnitSystem* const taken = systemOf(contents.units);
    const std::vector<UnitFit> fits = fitUnits(inFile);
    const std::string others = rivalsOf(fits, taken);
    if (others.empty()) {
        return;
    }
    const std::string now = englishUnits(contents.units);
    if (betterFit(fits, taken) != nullptr) {
        findings.add({"fe.units_better", "The file was taken to count in {0}; what it holds fits better: {1}", {now, others}},
                     {"fe.units_better.remedy", "Ask who made the analysis, and set the units of the file.", {}});
    } else if (decidedBy(settings.units) == Decided::ByName) {
        contents.unitsFrom += "; the file would fit " + others + " as well";
    } else {
        findings.add(
            {"fe.units_rivals",
             "Nobody has said which units the file counts in: it was taken to count in {0}, and would fit as well: {1}",
             {now, others}},
            {"fe.units_rivals.remedy", "Ask who made the analysis, and set the units of the file, also if they are these.", {}});
    }
}

std::string fallInWords(const UnitEvidence& inFile, const FileUnits& units) {
    if (!fallsByGravity(inFile)) {
        return {};
    }
    const double fall = inFile.fall->norm();
    return std::string(inFile.freely ? "; free nodes fall at " : "; what comes down gathers speed at ") + englishNumber(fall) +
           " in the file, " + englishNumber(fall * units.acceleration()) + " m/s2";
}

void notePlausibility(const FeResult::Contents& contents, const UnitEvidence& inFile, Findings& findings) {
    const std::optional<Message> size = implausibleSize(inFile.size * contents.units.metres);
    if (size) {
        const Proposal proposal = proposeUnits(inFile);
        findings.add(
            {"fe." + size->id, size->pattern, size->arguments},
            proposal.choice.empty()
                ? Message{"fe.units.remedy", "Set units to the system of the analysis. {0}.", {englishText(proposal.reason)}}
                : Message{"fe.units_fit.remedy", "Set units={0}. {1}.", {proposal.choice, englishText(proposal.reason)}});
    }
    if (contents.declared && (std::abs(contents.declared->metres / contents.units.metres - 1.0) > 1e-9 ||
                              std::abs(contents.declared->seconds / contents.units.seconds - 1.0) > 1e-9)) {
        findings.add({"fe.units_declared",
                      "The deck of the analysis counts in {0}, the file was taken to count in {1}",
                      {englishUnits(*contents.declared), englishUnits(contents.units)}},
                     {"fe.units_declared.remedy", "Set units={0}.", {englishUnits(*contents.declared)}});
    }
}

}  // namespace

void bringIntoFrame(FeResult::Contents& contents, const ImportSettings& settings, const Frame& frame, const Execution& execution) {
    const UnitEvidence inFile = evidenceInMotion(contents, settings, execution);
    Decision decision = Decider(inFile, settings, frame).decide(contents.findings);
    if (decision.frame.origin.isZero()) {
        if (const auto origin = farOrigin(*contents.mesh, decision.units.metres)) {
            decision.frame.origin = *origin;
            contents.findings.add({"fe.local_origin", "The structure lies far from the origin and was moved to a local one", {}},
                                  {"fe.local_origin.remedy", "Nothing to do: exports add it again.", {}},
                                  "(" + englishInteger(origin->x()) + ", " + englishInteger(origin->y()) + ", " +
                                      englishInteger(origin->z()) + ") m");
        }
    }
    contents.frame = decision.frame;
    contents.units = decision.units;
    contents.unitsFrom = englishUnits(decision.units) + " (" + decision.unitsWhy + "), up is " + decision.frame.upAxis + " (" +
                         decision.axisWhy + fallInWords(inFile, decision.units) + ")";
    notePlausibility(contents, inFile, contents.findings);
    noteFall(contents, inFile, contents.findings);
    noteRivals(contents, inFile, settings);
    const FrameTransform transform(decision.frame);
    Frame plain;
    plain.crs = decision.frame.crs;
    if (decision.frame == plain && decision.units == FileUnits{}) {
        return;
    }
    contents.mesh = framedMesh(*contents.mesh, decision.units, transform, contents.findings);
    for (double& time : contents.times) {
        time *= decision.units.seconds;
    }
    for (double& time : contents.deathTime) {
        time *= decision.units.seconds;
    }
    contents.source = std::make_shared<const FramedSource>(contents.source, decision.frame, decision.units.seconds);
}

}  // namespace rubble::io
