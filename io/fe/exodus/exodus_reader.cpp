#include "io/fe/exodus/exodus_reader.h"

#include <cmath>
#include <filesystem>

#include "core/base/error.h"
#include "core/base/nearest_names.h"
#include "io/base/hdf5_extent.h"
#include "io/fe/exodus/exodus_activity.h"
#include "io/fe/exodus/exodus_displacement.h"
#include "io/fe/exodus/exodus_files.h"
#include "io/fe/exodus/exodus_mesh.h"
#include "io/fe/exodus/exodus_names.h"
#include "io/fe/exodus/exodus_sequence.h"
#include "io/fe/exodus/exodus_source.h"
#include "io/fe/pieces/stacked_series.h"
#include "io/fe/series/death_list.h"
#include "io/fe/series/part_membership.h"
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
    }
}

// What one processor wrote must not pass for the structure.
[[noreturn]] void failPiece(const ExodusFile& file) {
    const std::string name = std::filesystem::path(file.path()).filename().string();
    throw ParseError({"exodus.piece_alone",
                      "{0} holds {1} of {2} elements: it is what one of {3} processors wrote",
                      {file.path(), file.elementCount(), file.elementsOfAll(), file.processors()}},
                     {"exodus.piece_alone.remedy",
                      "Put the files of all processors beside it, named NAME.{0}.0 to NAME.{0}.{1}, or join them by epu.",
                      {file.processors(), file.processors() - 1}});
}

/// Files of all processors where a name tells of them; a result of one processor otherwise.
std::vector<std::vector<std::string>> piecesOf(const std::string& path, const ImportSettings& settings) {
    std::vector<std::vector<std::string>> pieces =
        isExodusPiece(path) ? exodusPieces(path) : std::vector<std::vector<std::string>>{};
    if (pieces.empty() || settings.onlyThisFile) {
        return {};
    }
    std::vector<std::string> missing;
    for (std::size_t p = 0; p < pieces.size(); ++p) {
        if (pieces[p].empty()) {
            missing.push_back(exodusPieceName(path, static_cast<int>(p)));
        }
    }
    if (!missing.empty()) {
        throw ParseError({"exodus.piece_missing",
                          "{0} is a piece of a result that {1} processors wrote; not there: {2}",
                          {path, pieces.size(), quotedList(missing, 10)}},
                         {"exodus.piece_missing.remedy", "Put all pieces beside each other, or join them by epu.", {}});
    }
    return pieces;
}

std::shared_ptr<MeshSeries> stackedPieces(std::vector<std::vector<std::string>> pieces, const ImportSettings& settings) {
    std::vector<SeriesPiece> stack;
    for (std::vector<std::string>& files : pieces) {
        const std::string name = files.front();
        auto sequence = std::make_shared<ExodusSequence>(std::move(files), settings);
        if (!sequence->empty()) {
            stack.push_back({name, std::move(sequence)});
        }
    }
    if (stack.empty()) {
        throw ParseError({"fe.no_elements", "{0} has no solids, shells or beams", {pieces.front().front()}},
                         {"fe.no_elements.remedy", "Give an analysis whose structure is made of such elements.", {}});
    }
    return std::make_shared<StackedSeries>(std::move(stack));
}

}  // namespace

bool recognisesExodus(const FileHead& head) {
    using namespace std::string_view_literals;
    const bool classic =
        head.bytes.starts_with("CDF\x01"sv) || head.bytes.starts_with("CDF\x02"sv) || head.bytes.starts_with("CDF\x05"sv);
    return !head.packed && (classic || head.bytes.starts_with(hdf5Signature));
}

std::vector<std::string> exodusMembers(const std::string& path) {
    std::vector<std::string> files;
    for (const std::vector<std::string>& piece :
         isExodusPiece(path) ? exodusPieces(path) : std::vector<std::vector<std::string>>{}) {
        files.insert(files.end(), piece.begin(), piece.end());
    }
    if (files.empty()) {
        files = exodusSequence(path);
    }
    return withDeathList(std::move(files));
}

bool isExodusPiece(const std::string& path) {
    const int processors = exodusName(path).processors;
    std::error_code ignored;
    if (processors < 2 || !std::filesystem::is_regular_file(path, ignored)) {
        return false;
    }
    try {
        // Two numbers may be those of a version.
        return ExodusFile(path).processors() == processors;
    } catch (const Error&) {
        return true;
    }
}

FeResult::Contents readExodus(const std::string& path, const ImportSettings& settings, const Execution& execution) {
    if (std::vector<std::vector<std::string>> pieces = piecesOf(path, settings); !pieces.empty()) {
        return readSeries(path, stackedPieces(std::move(pieces), settings), settings, execution);
    }
    if (std::vector<std::string> files = exodusSequence(path); files.size() > 1 && !settings.onlyThisFile) {
        return readSeries(path, std::make_shared<ExodusSequence>(std::move(files), settings), settings, execution);
    }
    const Message stage{"exodus.open", "Reading the mesh", {}};
    execution.report(stage, 0.0);
    const auto file = std::make_shared<const ExodusFile>(path);
    requireThreeDimensions(*file);
    if (file->processors() > 1 && file->elementsOfAll() > static_cast<std::int64_t>(file->elementCount()) &&
        !settings.onlyThisFile) {
        failPiece(*file);
    }
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
    killParts(settings.deadParts, *contents.mesh, contents.activity, contents.activityFrom, path);
    contents.deathTime = std::move(activity.deathTime);
    contents.findings = std::move(mesh.findings);
    contents.findings.append(file->findings());
    contents.findings.append(activity.findings);
    if (const std::string list = deathListBeside(path); !list.empty()) {
        noteUnusedDeathList(list, contents.findings);
    }
    return contents;
}

}  // namespace rubble::io
