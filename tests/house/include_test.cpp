#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <regex>
#include <set>
#include <sstream>

#include "tests/house/source_tree.h"
#include "tests/support/places.h"

namespace rubble::house {

namespace {

/// A library outside the house, known by the names of its headers.
struct Library {
    std::string name;
    std::regex headers;
};

const std::vector<Library>& libraries() {
    static const std::vector<Library> list{
        {"Bullet", std::regex("^(bt[A-Z]|btBullet|Bullet|LinearMath/|bullet/)")},
        {"Qt", std::regex("^(Q[A-Za-z]+(/.*)?|qt[a-z]*\\.h|q[a-z]+\\.h)$")},
        {"VTK", std::regex("^vtk[A-Z_]")},
        {"HDF5", std::regex("^(hdf5|H5)")},
        {"Exodus", std::regex("^(exodusII|netcdf)")},
        {"GDAL", std::regex("^(gdal|ogr|cpl_)")},
        {"PROJ", std::regex("^proj\\.h")},
        {"libheif", std::regex("^libheif/")},
        {"Eigen", std::regex("^(Eigen/|unsupported/Eigen)")},
        {"nlohmann", std::regex("^nlohmann/")},
        {"pugixml", std::regex("^pugixml")},
        {"zlib", std::regex("^zlib\\.h")},
        {"minizip", std::regex("^minizip/")},
        {"OpenSSL", std::regex("^openssl/")},
        {"xxHash", std::regex("^xxh")},
        {"nanoflann", std::regex("^nanoflann")},
        {"OpenGL", std::regex("^(GL|EGL)/")},
        {"X11", std::regex("^(X11/|xcb/)")},
        {"QPDF", std::regex("^qpdf/")},
        {"Python", std::regex("^(pybind11/|Python\\.h)")},
    };
    return list;
}

std::string libraryOf(const std::string& header) {
    for (const Library& library : libraries()) {
        if (std::regex_search(header, library.headers)) {
            return library.name;
        }
    }
    return "";
}

/// What the files of a folder may include; the longest folder that fits a file decides.
struct Room {
    std::string folder;
    std::set<std::string> house;    ///< folders of the house
    std::set<std::string> outside;  ///< libraries; the standard library and POSIX are free to all
};

/// The table of section 3 of the design.
const std::vector<Room>& rooms() {
    static const std::vector<Room> table{
        {"core", {"core"}, {"Eigen", "xxHash"}},
        {"core/engine", {"core"}, {"Eigen", "Bullet"}},
        {"core/evidence/clouds", {"core"}, {"Eigen", "nanoflann"}},
        {"core/selftest", {"core"}, {"Eigen"}},
        {"io",
         {"core", "io"},
         {"Eigen", "HDF5", "Exodus", "GDAL", "PROJ", "libheif", "VTK", "nlohmann", "pugixml", "zlib", "minizip", "OpenSSL"}},
        {"widgets/render", {"core", "widgets/render"}, {"Eigen", "VTK"}},
        {"widgets/figures", {"core", "widgets/render", "widgets/figures"}, {"Eigen", "VTK", "Qt", "X11", "QPDF"}},
        {"widgets", {"core", "widgets"}, {"Eigen", "VTK", "Qt"}},
        {"app/gui", {"core", "io", "widgets", "app/gui"}, {"Eigen", "Qt"}},
        {"app/python", {"core", "io", "app/python"}, {"Eigen", "Python"}},
        {"app/cli", {"core", "io", "widgets/render", "widgets/figures", "app/cli"}, {"Eigen", "Qt"}},
    };
    return table;
}

const Room* roomOf(const SourceFile& file) {
    const Room* room = nullptr;
    for (const Room& candidate : rooms()) {
        if (file.under(candidate.folder) && (!room || candidate.folder.size() > room->folder.size())) {
            room = &candidate;
        }
    }
    return room;
}

bool houseAllows(const Room& room, const std::string& path) {
    return std::any_of(room.house.begin(), room.house.end(),
                       [&](const std::string& folder) { return path.starts_with(folder + "/"); });
}

/// Headers of a VTK module that draws: its readers and data model come without.
bool vtkDraws(const std::string& header) {
    static const std::regex drawing(
        "^vtk(Render|OpenGL|GenericOpenGL|Actor|Prop|Camera|Light|Texture|Shader|Interactor|Text(Actor|Mapper|Property|Renderer)|"
        ".*Mapper|.*Picker|Window|GL2PS|SVG|Chart|Context)");
    return std::regex_search(header, drawing);
}

TEST(Include, EveryFileStandsInARoom) {
    for (const SourceFile& file : programSources()) {
        EXPECT_TRUE(roomOf(file)) << file.path << " stands in no room of the table";
    }
}

TEST(Include, RoomsSeeOnlyWhatTheTableAllows) {
    std::size_t checked = 0;
    for (const SourceFile& file : programSources()) {
        const Room* room = roomOf(file);
        ASSERT_TRUE(room);
        for (const Include& include : includesOf(file)) {
            ++checked;
            if (include.quoted) {
                EXPECT_TRUE(houseAllows(*room, include.name))
                    << place(file, include.line) << ": " << room->folder << " must not see " << include.name;
                continue;
            }
            const std::string library = libraryOf(include.name);
            EXPECT_TRUE(library.empty() || room->outside.contains(library))
                << place(file, include.line) << ": " << room->folder << " must not include " << library << " (" << include.name
                << ")";
        }
    }
    EXPECT_GT(checked, 500u) << "the sources were not found";
}

// The suite of hard cases looks at everything, so nothing may lean on it but its command and the report.
TEST(Include, NothingOfTheProgramSeesTheSelfTestButItsCommandAndTheReport) {
    std::size_t seen = 0;
    for (const SourceFile& file : programSources()) {
        for (const Include& include : includesOf(file)) {
            if (include.quoted && include.name.starts_with("core/selftest/")) {
                ++seen;
                EXPECT_TRUE(file.under("core/selftest") || file.path == "app/cli/run/self_test_command.cpp" ||
                            file.path == "app/cli/exports/report_request.cpp" || file.path == "app/gui/exports/run_orders.cpp")
                    << place(file, include.line) << ": " << include.name;
            }
        }
    }
    EXPECT_GT(seen, 5u);
}

TEST(Include, IoIncludesNoRenderingOfVtk) {
    for (const SourceFile& file : readSources({"io"})) {
        for (const Include& include : includesOf(file)) {
            EXPECT_FALSE(vtkDraws(include.name)) << place(file, include.line) << ": " << include.name;
        }
    }
}

TEST(Include, FiguresAndCommandLineIncludeNoQtWidgets) {
    const std::filesystem::path headers(RUBBLE_QT_WIDGETS_HEADERS);
    if (!headers.empty()) {
        ASSERT_TRUE(std::filesystem::exists(headers / "QWidget")) << headers;
    }
    for (const SourceFile& file : readSources({"widgets/figures", "widgets/render", "app/cli"})) {
        for (const Include& include : includesOf(file)) {
            if (libraryOf(include.name) != "Qt") {
                continue;
            }
            const bool widgets = include.name.starts_with("QtWidgets") || include.name.starts_with("QtOpenGLWidgets") ||
                                 (!headers.empty() && std::filesystem::exists(headers / include.name));
            EXPECT_FALSE(widgets) << place(file, include.line) << ": " << include.name;
        }
    }
}

// Third-party types stop at the seams: what a room shows to others must compile without its private libraries.
TEST(Include, HeadersThatOthersIncludeShowNoPrivateLibrary) {
    const std::vector<SourceFile> files = programSources();
    std::map<std::string, const SourceFile*> byPath;
    for (const SourceFile& file : files) {
        byPath[file.path] = &file;
    }
    const auto topFolder = [](const Room& room) { return room.folder.starts_with("core") ? std::string("core") : room.folder; };
    const std::map<std::string, std::set<std::string>> shown{
        {"core", {"Eigen"}},          {"io", {"Eigen"}}, {"widgets/render", {"Eigen"}}, {"widgets/figures", {"Eigen", "Qt"}},
        {"widgets", {"Eigen", "Qt"}},
    };
    std::set<std::string> visited;
    const std::function<void(const std::string&, const std::string&)> follow = [&](const std::string& path,
                                                                                   const std::string& from) {
        const auto found = byPath.find(path);
        if (found == byPath.end() || !visited.insert(path).second) {
            return;
        }
        const Room* room = roomOf(*found->second);
        for (const Include& include : includesOf(*found->second)) {
            const std::string library = libraryOf(include.name);
            const auto allowed = shown.find(topFolder(*room));
            if (!include.quoted && !library.empty() && allowed != shown.end()) {
                EXPECT_TRUE(allowed->second.contains(library))
                    << place(*found->second, include.line) << " shows " << include.name << " to " << from;
            }
            if (include.quoted) {
                follow(include.name, from);
            }
        }
    };
    for (const SourceFile& file : files) {
        for (const Include& include : includesOf(file)) {
            const auto found = byPath.find(include.name);
            if (include.quoted && found != byPath.end() && topFolder(*roomOf(file)) != topFolder(*roomOf(*found->second))) {
                follow(include.name, file.path);
            }
        }
    }
    EXPECT_GT(visited.size(), 20u);
}

/// Paths of the headers that are installed.
std::set<std::string> publicHeaders() {
    std::ifstream stream(sourcePath("cmake/public_headers.cmake"));
    std::set<std::string> headers;
    const std::regex path("^ +((core|io)/[a-z0-9_/]+\\.h)");
    for (std::string line; std::getline(stream, line);) {
        std::smatch match;
        if (std::regex_search(line, match, path)) {
            headers.insert(match[1]);
        }
    }
    return headers;
}

// The library is what is installed: whole, free of libraries but Eigen, and every type and function of it explained.
TEST(Include, PublicHeadersAreCompleteAndShowEigenAlone) {
    const std::set<std::string> headers = publicHeaders();
    ASSERT_GT(headers.size(), 40u);
    std::set<std::string> found;
    for (const SourceFile& file : readSources({"core", "io"})) {
        if (!headers.contains(file.path)) {
            continue;
        }
        found.insert(file.path);
        for (const Include& include : includesOf(file)) {
            EXPECT_TRUE(!include.quoted || headers.contains(include.name))
                << place(file, include.line) << ": " << include.name << " is not installed";
            const std::string library = libraryOf(include.name);
            EXPECT_TRUE(library.empty() || library == "Eigen") << place(file, include.line) << ": " << include.name;
        }
    }
    EXPECT_EQ(found, headers) << "a header of the list does not exist";
}

TEST(Include, TypesOfPublicHeadersAreExplained) {
    const std::set<std::string> headers = publicHeaders();
    const std::regex type("^(class|struct|enum class) [A-Z][A-Za-z]* .*\\{");
    std::size_t checked = 0;
    for (const SourceFile& file : readSources({"core", "io"})) {
        for (std::size_t i = 0; headers.contains(file.path) && i < file.lines.size(); ++i) {
            if (std::regex_search(file.lines[i], type)) {
                ++checked;
                // Before it, on its members, or before the neighbours that it stands among.
                const std::string& before = file.lines[i - 1];
                bool explained = before.starts_with("///") || before == "};" || file.lines[i].ends_with("};");
                for (std::size_t m = i; m < file.lines.size() && !file.lines[m].starts_with("};"); ++m) {
                    explained = explained || file.lines[m].find("///") != std::string::npos;
                }
                EXPECT_TRUE(explained) << place(file, i + 1) << ": " << file.lines[i];
            }
        }
    }
    EXPECT_GT(checked, 60u);
}

TEST(Include, TheVersionOfTheHeadersIsThatOfTheProject) {
    const auto first = [](const std::string& path, const std::string& pattern) {
        std::ifstream stream(sourcePath() + "/" + path);
        std::stringstream text;
        text << stream.rdbuf();
        const std::string whole = text.str();
        std::smatch match;
        return std::regex_search(whole, match, std::regex(pattern)) ? match[1].str() : std::string();
    };
    std::string version;
    for (const char* part : {"MAJOR", "MINOR", "PATCH"}) {
        version += (version.empty() ? "" : ".") + first("core/base/version.h", std::string("RUBBLE_VERSION_") + part + " ([0-9]+)");
    }
    EXPECT_EQ(version, first("CMakeLists.txt", "project\\(Rubble VERSION ([0-9.]+)"));
    EXPECT_NE(version, "");
}

TEST(Include, QuotedIncludesExistAndAreWrittenFromTheRoot) {
    const std::filesystem::path root(sourcePath());
    for (const SourceFile& file : allSources()) {
        for (const Include& include : includesOf(file)) {
            // What moc makes lies in the build folder.
            const bool made = include.name.starts_with("moc_") || include.name.ends_with(".moc");
            if (include.quoted && !made) {
                EXPECT_TRUE(std::filesystem::exists(root / include.name)) << place(file, include.line) << ": " << include.name;
            }
        }
    }
}

TEST(Include, NoHeaderIncludesItselfInACircle) {
    std::map<std::string, std::vector<std::string>> graph;
    for (const SourceFile& file : programSources()) {
        for (const Include& include : includesOf(file)) {
            if (include.quoted) {
                graph[file.path].push_back(include.name);
            }
        }
    }
    std::map<std::string, int> colour;  // 1: on the way, 2: done
    const std::function<void(const std::string&)> visit = [&](const std::string& path) {
        colour[path] = 1;
        for (const std::string& next : graph[path]) {
            EXPECT_NE(colour[next], 1) << path << " includes " << next << " in a circle";
            if (colour[next] == 0) {
                visit(next);
            }
        }
        colour[path] = 2;
    };
    for (const auto& [path, next] : std::map(graph)) {
        if (colour[path] == 0) {
            visit(path);
        }
    }
}

TEST(Include, ClassifierKnowsTheLibraries) {
    EXPECT_EQ(libraryOf("btBulletDynamicsCommon.h"), "Bullet");
    EXPECT_EQ(libraryOf("BulletCollision/CollisionShapes/btBoxShape.h"), "Bullet");
    EXPECT_EQ(libraryOf("LinearMath/btVector3.h"), "Bullet");
    EXPECT_EQ(libraryOf("QImage"), "Qt");
    EXPECT_EQ(libraryOf("QtCore/QString"), "Qt");
    EXPECT_EQ(libraryOf("vtkPolyData.h"), "VTK");
    EXPECT_EQ(libraryOf("hdf5.h"), "HDF5");
    EXPECT_EQ(libraryOf("exodusII.h"), "Exodus");
    EXPECT_EQ(libraryOf("Eigen/Dense"), "Eigen");
    EXPECT_EQ(libraryOf("queue"), "");
    EXPECT_EQ(libraryOf("vector"), "");
    EXPECT_TRUE(vtkDraws("vtkRenderer.h"));
    EXPECT_TRUE(vtkDraws("vtkPolyDataMapper.h"));
    EXPECT_FALSE(vtkDraws("vtkUnstructuredGrid.h"));
    EXPECT_FALSE(vtkDraws("vtkXMLUnstructuredGridWriter.h"));
}

}  // namespace

}  // namespace rubble::house
