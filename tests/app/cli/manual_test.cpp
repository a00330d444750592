#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <regex>
#include <set>

#include "io/case/case_file.h"
#include "tests/support/command_run.h"
#include "tests/support/small_collapse.h"
#include "tests/support/temporary_folder.h"

namespace rubble::cli {

namespace {

std::string manual() {
    return textOf(sourcePath("resources/manual/command-line.md"));
}

std::set<std::string> matches(const std::string& text, const std::string& pattern) {
    const std::regex expression(pattern);
    std::set<std::string> found;
    for (std::sregex_iterator it(text.begin(), text.end(), expression), end; it != end; ++it) {
        found.insert((*it)[1]);
    }
    return found;
}

std::set<std::string> commands() {
    return matches(cli({"--help"}).out, "\n  rubble-cli ([a-z][a-z-]+)");
}

/// Keys of an object and of all objects in it; entries that are named by what the user has in hand are left out.
void collectKeys(const nlohmann::json& value, std::set<std::string>& keys) {
    if (value.is_object()) {
        for (const auto& [key, inner] : value.items()) {
            keys.insert(key);
            collectKeys(inner, keys);
        }
    } else if (value.is_array()) {
        for (const nlohmann::json& inner : value) {
            collectKeys(inner, keys);
        }
    }
}

/// Points that a camera at (0, -20, 2) with a focal length of 4,000 pixels sees.
std::string writePairs(const std::string& path) {
    std::ofstream out(path);
    out << "picture_x_px,picture_y_px,x_m,y_m,z_m\n";
    for (int k = 0; k < 10; ++k) {
        const double x = (k * 7) % 10 - 4.5;
        const double y = (k * 3) % 7;
        const double z = (k * 5) % 8;
        out << 2000.0 + 4000.0 * x / (y + 20.0) << ',' << 1500.0 - 4000.0 * (z - 2.0) / (y + 20.0) << ',' << x << ',' << y << ','
            << z << '\n';
    }
    return path;
}

std::string bodyTable(const std::string& path) {
    std::ofstream(path) << "mass_kg,side_x_m,side_y_m,side_z_m,x_m,y_m,z_m\n2400,1,1,1,0,0,2\n";
    return path;
}

TEST(Manual, HasASectionForEveryCommandAndNoOther) {
    const std::set<std::string> documented = matches(manual(), "\n## rubble-cli ([a-z-]+)");
    EXPECT_EQ(documented, commands());
    EXPECT_GE(documented.size(), 7u);
}

TEST(Manual, NamesEveryOptionOfEveryCommandAndNoOther) {
    const std::string text = manual();
    std::set<std::string> options;
    for (const std::string& command : commands()) {
        options.merge(matches(cli({command, "--help"}).out, "\n  (--[a-z-]+)"));
    }
    options.insert({"--version", "--man-page", "--completion"});
    EXPECT_EQ(matches(text, "`(--[a-z-]+)"), options);
}

TEST(Manual, NamesEveryParameterWithItsDefault) {
    const std::string text = manual();
    const nlohmann::json table = cli({"parameters", "--json"}).json();
    ASSERT_GT(table["parameters"].size(), 30u);
    for (const nlohmann::json& row : table["parameters"]) {
        const std::string line = "| `" + row["key"].get<std::string>() + "` | " + row["default"].get<std::string>() + " | " +
                                 row["unit"].get<std::string>();
        EXPECT_NE(text.find(line), std::string::npos) << "no row: " << line;
    }
}

TEST(Manual, NamesEveryKeyOfEveryJsonObject) {
    io::TemporaryFolder folder;
    const std::string fe = writeSmallCollapse(folder / "small.exo");
    const std::string run = folder / "small.run.h5";
    std::set<std::string> keys;
    const std::string caseFile = folder / "small.rubble", bundle = folder / "small.rubblecase", pem = folder / "key.pem";
    io::saveCase(caseFile, io::caseForFe(fe, caseFile));
    CommandRun().run({"openssl", "genpkey", "-algorithm", "ed25519", "-out", pem});
    const std::vector<std::vector<std::string>> commandLines{
        {"inspect", fe},
        {"size", fe},
        {"effects", fe},
        {"run", fe, "--out", run, "--set", "settle_time=0.5"},
        {"verify", run},
        {"export", run, "--export", "fragments=" + (folder / "f.csv")},
        {"export", "--list"},
        {"map", run, "--cell", "1"},
        {"camera", writePairs(folder / "pairs.csv"), "--size", "4000x3000"},
        {"cloud", sourcePath("tests/data/clouds/point-time-color.laz")},
        {"cloud", sourcePath("tests/data/clouds/tiny_pc_and_images.e57")},
        {"evidence", sourcePath("resources/samples/stone-arch.rubble")},
        {"section", run, "--line", "-5,0.5,5,0.5"},
        {"scan", run, "--step", "1", "--out", folder / "scan.las"},
        {"cloud", folder / "scan.las", "--against", run, "--normal-scale", "1", "--projection-scale", "1", "--depth", "1"},
        {"cloud", folder / "scan.las", "--against", folder / "scan.las", "--normal-scale", "1", "--projection-scale", "1",
         "--depth", "1", "--cell", "2"},
        {"self-test", "--only", "free-fall"},
        {"drop", bodyTable(folder / "bodies.csv")},
        {"validate", "--only", "tschamut", "--repeats", "1"},
        {"parameters"},
        {"accuracy", fe, "--check", "--no-fps", "--multiples", "2", "--set", "settle_time=0.5", "--cache", folder / "cache"},
        {"calibrate", "--bodies", "8,12,27", "--no-drawing", "--cache", folder / "cache"},
        {"ensemble", fe, "--members", "2", "--set", "settle_time=0.5", "--cache", folder / "cache"},
        {"compare", fe, fe, "--members", "3", "--set", "settle_time=0.5", "--cache", folder / "cache"},
        {"convert", fe, folder / "converted.h5"},
        {"cache", "list", "--cache", folder / "cache"},
        {"seal", caseFile, "--key", pem, "--runs", run, "--out", bundle},
        {"report", run, "--check"},
        {"time-stamp", bundle, "--request", folder / "request.tsq"},
        {"custody", bundle, "--received-by", "B", "--received-from", "A"},
        {"addendum", bundle, caseFile, "--key", pem, "--by", "C. Expert", "--runs", run},
        {"open-sealed", bundle},
        {"inspect", folder / "missing.exo"}};
    for (std::vector<std::string> words : commandLines) {
        words.push_back("--json");
        collectKeys(cli(words).json(), keys);
    }
    ASSERT_GT(keys.size(), 80u);
    const std::string text = manual();
    for (const std::string& key : keys) {
        EXPECT_TRUE(std::regex_search(text, std::regex("[`,{ ]" + key + "[`,} \\[{]"))) << "not in the manual: " << key;
    }
}

TEST(Manual, SaysWhatTheExitCodesMean) {
    for (const char* code : {"| 0 |", "| 1 |", "| 2 |", "| 3 |"}) {
        EXPECT_THAT(manual(), testing::HasSubstr(code));
    }
}

}  // namespace

}  // namespace rubble::cli
