#include "io/fe/exodus/exodus_reader.h"

#include <cmath>

#include "core/base/error.h"
#include "io/fe/exodus/exodus_activity.h"
#include "io/fe/exodus/exodus_displacement.h"
#include "io/fe/exodus/exodus_mesh.h"
#include "io/fe/exodus/exodus_names.h"
#include "io/fe/exodus/exodus_sequence.h"
#include "io/fe/exodus/exodus_source.h"
#include "io/fe/series/death_list.h"
#include "io/fe/series/series_result.h"

namespace rubble::io {

namespace {

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

}  // namespace

bool recognisesExodus(const FileHead& head) {
    using namespace std::string_view_literals;
    const bool classic =
        head.bytes.starts_with("CDF\x01"sv) || head.bytes.starts_with("CDF\x02"sv) || head.bytes.starts_with("CDF\x05"sv);
    return !head.packed && (classic || head.bytes.starts_with("\x89HDF\r\n\x1a\n"sv));
}

std::vector<std::string> exodusMembers(const std::string& path) {
    return withDeathList(exodusSequence(path));
}

FeResult::Contents readExodus(const std::string& path, const ImportSettings& settings, const Execution& execution) {
    if (std::vector<std::string> files = exodusSequence(path); files.size() > 1) {
        return readSeries(path, std::make_shared<ExodusSequence>(std::move(files), settings), settings, execution);
    }
    const Message stage{"exodus.open", "Reading the mesh", {}};
    execution.report(stage, 0.0);
    const auto file = std::make_shared<const ExodusFile>(path);
    requireThreeDimensions(*file);
    requireTimes(*file);
    const auto displacement = chooseDisplacement(*file, settings);
    if (settings.statusVariable.empty() && !findStatus(file->variables(ExodusEntity::Element), "")) {
        return readSeries(path, std::make_shared<ExodusSequence>(std::vector<std::string>{path}, settings), settings, execution);
    }
    const auto velocity = findVelocity(file->variables(ExodusEntity::Node));
    ExodusMesh mesh = readExodusMesh(*file);
    execution.report(stage, 1.0);
    ExodusActivity activity = readExodusActivity(*file, mesh, settings, execution);

    FeResult::Contents contents;
    contents.mesh = std::make_shared<const Mesh>(std::move(mesh.mesh));
    contents.times = file->times();
    contents.hasVelocity = velocity.has_value();
    contents.source = std::make_shared<const ExodusSource>(file, contents.mesh, activity.activity, displacement, velocity);
    contents.activity = std::move(activity.activity);
    contents.activityFrom = std::move(activity.from);
    contents.deathTime = std::move(activity.deathTime);
    contents.findings = std::move(mesh.findings);
    contents.findings.append(activity.findings);
    if (const std::string list = deathListBeside(path); !list.empty()) {
        noteUnusedDeathList(list, contents.findings);
    }
    return contents;
}

}  // namespace rubble::io
