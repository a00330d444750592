#include "io/exodus/exodus_reader.h"

#include <cmath>

#include "core/base/error.h"
#include "core/base/nearest_names.h"
#include "io/exodus/exodus_activity.h"
#include "io/exodus/exodus_mesh.h"
#include "io/exodus/exodus_names.h"
#include "io/exodus/exodus_source.h"

namespace rubble::io {

namespace {

void requireThreeDimensions(const ExodusFile& file) {
    if (file.dimensions() != 3) {
        throw ParseError({"exodus.dimensions",
                          "{0} has {1} dimensions; only solids, shells and beams in space make fragments",
                          {file.path(), file.dimensions()}},
                         {"exodus.dimensions.remedy", "Give a three-dimensional analysis.", {}});
    }
}

void requireTimes(const ExodusFile& file) {
    const std::vector<double>& times = file.times();
    if (times.empty()) {
        throw ParseError({"exodus.no_states", "{0} has no states: it is a mesh without results", {file.path()}},
                         {"exodus.no_states.remedy", "Give the result file of the analysis, not its input mesh.", {}});
    }
    for (std::size_t k = 0; k < times.size(); ++k) {
        if (!std::isfinite(times[k])) {
            throw ParseError({"exodus.bad_time", "{0}: the time of state {1} is {2}", {file.path(), k, times[k]}},
                             {"exodus.bad_time.remedy", "Let the analysis write the file again.", {}});
        }
        if (k > 0 && times[k] <= times[k - 1]) {
            throw ParseError({"exodus.time_order",
                              "{0}: state {1} at {2} does not come after state {3} at {4}",
                              {file.path(), k, {times[k], "s"}, k - 1, {times[k - 1], "s"}}},
                             {"exodus.time_order.remedy", "Remove states that a restart wrote twice.", {}});
        }
    }
}

std::optional<VectorVariable> chooseDisplacement(const ExodusFile& file, const ImportSettings& settings) {
    const std::vector<std::string>& names = file.variables(ExodusEntity::Node);
    if (settings.displacement == "none") {
        return std::nullopt;
    }
    const auto found = settings.displacement.empty() ? findDisplacement(names) : findVector(names, settings.displacement);
    if (found) {
        return found;
    }
    const Message remedy{"exodus.no_displacement.remedy",
                         "Say how its components begin: --set displacement=PREFIX; displacement=none if the nodes do not move. "
                         "Nodal variables in the file: {0}",
                         {quotedList(names, 100)}};
    if (!settings.displacement.empty()) {
        throw UsageError({"exodus.unknown_displacement",
                          "{0} has no nodal variables {1}_x, {1}_y and {1}_z in any spelling",
                          {file.path(), settings.displacement}},
                         remedy);
    }
    throw ParseError({"exodus.no_displacement", "{0} has no nodal displacement under a known name", {file.path()}}, remedy);
}

void noteSequence(const std::string& path, Findings& findings) {
    if (const std::string next = nextOfSequence(path); !next.empty()) {
        findings.add({"exodus.sequence", "The result goes on in further files, which were not read", {}},
                     {"exodus.sequence.remedy", "Join the files of the sequence with seacas conjoin.", {}}, next);
    }
}

}  // namespace

bool recognisesExodus(const FileHead& head) {
    using namespace std::string_view_literals;
    const bool classic =
        head.bytes.starts_with("CDF\x01"sv) || head.bytes.starts_with("CDF\x02"sv) || head.bytes.starts_with("CDF\x05"sv);
    return !head.packed && (classic || head.bytes.starts_with("\x89HDF\r\n\x1a\n"sv));
}

FeResult::Contents readExodus(const std::string& path, const ImportSettings& settings, const Frame& frame,
                              const Execution& execution) {
    const FrameTransform transform(frame);
    const Message stage{"exodus.open", "Reading the mesh", {}};
    execution.report(stage, 0.0);
    const auto file = std::make_shared<const ExodusFile>(path);
    requireThreeDimensions(*file);
    requireTimes(*file);
    const auto displacement = chooseDisplacement(*file, settings);
    const auto velocity = findVelocity(file->variables(ExodusEntity::Node));
    ExodusMesh mesh = readExodusMesh(*file, transform);
    execution.report(stage, 1.0);
    ExodusActivity activity = readExodusActivity(*file, mesh, settings, execution);

    FeResult::Contents contents;
    contents.mesh = std::make_shared<const Mesh>(std::move(mesh.mesh));
    contents.times = file->times();
    contents.hasVelocity = velocity.has_value();
    contents.source =
        std::make_shared<const ExodusSource>(file, contents.mesh, activity.activity, transform, displacement, velocity);
    contents.activity = std::move(activity.activity);
    contents.activityFrom = std::move(activity.from);
    contents.deathTime = std::move(activity.deathTime);
    contents.findings = std::move(mesh.findings);
    contents.findings.append(activity.findings);
    noteSequence(path, contents.findings);
    return contents;
}

}  // namespace rubble::io
