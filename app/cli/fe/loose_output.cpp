#include "app/cli/fe/loose_output.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "app/cli/frame/text_output.h"
#include "core/base/message.h"

namespace rubble::cli {

namespace {

constexpr std::size_t islandRows = 12;

struct EndWord {
    const char* id;    ///< in JSON
    const char* text;  ///< after "at the last state it ..."
};

constexpr std::array<EndWord, 4> endWords{
    {{"died", "died"}, {"joined", "joined another"}, {"supported", "is held again"}, {"alive", "lives on"}}};

const EndWord& wordOf(IslandEnd end) {
    return endWords.at(static_cast<std::size_t>(end));
}

/// Number of an island for people: the order in which islands came loose, from 1.
std::int64_t numberOf(std::uint32_t island) {
    return std::int64_t{island} + 1;
}

Json secondsJson(double seconds) {
    return std::isfinite(seconds) ? Json(seconds) : Json();
}

TextTable islandTable(const LooseStructure& loose, const LooseAccount& account) {
    TextTable table({{"island", "island"},
                     {"out of", "out_of"},
                     {"loose from [s]", "from_s"},
                     {"to [s]", "to_s"},
                     {"elements", "elements"},
                     {"mass [kg]", "mass_kg"},
                     {"died", "died"},
                     {"median until death [s]", "median_until_death_s"},
                     {"then", "end"}});
    for (std::size_t i = 0; i < std::min(islandRows, account.islands.size()); ++i) {
        const IslandFate& fate = account.islands[i];
        const LooseIsland& island = loose.islands[fate.island];
        table.add({integerCell(numberOf(fate.island)), island.parent ? integerCell(numberOf(*island.parent)) : textCell("standing"),
                   numberCell(fate.from), numberCell(fate.to), integerCell(fate.elements), numberCell(fate.mass),
                   integerCell(fate.died), fate.died > 0 ? numberCell(fate.medianSeconds) : textCell("-"),
                   textCell(wordOf(island.end).text)});
    }
    return table;
}

}  // namespace

Json looseJson(const LooseStructure& loose, const LooseAccount& account, const FeResult& fe) {
    Json object;
    object["dead"] = account.dead;
    object["dead_while_loose"] = account.deadLoose;
    object["median_s"] = secondsJson(account.median);
    object["p10_s"] = secondsJson(account.tenth);
    object["p90_s"] = secondsJson(account.ninetieth);
    object["large_at_once_mean"] = account.largeMean;
    object["large_at_once_max"] = account.largeAtOnce;
    object["loose_at_once_max"] = account.looseAtOnce;
    object["islands"] = Json::array();
    for (const IslandFate& fate : account.islands) {
        const LooseIsland& island = loose.islands[fate.island];
        Json row;
        row["island"] = numberOf(fate.island);
        row["out_of"] = island.parent ? Json(numberOf(*island.parent)) : Json();
        row["from_s"] = fate.from;
        row["to_s"] = fate.to;
        row["elements"] = fate.elements;
        row["first_element"] = fe.mesh().elementIds[at(island.elements.front())];
        row["mass_kg"] = fate.mass;
        row["died"] = fate.died;
        row["median_until_death_s"] = secondsJson(fate.medianSeconds);
        row["end"] = wordOf(island.end).id;
        object["islands"].push_back(std::move(row));
    }
    return object;
}

void printLoose(std::ostream& out, const LooseStructure& loose, const LooseAccount& account) {
    if (loose.islands.empty()) {
        out << "\nNothing comes loose: every element has a path to a support as long as it is active.\n";
        return;
    }
    const auto count = static_cast<std::int64_t>(loose.islands.size());
    printHeading(out, "Loose structure: " + counted(count, "island", "islands") + " without a path to a support");
    FactList facts;
    if (account.dead > 0) {
        const double share = 100.0 * static_cast<double>(account.deadLoose) / static_cast<double>(account.dead);
        facts.add("deaths in islands",
                  englishInteger(account.deadLoose) + " of " + englishInteger(account.dead) + ", " + englishNumber(share) + " %");
    }
    if (account.deadLoose > 0) {
        facts.add("loose before that", englishNumber(account.median) + " s in the median, 10 % below " +
                                           englishNumber(account.tenth) + " s, 10 % above " + englishNumber(account.ninetieth) +
                                           " s");
    }
    facts.add("at one time", "at most " + englishInteger(account.looseAtOnce) +
                                 " elements; islands of 50 and more: " + englishNumber(account.largeMean) + " in the mean, " +
                                 englishInteger(account.largeAtOnce) + " at most");
    facts.print(out);
    out << '\n';
    islandTable(loose, account).print(out);
    if (loose.islands.size() > islandRows) {
        out << "  and " << englishInteger(count - static_cast<std::int64_t>(islandRows)) << " lighter ones; --json lists all\n";
    }
}

}  // namespace rubble::cli
