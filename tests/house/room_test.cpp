#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "tests/house/source_tree.h"

namespace rubble::house {

namespace {

/// The rooms of a folder, from the ground up: each sees itself and those before it.
struct Storeys {
    std::string folder;
    std::vector<std::string> rooms;  ///< folders; "." is what stands in the folder itself
};

/// Data flows one way through each of these; a room of its own is added where it stands in the flow.
const std::vector<Storeys>& storeys() {
    static const std::vector<Storeys> table{
        {"core",
         {"base", "fe", "scenario", "fragments", "clusters", "trajectory", "engine", "simulation", "pipeline", "analysis",
          "validation", "evidence", "selftest"}},
        {"core/engine", {"world", "soft", "bullet"}},
        {"core/simulation", {"bodies", "effects", "health", "run"}},
        {"core/analysis", {"debris", "accuracy"}},
        {"core/evidence", {"clouds", "maps", "surveys", "photographs", "ensembles", "."}},
        {"io", {"base", "json", "fe", "site", "run", "case", "validation", "exports", "jobs", "seal"}},
        {"widgets", {"render", "figures", "basics", "views", "case", "run", "accuracy", "evidence"}},
        {"widgets/render", {"basics", "shapes", "site", "."}},
        {"app/cli", {"frame", "fe", "exports", "run", "accuracy", "evidence", "."}},
        {"app/gui", {"session", "stage", "case", "run", "views", "studies", "accuracy", "evidence", "exports", "help", "window"}},
    };
    return table;
}

/// The folder of a file inside another, "." if it stands there itself; empty: it lies elsewhere.
std::string roomIn(const std::string& folder, const std::string& path) {
    if (!path.starts_with(folder + "/")) {
        return "";
    }
    const std::string rest = path.substr(folder.size() + 1);
    const std::size_t slash = rest.find('/');
    return slash == std::string::npos ? "." : rest.substr(0, slash);
}

/// The height of a room in its folder; one that is not listed is as high as none.
std::size_t heightOf(const Storeys& floor, const std::string& room) {
    return static_cast<std::size_t>(std::find(floor.rooms.begin(), floor.rooms.end(), room) - floor.rooms.begin());
}

/// More files than this in one folder are not found by reading its list.
constexpr std::size_t filesMax = 45;

TEST(Room, EveryRoomSeesOnlyThoseBelow) {
    std::map<std::string, std::size_t> arrows;
    for (const SourceFile& file : programSources()) {
        for (const Storeys& floor : storeys()) {
            const std::string room = roomIn(floor.folder, file.path);
            if (room.empty()) {
                continue;
            }
            EXPECT_LT(heightOf(floor, room), floor.rooms.size())
                << file.path << " stands in a room without a place in the order of " << floor.folder;
            for (const Include& include : includesOf(file)) {
                const std::string other = include.quoted ? roomIn(floor.folder, include.name) : "";
                if (!other.empty()) {
                    ++arrows[floor.folder];
                    EXPECT_LE(heightOf(floor, other), heightOf(floor, room))
                        << place(file, include.line) << ": an arrow up to " << include.name;
                }
            }
        }
    }
    for (const Storeys& floor : storeys()) {
        EXPECT_GT(arrows[floor.folder], 10u) << floor.folder << ": its files were not found";
    }
}

TEST(Room, EveryRoomOfTheTableIsThere) {
    std::map<std::string, std::set<std::string>> there;
    for (const SourceFile& file : programSources()) {
        for (const Storeys& floor : storeys()) {
            there[floor.folder].insert(roomIn(floor.folder, file.path));
        }
    }
    for (const Storeys& floor : storeys()) {
        for (const std::string& room : floor.rooms) {
            EXPECT_TRUE(there[floor.folder].contains(room)) << floor.folder << " has no " << room;
        }
    }
}

TEST(Room, NoFolderHoldsMoreThanAReaderOverlooks) {
    std::map<std::string, std::size_t> files;
    for (const SourceFile& file : allSources()) {
        ++files[file.path.substr(0, file.path.rfind('/'))];
    }
    ASSERT_GT(files.size(), 40u);
    for (const auto& [folder, count] : files) {
        EXPECT_LE(count, filesMax) << folder << " holds " << count << " files: give what belongs together a folder of its own";
    }
}

TEST(Room, RoomsAreToldByTheirFolder) {
    EXPECT_EQ(roomIn("io", "io/fe/exodus/exodus_layout.h"), "fe");
    EXPECT_EQ(roomIn("core/evidence", "core/evidence/report_facts.h"), ".");
    EXPECT_EQ(roomIn("io", "app/gui/session/document.h"), "");
    EXPECT_EQ(roomIn("app/gui", "app/guide/page.h"), "");
}

}  // namespace

}  // namespace rubble::house
