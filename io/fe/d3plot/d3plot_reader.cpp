#include "io/fe/d3plot/d3plot_reader.h"

#include "core/base/error.h"
#include "io/fe/d3plot/d3plot_activity.h"
#include "io/fe/d3plot/d3plot_adaptive.h"
#include "io/fe/d3plot/d3plot_mesh.h"
#include "io/fe/node_fields.h"
#include "io/fe/series/death_list.h"
#include "io/fe/series/part_membership.h"
#include "io/fe/series/series_result.h"

namespace rubble::io {

namespace {

/// What reading one state takes.
struct StateReader {
    std::shared_ptr<const D3plotFamily> family;
    D3plotHeader header;
    D3plotStateLayout layout;
    std::vector<std::int64_t> begin;
    std::vector<Vec3> atRest;  ///< of the nodes of the file, unless states hold their places
    Particles particles;

    std::vector<Vec3> vectors(std::int64_t word) const {
        std::vector<double> values(static_cast<std::size_t>(3 * header.nodes));
        family->readFloats(word, values);
        std::vector<Vec3> result(static_cast<std::size_t>(header.nodes));
        for (std::size_t n = 0; n < result.size(); ++n) {
            result[n] = Vec3(values[3 * n], values[3 * n + 1], values[3 * n + 2]);
        }
        return result;
    }

    NodeFields read(std::size_t k) const {
        NodeFields fields;
        fields.positions = header.coordinates > 0 ? vectors(begin[k] + layout.coordinates) : atRest;
        if (header.coordinates == 2) {
            for (std::size_t n = 0; n < atRest.size(); ++n) {
                fields.positions[n] += atRest[n];
            }
        }
        particles.appendCorners(fields.positions);
        if (header.velocities) {
            fields.velocities = vectors(begin[k] + layout.velocities);
            particles.appendVelocities(fields.velocities);
        }
        return fields;
    }
};

void requireStates(const D3plotFamily& family, const D3plotGeometry& geometry, const D3plotStateLayout& layout,
                   const D3plotStates& states) {
    if (states.times.empty()) {
        throw ParseError(
            {"d3plot.no_states",
             "{0} has no complete state: a state takes {1} bytes, and {2} bytes follow the mesh",
             {family.path(), layout.words * family.format().bytes, (family.words() - geometry.end) * family.format().bytes}},
            {"d3plot.no_states.remedy",
             "Give the whole family (d3plot, d3plot01, ...), or wait until the analysis has gone on.",
             {}});
    }
    // A state without values takes next to nothing in the file, but a bit of every element here.
    constexpr std::size_t mostBits = std::size_t{1} << 36;
    const std::size_t elements = geometry.solids.count() + geometry.thickShells.count() + geometry.beams.count() +
                                 geometry.shells.count() + geometry.particles.count();
    if (states.times.size() > mostBits / (elements + 1)) {
        throw ParseError({"d3plot.too_large",
                          "{0} has {1} states of {2} elements, more than can be held",
                          {family.path(), states.times.size(), elements}},
                         {"fe.too_large.remedy", "Give a part of the model.", {}});
    }
}

Activity allActive(std::size_t states, const D3plotGeometry& geometry) {
    const std::size_t elements = geometry.solids.count() + geometry.thickShells.count() + geometry.beams.count() +
                                 geometry.shells.count() + geometry.particles.count();
    Activity activity(states, elements);
    for (std::size_t k = 0; k < states; ++k) {
        for (std::size_t e = 0; e < elements; ++e) {
            activity.set(k, idAt<ElementIndex>(e), true);
        }
    }
    return activity;
}

void noteFiles(const D3plotFamily& family, const D3plotHeader& header, Findings& findings) {
    for (const std::string& name : d3plotLeftBehind(family.path(), family.files())) {
        findings.add(
            {"d3plot.left_behind", "Files that belong to the family stand behind a missing number; they were not read", {}},
            {"d3plot.left_behind.remedy", "Copy the missing files.", {}}, name);
    }
    if (header.discreteSpheres) {
        findings.add({"d3plot.spheres", "The file has discrete elements (spheres), which are not read", {}},
                     {"d3plot.spheres.remedy", "Nothing to do if they are gravel or debris beside the structure.", {}},
                     family.path());
    }
    if (header.coordinates == 0) {
        findings.add({"d3plot.no_coordinates", "The states hold no places of nodes: nothing moves", {}},
                     {"d3plot.no_coordinates.remedy", "Write the d3plot with the geometry of the nodes.", {}}, family.path());
    }
}

FeResult::Contents readFamily(const std::string& path, const ImportSettings& settings, const Execution& execution) {
    const auto format = d3plotWordFormat(readHead(path));
    if (!format) {
        throw ParseError({"d3plot.changed", "{0} is no d3plot any more", {path}},
                         {"d3plot.shrunk.remedy", "Open the result again.", {}});
    }
    const auto files = std::make_shared<const D3plotFamily>(d3plotMembers(path), *format);
    const D3plotFamily& family = *files;
    const D3plotHeader header = readD3plotHeader(family);
    D3plotGeometry geometry = readD3plotGeometry(family, header, execution);
    const D3plotStateLayout layout = layoutOfStates(family, header, geometry);
    const D3plotStates states = findD3plotStates(family, geometry, layout, execution);
    requireStates(family, geometry, layout, states);
    D3plotActivity activity = readD3plotActivity(family, header, geometry, layout, states, execution);
    const std::string list = deathListBeside(path);
    const bool inferred = header.deletion == DeletionTable::None;
    if (!list.empty() && inferred) {
        activity = {};
        activity.activity = allActive(states.times.size(), geometry);
    }
    D3plotMesh mesh =
        makeD3plotMesh(family, header, geometry, layout, states, activity.activity, readKeywordDeck(keywordDeckBeside(path)));

    FeResult::Contents contents;
    contents.mesh = std::make_shared<const Mesh>(std::move(mesh.mesh));
    contents.times = states.times;
    if (!list.empty() && inferred) {
        activity.from =
            applyDeathList(list, *contents.mesh, contents.times, activity.activity, contents.deathTime, activity.findings);
    } else if (!list.empty()) {
        noteUnusedDeathList(list, activity.findings);
    }
    contents.hasVelocity = header.velocities;
    killParts(settings.deadParts, *contents.mesh, activity.activity, activity.from, path);
    const auto reader = std::make_shared<const StateReader>(
        StateReader{files, header, layout, states.begin, header.coordinates == 1 ? std::vector<Vec3>{} : std::move(geometry.nodes),
                    std::move(mesh.particles)});
    contents.source = std::make_shared<const FieldSource>(path, contents.mesh, activity.activity, contents.times,
                                                          [reader](std::size_t k) { return reader->read(k); });
    contents.activity = std::move(activity.activity);
    contents.activityFrom = std::move(activity.from);
    contents.findings = std::move(geometry.findings);
    contents.findings.append(states.findings);
    contents.findings.append(activity.findings);
    contents.findings.append(mesh.findings);
    noteFiles(family, header, contents.findings);
    return contents;
}

}  // namespace

std::vector<std::string> d3plotFiles(const std::string& path) {
    std::vector<std::string> files;
    for (const std::string& root : d3plotRoots(path)) {
        const std::vector<std::string> members = d3plotMembers(root);
        files.insert(files.end(), members.begin(), members.end());
    }
    const std::string deck = isD3plotRoot(files.front()) ? keywordDeckBeside(files.front()) : std::string();
    if (!deck.empty()) {
        files.push_back(deck);
    }
    if (const std::string list = deathListBeside(files.front()); !list.empty()) {
        files.push_back(list);
    }
    return files;
}

FeResult::Contents readD3plot(const std::string& path, const ImportSettings& settings, const Execution& execution) {
    const std::vector<std::string> roots = d3plotRoots(path);
    if (roots.size() == 1) {
        return readFamily(path, settings, execution);
    }
    std::vector<FeResult::Contents> families;
    for (const std::string& root : roots) {
        families.push_back(readFamily(root, settings, execution));
    }
    if (!AdaptiveSeries::joinable(families)) {
        for (std::size_t f = 1; f < roots.size(); ++f) {
            families.front().findings.add(
                {"d3plot.later_meshes", "Later meshes of a run with particles were not read", {}},
                {"d3plot.later_meshes.remedy", "Copy the later mesh into another folder to open it by itself.", {}}, roots[f]);
        }
        return std::move(families.front());
    }
    return readSeries(path, std::make_shared<AdaptiveSeries>(std::move(families)), settings, execution);
}

}  // namespace rubble::io
