#include "core/fe/unit_evidence.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/standard_gravity.h"
#include "core/fe/frame_transform.h"
#include "core/fe/material.h"

namespace rubble {

namespace {

constexpr double clearlyBetter = 3.0;   // of scores
constexpr std::size_t mostTriples = 4;  // of states that free fall is looked for in
constexpr std::size_t mostFallers = 4000;
constexpr double alikeFall = 0.05;  // of the median
constexpr double shareOfFallers = 0.25;

/// Densities of what is built and shot at, kg/m3; `usual` is what collapses are made of.
struct KnownMaterial {
    std::string_view words;
    double low, high;
    bool usual;
};

constexpr std::array materials{
    KnownMaterial{"usual for concrete", 2150.0, 2550.0, true},     KnownMaterial{"usual for steel", 7600.0, 8100.0, true},
    KnownMaterial{"usual for stone", 2550.0, 3100.0, true},        KnownMaterial{"usual for masonry", 1400.0, 2150.0, true},
    KnownMaterial{"usual for timber", 350.0, 900.0, true},         KnownMaterial{"usual for cast iron", 7000.0, 7400.0, true},
    KnownMaterial{"usual for soil or fill", 900.0, 1400.0, false}, KnownMaterial{"usual for titanium", 4400.0, 4600.0, false},
    KnownMaterial{"usual for copper", 8700.0, 9000.0, false},      KnownMaterial{"usual for lead", 11200.0, 11450.0, false},
    KnownMaterial{"usual for tungsten", 17000.0, 19400.0, false},
};

// Nodes that belong to elements, all of which are inactive at a state although they were active at the first.
std::vector<std::uint32_t> freeNodes(const FeResult::Contents& contents, std::size_t k) {
    const Mesh& mesh = *contents.mesh;
    std::vector<std::uint8_t> kind(mesh.nodeCount(), 0);  // 1: of dead elements, 2: held
    for (std::size_t e = 0; e < mesh.elementCount(); ++e) {
        const auto element = idAt<ElementIndex>(e);
        const bool dead = !contents.activity.active(k, element) && contents.activity.active(0, element);
        for (const std::uint32_t node : mesh.cornersOf(element)) {
            kind[node] = std::max<std::uint8_t>(kind[node], dead ? 1 : 2);
        }
    }
    std::vector<std::uint32_t> nodes;
    for (std::size_t n = 0; n < kind.size(); ++n) {
        if (kind[n] == 1) {
            nodes.push_back(static_cast<std::uint32_t>(n));
        }
    }
    return nodes;
}

// Three states that follow each other, from the first with free nodes on, spread over the rest.
std::vector<std::size_t> triples(const FeResult::Contents& contents) {
    const std::size_t states = contents.times.size();
    std::size_t first = 0;
    while (first + 3 <= states && freeNodes(contents, first).empty()) {
        ++first;
    }
    std::vector<std::size_t> starts;
    for (std::size_t i = 0; first + 3 <= states && i < mostTriples; ++i) {
        const std::size_t start = first + (states - 3 - first) * i / (mostTriples - 1);
        if (starts.empty() || starts.back() != start) {
            starts.push_back(start);
        }
    }
    return starts;
}

double median(std::vector<double> values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

Vec3 medianOf(const std::vector<Vec3>& vectors) {
    Vec3 result;
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
        std::vector<double> values;
        values.reserve(vectors.size());
        for (const Vec3& vector : vectors) {
            values.push_back(vector[axis]);
        }
        result[axis] = median(std::move(values));
    }
    return result;
}

void addAccelerations(const FeResult::Contents& contents, std::size_t k, std::vector<Vec3>& accelerations) {
    const std::vector<std::uint32_t> nodes = freeNodes(contents, k);
    const std::size_t stride = nodes.size() / (mostFallers / mostTriples) + 1;
    const std::vector<double>& t = contents.times;
    const std::array states{contents.source->read(k), contents.source->read(k + 1), contents.source->read(k + 2)};
    for (std::size_t i = 0; i < nodes.size(); i += stride) {
        const std::uint32_t n = nodes[i];
        const Vec3 before = (states[1].positions[n] - states[0].positions[n]) / (t[k + 1] - t[k]);
        const Vec3 after = (states[2].positions[n] - states[1].positions[n]) / (t[k + 2] - t[k + 1]);
        accelerations.emplace_back((after - before) / (0.5 * (t[k + 2] - t[k])));
    }
}

// What falls freely falls alike: a good share of the nodes must agree with the median.
std::optional<Vec3> freeFall(const FeResult::Contents& contents, const Execution& execution) {
    std::vector<Vec3> accelerations;
    for (const std::size_t k : triples(contents)) {
        execution.check();
        addAccelerations(contents, k, accelerations);
    }
    if (accelerations.size() < 3) {
        return std::nullopt;
    }
    const Vec3 middle = medianOf(accelerations);
    const double tolerance = alikeFall * middle.norm();
    std::vector<Vec3> alike;
    for (const Vec3& acceleration : accelerations) {
        if ((acceleration - middle).norm() <= tolerance) {
            alike.push_back(acceleration);
        }
    }
    const bool agreed = middle.norm() > 0.0 && static_cast<double>(alike.size()) >=
                                                   std::max(3.0, shareOfFallers * static_cast<double>(accelerations.size()));
    return agreed ? std::optional<Vec3>(medianOf(alike)) : std::nullopt;
}

// @param acceleration  m/s2, of something that is held in part
bool nearGravity(double acceleration) {
    return acceleration > 0.5 * standardGravity && acceleration < 2.0 * standardGravity;
}

/// Accelerations of nodes that have left their place and gather speed along their way.
class GatheredSpeed {
public:
    GatheredSpeed(const FeResult::Contents& contents, double size, const Execution& execution)
        : m_contents(contents), m_size(size) {
        const std::size_t states = contents.times.size();
        for (std::size_t i = 0; states >= 4 && i < mostLooks; ++i) {
            const std::size_t start = 1 + (states - 4) * i / (mostLooks - 1);
            if (i == 0 || start != m_last) {
                execution.check();
                look(start);
            }
            m_last = start;
        }
    }

    std::optional<Vec3> median() const {
        const std::size_t fewest = std::max<std::size_t>(8, m_looked / 200);
        if (m_found.size() < fewest) {
            return std::nullopt;
        }
        const Vec3 middle = medianOf(m_found);
        std::vector<double> along;
        for (const Vec3& acceleration : m_found) {
            along.push_back(acceleration.dot(middle.normalized()));
        }
        std::sort(along.begin(), along.end());
        const double spread = along[along.size() * 3 / 4] - along[along.size() / 4];
        return middle.norm() > 0.0 && spread <= middle.norm() ? std::optional<Vec3>(middle) : std::nullopt;
    }

private:
    static constexpr std::size_t mostLooks = 8, mostNodes = 20000;
    static constexpr double leftPlace = 0.01;  // of the size
    static constexpr double moving = 0.001;    // of the size, from a state to the next
    static constexpr double alongItsWay = 0.8;

    void look(std::size_t k) {
        const std::vector<double>& t = m_contents.times;
        const std::array states{m_contents.source->read(k), m_contents.source->read(k + 1), m_contents.source->read(k + 2)};
        const std::size_t nodes = states[0].positions.size(), stride = nodes / mostNodes + 1;
        for (std::size_t n = 0; n < nodes; n += stride) {
            ++m_looked;
            const Vec3 way = states[1].positions[n] - states[0].positions[n];
            const Vec3 before = way / (t[k + 1] - t[k]);
            const Vec3 after = (states[2].positions[n] - states[1].positions[n]) / (t[k + 2] - t[k + 1]);
            const Vec3 acceleration = (after - before) / (0.5 * (t[k + 2] - t[k]));
            if ((states[0].positions[n] - m_contents.mesh->nodes[n]).norm() > leftPlace * m_size && way.norm() > moving * m_size &&
                before.dot(acceleration) > alongItsWay * before.norm() * acceleration.norm()) {
                m_found.push_back(acceleration);
            }
        }
    }

    const FeResult::Contents& m_contents;
    double m_size;
    std::size_t m_last = 0, m_looked = 0;
    std::vector<Vec3> m_found;
};

/// Weighs one system against the evidence.
class Fitting {
public:
    Fitting(const UnitSystem& system, const UnitEvidence& evidence) : m_evidence(evidence), m_units(system.units) {
        m_fit.system = &system;
        weighDeclared();
        weighDensities();
        weighSize();
        weighFall();
        weighDuration();
    }

    UnitFit take() { return std::move(m_fit); }

private:
    void weighDeclared() {
        if (m_evidence.declared && systemOf(*m_evidence.declared) == m_fit.system) {
            add(8.0, {"units.declared", "the file or a deck beside it says so", {}});
        }
    }

    void weighDensities() {
        double sum = 0.0;
        for (const UnitEvidence::Density& density : m_evidence.densities) {
            const double si = density.value * m_units.density();
            const auto known = std::find_if(materials.begin(), materials.end(), [&](const KnownMaterial& material) {
                return si >= material.low && si <= material.high;
            });
            const bool possible = isMaterialDensity(si);
            sum += known != materials.end() ? (known->usual ? 4.0 : 2.0) : possible ? 0.0 : -8.0;
            if (&density == &m_evidence.densities.front()) {
                m_fit.reasons.push_back({"units.density",
                                         "density {0} of \"{1}\" is {2}, {3}",
                                         {density.value,
                                          density.part,
                                          {si, "kg/m3"},
                                          known != materials.end() ? known->words
                                          : possible               ? "no usual material"
                                                                   : "no material"}});
            }
        }
        if (!m_evidence.densities.empty()) {
            m_fit.score += sum / static_cast<double>(m_evidence.densities.size());
        }
    }

    void weighSize() {
        const double si = m_evidence.size * m_units.metres;
        const double score = si >= 0.5 && si <= 2000.0    ? 2.0
                             : si >= 0.02 && si <= 5000.0 ? 0.5
                             : si >= 0.005 && si <= 2e4   ? -1.0
                                                          : -4.0;
        add(score, {"units.size", "size {0} is {1}", {m_evidence.size, {si, "m"}}});
    }

    void weighFall() {
        if (fallsByGravity(m_evidence)) {
            const double inFile = m_evidence.fall->norm();
            const double si = inFile * m_units.acceleration();
            const double off = std::abs(si / standardGravity - 1.0);
            if (!m_evidence.freely) {
                // Held in part, or driven by something else: near gravity it speaks for a system, elsewhere against none.
                add(nearGravity(si) ? 3.0 : 0.0,
                    {"units.gathered", "what comes down gathers speed at {0}, which is {1}", {inFile, {si, "m/s2"}}});
                return;
            }
            add(off < 0.02  ? 8.0
                : off < 0.3 ? 2.0
                            : -4.0,
                {"units.fall", "free nodes fall at {0}, which is {1}", {inFile, {si, "m/s2"}}});
        }
    }

    void weighDuration() {
        const double si = m_evidence.duration * m_units.seconds;
        if (si > 0.0) {
            add(si >= 0.02 && si <= 300.0    ? 1.0
                : si >= 1e-5 && si <= 3600.0 ? 0.0
                                             : -3.0,
                {"units.duration", "{0} of time are {1}", {m_evidence.duration, {si, "s"}}});
        }
    }

    void add(double score, Message reason) {
        m_fit.score += score;
        m_fit.reasons.push_back(std::move(reason));
    }

    const UnitEvidence& m_evidence;
    FileUnits m_units;
    UnitFit m_fit;
};

std::string joined(const std::vector<Message>& reasons) {
    std::string text;
    for (const Message& reason : reasons) {
        text += (text.empty() ? "" : "; ") + englishText(reason);
    }
    return text;
}

}  // namespace

UnitEvidence evidenceOf(const FeResult::Contents& contents) {
    const Mesh& mesh = *contents.mesh;
    UnitEvidence evidence;
    std::vector<bool> known(mesh.parts.size(), false);
    Aabb bounds;
    for (std::size_t e = 0; e < mesh.elementCount(); ++e) {
        if (mesh.density[e] > 0.0 && !known[mesh.part[e]]) {
            known[mesh.part[e]] = true;
            evidence.densities.push_back({mesh.parts[mesh.part[e]].name, mesh.density[e]});
        }
        for (const std::uint32_t node : mesh.cornersOf(idAt<ElementIndex>(e))) {
            bounds.extend(mesh.nodes[node]);
        }
    }
    evidence.size = bounds.isEmpty() ? 0.0 : bounds.sizes().maxCoeff();
    evidence.duration = contents.times.empty() ? 0.0 : contents.times.back() - contents.times.front();
    evidence.declared = contents.declared;
    return evidence;
}

void addSeenFall(UnitEvidence& evidence, const FeResult::Contents& contents, const Execution& execution) {
    if (!contents.source) {
        return;
    }
    evidence.fall = freeFall(contents, execution);
    evidence.freely = evidence.fall.has_value();
    if (!evidence.fall) {
        evidence.fall = GatheredSpeed(contents, evidence.size, execution).median();
    }
}

bool fallsByGravity(const UnitEvidence& evidence) {
    const auto systems = unitSystems();
    return evidence.fall && (evidence.freely || std::any_of(systems.begin(), systems.end(), [&](const UnitSystem& system) {
                                 return nearGravity(evidence.fall->norm() * system.units.acceleration());
                             }));
}

UnitEvidence evidenceInFile(UnitEvidence evidence, const FileUnits& units, const Frame& frame) {
    if (units.kilograms > 0.0) {
        for (UnitEvidence::Density& density : evidence.densities) {
            density.value /= units.density();
        }
    } else {
        evidence.densities.clear();
    }
    evidence.size /= units.metres;
    evidence.duration /= units.seconds;
    if (evidence.fall) {
        const FrameTransform transform(frame);
        evidence.fall =
            (transform.pointInFile(*evidence.fall) - transform.pointInFile(Vec3::Zero())) * units.seconds * units.seconds;
    }
    return evidence;
}

std::vector<UnitFit> fitUnits(const UnitEvidence& evidence) {
    std::vector<UnitFit> fits;
    for (const UnitSystem& system : unitSystems()) {
        fits.push_back(Fitting(system, evidence).take());
    }
    std::stable_sort(fits.begin(), fits.end(), [](const UnitFit& a, const UnitFit& b) { return a.score > b.score; });
    return fits;
}

const UnitFit* betterFit(const std::vector<UnitFit>& fits, const UnitSystem* now) {
    if (fits.empty() || fits.front().score <= 0.0) {
        return nullptr;
    }
    const bool asGood = std::any_of(fits.begin(), fits.end(), [&](const UnitFit& fit) {
        return fit.system == now && fit.score > fits.front().score - clearlyBetter;
    });
    return asGood ? nullptr : &fits.front();
}

std::vector<std::string> rivalSystems(const std::vector<UnitFit>& fits) {
    std::vector<std::string> rivals;
    if (fits.empty() || fits.front().score <= 0.0) {
        return rivals;
    }
    for (const UnitFit& fit : fits) {
        if (fit.score > fits.front().score - clearlyBetter) {
            rivals.emplace_back(fit.system->id);
        }
    }
    return rivals;
}

std::string unsaidUnits(const Findings& findings) {
    for (const Finding& finding : findings.list()) {
        const std::vector<Argument>& told = finding.what.arguments;
        if ((finding.what.id == "fe.units_rivals" || finding.what.id == "fe.units_better") && told.size() == 2) {
            const auto* others = std::get_if<std::string>(&told[1].value);
            return others != nullptr ? *others : std::string();
        }
    }
    return {};
}

Proposal proposeUnits(const UnitEvidence& evidence) {
    const std::vector<UnitFit> fits = fitUnits(evidence);
    const UnitFit& best = fits.front();
    const std::vector<std::string> alike = rivalSystems(fits);
    std::string rivals;
    for (std::size_t i = 1; i < alike.size(); ++i) {
        rivals += (rivals.empty() ? "" : ", ") + alike[i];
    }
    if (best.score <= 0.0) {
        return {"", {"units.none", "no known system fits; the best would be {0}: {1}", {best.system->id, joined(best.reasons)}}};
    }
    if (!rivals.empty()) {
        return {"", {"units.ambiguous", "{0} would fit ({1}), and so would {2}", {best.system->id, joined(best.reasons), rivals}}};
    }
    return {std::string(best.system->id), {"units.fits", "{0}: {1}", {best.system->words, joined(best.reasons)}}};
}

Proposal proposeUpAxis(const UnitEvidence& evidence) {
    if (!fallsByGravity(evidence)) {
        return {"", {"up.unseen", "nothing was seen to fall", {}}};
    }
    Eigen::Index axis = 0;
    const Vec3 down = evidence.fall->normalized();
    const double share = down.cwiseAbs().maxCoeff(&axis);
    if (share < 0.98) {
        return {"",
                {"up.oblique", "things fall along ({0}, {1}, {2}), which is no axis of the file", {down.x(), down.y(), down.z()}}};
    }
    const std::string name(1, "xyz"[axis]);
    return {down[axis] < 0.0 ? name : "-" + name,
            evidence.freely
                ? Message{"up.falls", "free nodes fall along {0}", {down[axis] < 0.0 ? "-" + name : name}}
                : Message{"up.gathered", "what comes down gathers speed along {0}", {down[axis] < 0.0 ? "-" + name : name}}};
}

std::optional<Message> implausibleSize(double size) {
    if (size > 10000.0) {
        return Message{"units.too_large", "The structure would be {0} large: no structure is", {{size / 1000.0, "km"}}};
    }
    if (size > 0.0 && size < 0.005) {
        return Message{"units.too_small", "The structure would be {0} large", {{size * 1000.0, "mm"}}};
    }
    return std::nullopt;
}

}  // namespace rubble
