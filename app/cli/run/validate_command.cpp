#include <algorithm>
#include <chrono>
#include <span>

#include "app/cli/frame/commands.h"
#include "app/cli/frame/option_value.h"
#include "app/cli/frame/output_file.h"
#include "app/cli/frame/text_output.h"
#include "app/cli/run/validation_pictures.h"
#include "app/cli/run/validation_tables.h"
#include "core/base/elapsed.h"
#include "core/base/error.h"
#include "core/base/nearest_names.h"
#include "core/validation/scene_sets.h"
#include "io/base/machine.h"
#include "io/validation/kept_validation.h"
#include "io/validation/set_folder.h"
#include "io/validation/validation_json.h"

namespace rubble::cli {

namespace {

/// What is to be validated: sets of measured falls, and scenes.
struct ChosenSets {
    std::vector<io::SetPlace> places;
    std::vector<const SceneSet*> scenes;
};

/// A folder of one's own takes the place of all that comes with the program.
ChosenSets chosenSets(const Arguments& arguments) {
    const auto folder = arguments.value("--data");
    const std::vector<io::SetPlace> places = io::setsIn(folder.value_or(io::shippedSets()));
    const std::span<const SceneSet> scenes = folder ? std::span<const SceneSet>() : sceneSets();
    std::vector<std::string> names;
    for (const io::SetPlace& place : places) {
        names.push_back(place.id);
    }
    for (const SceneSet& scene : scenes) {
        names.push_back(scene.about.id);
    }
    std::vector<std::string> wanted = arguments.values("--only");
    if (wanted.empty()) {
        wanted = names;
    }
    ChosenSets chosen;
    for (const std::string& id : wanted) {
        const auto found = std::find(names.begin(), names.end(), id);
        if (found == names.end()) {
            throw UsageError({"validation.no_such_set", "There is no set \"{0}\".", {id}},
                             {"validation.no_such_set.remedy", "There are {0}.", {quotedList(names)}});
        }
        const auto at = static_cast<std::size_t>(found - names.begin());
        if (at < places.size()) {
            chosen.places.push_back(places[at]);
        } else {
            chosen.scenes.push_back(&scenes[at - places.size()]);
        }
    }
    return chosen;
}

/// For reports and the window. Where there is no room for it, that is said.
void keepAll(const std::vector<ValidationRecord>& records, Session& session) {
    try {
        for (const ValidationRecord& record : records) {
            io::keepValidation(record, io::cacheFolder());
        }
    } catch (const WorldError& error) {
        session.err() << "rubble-cli: not kept for reports: " << error.what() << '\n';
    }
}

ExitCode validateSets(const Arguments& arguments, Session& session) {
    checkCsvPath(arguments, {});
    const auto start = std::chrono::steady_clock::now();
    ValidationOptions options;
    if (arguments.has("--repeats")) {
        options.repeats = parseCount(arguments, "--repeats", 1, mostSetRepeats, 1);
    }
    options.seed = parseCount(arguments, "--seed", 0, 2147483647, 1);
    const ChosenSets chosen = chosenSets(arguments);
    std::vector<ValidationSet> sets;
    for (const io::SetPlace& place : chosen.places) {
        sets.push_back(io::readSet(place, session.execution()));
    }
    std::vector<SetResult> results;
    for (const ValidationSet& set : sets) {
        session.err() << set.id << ", " << set.bodies.size() << " bodies\n";
        results.push_back(validate(set, options, session.execution()));
    }
    for (const SceneSet* scene : chosen.scenes) {
        session.err() << scene->about.id << '\n';
        results.push_back(validateScene(*scene, options, session.execution()));
    }
    std::vector<ValidationRecord> records;
    for (const SetResult& result : results) {
        records.push_back(recordOf(result));
    }
    // Figures of the report and the window are those of sets as they stand.
    if (!arguments.has("--repeats") && !arguments.has("--seed")) {
        keepAll(records, session);
    }
    writeCsv(arguments, validationTable(records));
    std::vector<std::string> pictures;
    if (const auto folder = arguments.value("--pictures")) {
        pictures = drawValidation(results, *folder);
    }
    if (arguments.json()) {
        Json object;
        object["sets"] = Json::array();
        for (std::size_t i = 0; i < records.size(); ++i) {
            Json set = io::validationJson(records[i]);
            set["warnings"] = findingsJson(results[i].findings);
            object["sets"].push_back(std::move(set));
        }
        object["pictures"] = pictures;
        object["wall_s"] = secondsSince(start);
        printJson(session, object);
        return ExitCode::Ok;
    }
    for (std::size_t i = 0; i < records.size(); ++i) {
        printValidation(session.out(), records[i], results[i].findings);
        session.out() << '\n';
    }
    for (const std::string& path : pictures) {
        session.out() << path << '\n';
    }
    return ExitCode::Ok;
}

}  // namespace

Command validateCommand() {
    return {
        "validate",
        "",
        "simulated falls held against measured ones",
        "Simulates bodies whose falls were measured, and says how far the result is from what was measured: the difference of the "
        "means with its interval, the scatter of both, the area between their cumulative curves, how many were lost, and which "
        "parameters were used. Nothing is fitted unless the line says so.",
        {{"--only", "ID", true, "only this set"},
         {"--data", "DIR", false, "folder of a set, or of several, in place of those that come with the program"},
         {"--repeats", "N", false, "how often each body is let go (default: what the set says)"},
         {"--seed", "N", false, "of what is drawn (default: 1)"},
         {"--pictures", "DIR", false, "draw the cumulative curves and maps of the deposits into this folder, as SVG"},
         csvOption("write one row for each figure")},
        validateSets};
}

}  // namespace rubble::cli
