#include <algorithm>

#include "app/cli/frame/commands.h"
#include "app/cli/frame/json_output.h"
#include "app/cli/frame/option_value.h"
#include "app/cli/frame/output_file.h"
#include "app/cli/frame/text_table.h"
#include "core/base/message.h"
#include "io/base/machine.h"
#include "io/fe/fe_copy/fe_cache.h"

namespace rubble::cli {

namespace {

std::vector<std::string> kindsOf(const Arguments& arguments) {
    std::vector<std::string> kinds = arguments.values("--only");
    for (const std::string& kind : kinds) {
        const auto& known = io::cacheKinds();
        if (std::find(known.begin(), known.end(), kind) == known.end()) {
            throw wrongValue("--only", kind, "fe, worlds, islands, checkpoints, costs, points or calibration");
        }
    }
    return kinds;
}

TextTable entryTable(const std::vector<io::CacheEntry>& entries) {
    TextTable table({{"kind", "kind"}, {"of", "of"}, {"files", "files"}, {"bytes", "bytes"}});
    for (const io::CacheEntry& entry : entries) {
        table.add({textCell(entry.kind), textCell(entry.of), integerCell(static_cast<std::int64_t>(entry.files)),
                   integerCell(static_cast<std::int64_t>(entry.bytes))});
    }
    return table;
}

ExitCode cache(const Arguments& arguments, Session& session) {
    const std::string& what = arguments.operand();
    if (what != "list" && what != "clear") {
        throw wrongValue("cache", what, "list or clear");
    }
    const std::vector<std::string> kinds = kindsOf(arguments);
    checkCsvPath(arguments, {});
    const std::string folder = arguments.value("--cache").value_or(io::cacheFolder());
    std::vector<io::CacheEntry> entries = what == "clear" ? io::clearCache(folder, kinds) : io::cacheEntries(folder);
    if (!kinds.empty()) {
        std::erase_if(
            entries, [&](const io::CacheEntry& entry) { return std::find(kinds.begin(), kinds.end(), entry.kind) == kinds.end(); });
    }
    std::uint64_t bytes = 0;
    for (const io::CacheEntry& entry : entries) {
        bytes += entry.bytes;
    }
    writeCsv(arguments, entryTable(entries));
    if (arguments.json()) {
        Json object;
        object["cache"] = folder;
        object["cleared"] = what == "clear";
        object["entries"] = Json::array();
        for (const io::CacheEntry& entry : entries) {
            object["entries"].push_back({{"kind", entry.kind}, {"of", entry.of}, {"files", entry.files}, {"bytes", entry.bytes}});
        }
        object["bytes"] = bytes;
        printJson(session, object);
        return ExitCode::Ok;
    }
    session.out() << folder << '\n';
    entryTable(entries).print(session.out());
    session.out() << (what == "clear" ? "Removed " : "In all ") << englishInteger(static_cast<std::int64_t>(bytes)) << " bytes\n";
    return ExitCode::Ok;
}

}  // namespace

Command cacheCommand() {
    return {"cache",
            "list|clear",
            "what is kept to be quicker next time, and how to get rid of it",
            "Copies of FE results (kind fe) and what studies keep: worlds, islands, checkpoints of worlds that are not "
            "done yet, costs, points and the calibration of the machine. All of it can be made again.",
            {{"--only", "KIND", true, "this kind alone: fe, worlds, islands, checkpoints, costs, points or calibration"},
             {"--cache", "FOLDER", false, "another folder than $RUBBLE_CACHE, $XDG_CACHE_HOME/rubble or ~/.cache/rubble"},
             csvOption("write the table")},
            cache};
}

}  // namespace rubble::cli
