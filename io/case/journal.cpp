#include "io/case/journal.h"

#include <pwd.h>
#include <unistd.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <fstream>
#include <sstream>

#include "core/base/build.h"
#include "core/simulation/run/acknowledgement.h"
#include "io/base/files.h"
#include "io/case/case_file.h"
#include "io/case/journal_check.h"
#include "io/json/json_text.h"

namespace rubble::io {

using nlohmann::json;

namespace {

/// The user as the system knows him: his full name, else that of his account.
std::string userName() {
    const passwd* entry = ::getpwuid(::geteuid());
    if (entry == nullptr) {
        return {};
    }
    const std::string full = entry->pw_gecos != nullptr ? entry->pw_gecos : "";
    const std::string name = full.substr(0, full.find(','));
    return name.empty() ? std::string(entry->pw_name) : name;
}

/// The member that tells the elements of a list apart; empty: they have none.
std::string idMember(const json& list) {
    for (const char* key : {"id", "input"}) {
        const bool all = !list.empty() && std::all_of(list.begin(), list.end(), [&](const json& each) {
            return each.is_object() && each.contains(key) && each[key].is_string();
        });
        if (all) {
            return key;
        }
    }
    return {};
}

void addPlaces(std::map<std::string, std::string>& places, const json& value, const std::string& place) {
    // An object without members says nothing.
    if (value.is_object()) {
        for (const auto& [key, member] : value.items()) {
            addPlaces(places, member, place.empty() ? key : place + "/" + key);
        }
        return;
    }
    const std::string id = value.is_array() ? idMember(value) : std::string();
    if (id.empty()) {
        places[place] = jsonLine(value);
        return;
    }
    json order = json::array();
    for (const json& each : value) {
        const std::string name = each[id].get<std::string>();
        order.push_back(name);
        addPlaces(places, each, place + "/" + name);
    }
    places[place] = jsonLine(order);
}

json valueOf(const std::string& text) {
    return json::parse(text, nullptr, false);
}

json entryJson(const JournalEntry& entry) {
    json changes = json::array();
    for (const JournalChange& change : entry.changes) {
        json row = {{"place", change.place}};
        if (!change.before.empty()) {
            row["before"] = valueOf(change.before);
        }
        if (!change.after.empty()) {
            row["after"] = valueOf(change.after);
        }
        changes.push_back(std::move(row));
    }
    return {{"when", entry.when}, {"who", entry.who}, {"program", entry.program}, {"outside", entry.outside}, {"changes", changes}};
}

std::string digestOf(const JournalEntry& entry, const std::string& before) {
    return sha256OfText(before + "\n" + jsonLine(entryJson(entry)));
}

void add(Journal& journal, JournalEntry entry) {
    entry.digest = digestOf(entry, journal.entries.empty() ? std::string() : journal.entries.back().digest);
    journal.entries.push_back(std::move(entry));
}

}  // namespace

std::map<std::string, std::string> casePlaces(const json& document) {
    std::map<std::string, std::string> places;
    json bare = document;
    if (bare.is_object()) {
        bare.erase("journal");
        addPlaces(places, bare, {});
    }
    return places;
}

std::map<std::string, std::string> journalPlaces(const Journal& journal) {
    std::map<std::string, std::string> places;
    for (const JournalEntry& entry : journal.entries) {
        for (const JournalChange& change : entry.changes) {
            if (change.after.empty()) {
                places.erase(change.place);
            } else {
                places[change.place] = change.after;
            }
        }
    }
    return places;
}

std::vector<JournalChange> placeChanges(const std::map<std::string, std::string>& before,
                                        const std::map<std::string, std::string>& after) {
    std::vector<JournalChange> changes;
    for (const auto& [place, value] : before) {
        const auto now = after.find(place);
        if (now == after.end()) {
            changes.push_back({place, value, {}});
        } else if (now->second != value) {
            changes.push_back({place, value, now->second});
        }
    }
    for (const auto& [place, value] : after) {
        if (!before.contains(place)) {
            changes.push_back({place, {}, value});
        }
    }
    std::sort(changes.begin(), changes.end(), [](const JournalChange& a, const JournalChange& b) { return a.place < b.place; });
    return changes;
}

void continueJournal(Journal& journal, const json& document) {
    std::vector<JournalChange> changes = placeChanges(journalPlaces(journal), casePlaces(document));
    if (!changes.empty()) {
        add(journal, {utcNow(), userName(), std::string(versionText()), false, std::move(changes), {}});
    }
}

void noteOutsideChanges(Journal& journal, const json& document) {
    if (journal.entries.empty()) {
        return;
    }
    std::vector<JournalChange> changes = placeChanges(journalPlaces(journal), casePlaces(document));
    if (!changes.empty()) {
        add(journal, {{}, {}, {}, true, std::move(changes), {}});
    }
}

json journalJson(const Journal& journal) {
    json list = json::array();
    for (const JournalEntry& entry : journal.entries) {
        json row = entryJson(entry);
        row["digest"] = entry.digest;
        list.push_back(std::move(row));
    }
    return list;
}

Journal journalFromJson(const JsonCursor& list) {
    Journal journal;
    const auto valueAt = [](const JsonCursor& change, const char* key) {
        return change.has(key) ? jsonLine(change[key].value()) : std::string();
    };
    for (const JsonCursor& row : list.elements()) {
        row.allowOnly({"when", "who", "program", "outside", "changes", "digest"});
        JournalEntry entry{row["when"].text(), row["who"].text(), row["program"].text(), row["outside"].flag(), {}, {}};
        for (const JsonCursor& change : row["changes"].elements()) {
            change.allowOnly({"place", "before", "after"});
            entry.changes.push_back({change["place"].text(), valueAt(change, "before"), valueAt(change, "after")});
        }
        entry.digest = row["digest"].text();
        journal.entries.push_back(std::move(entry));
    }
    return journal;
}

JournalCheck checkJournalText(const std::string& text, const std::string& name) {
    // Everything that can be wrong with the file is told as when it is opened.
    caseFromText(text, name);
    const json document = parseJson(text, name);
    JournalCheck check;
    if (!document.contains("journal")) {
        return check;
    }
    const JsonCursor top(document, name);
    const Journal journal = journalFromJson(top["journal"]);
    check.entries = journal.entries.size();
    for (std::size_t i = 0; i < journal.entries.size(); ++i) {
        const JournalEntry& entry = journal.entries[i];
        if (digestOf(entry, check.head) != entry.digest) {
            check.broken.push_back(i + 1);
        }
        check.head = entry.digest;
        if (entry.outside) {
            check.outside.push_back(entry);
        }
        // Times of one form sort as texts do.
        if (!entry.when.empty() && entry.when < check.last) {
            check.backward.push_back(i + 1);
        }
        check.last = std::max(check.last, entry.when);
    }
    if (!journal.entries.empty()) {
        check.altered = placeChanges(journalPlaces(journal), casePlaces(document));
    }
    return check;
}

JournalCheck checkJournal(const std::string& casePath) {
    loadCase(casePath);
    std::ifstream in(casePath, std::ios::binary);
    std::ostringstream text;
    text << in.rdbuf();
    return checkJournalText(text.str(), casePath);
}

}  // namespace rubble::io
