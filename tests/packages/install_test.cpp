#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <memory>

#include "tests/support/command_run.h"
#include "tests/support/places.h"
#include "tests/support/small_collapse.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/whole_file.h"

namespace rubble::cli {

namespace {

namespace fs = std::filesystem;

using testing::HasSubstr;
using testing::Not;

const std::string build = buildPath();

void expectOk(const Outcome& outcome) {
    EXPECT_EQ(outcome.exitCode, 0) << outcome.out << outcome.err;
}

/// Installs one component of what is built below a folder.
void install(const std::string& component, const std::string& prefix) {
    expectOk(CommandRun().run({"cmake", "--install", build, "--prefix", prefix, "--component", component, "--strip"}));
}

/// The programs as they are installed, once for all tests.
class Installed : public testing::Test {
protected:
    static void SetUpTestSuite() {
        s_installed = std::make_unique<io::TemporaryFolder>();
        install("runtime", prefix());
    }
    static void TearDownTestSuite() { s_installed.reset(); }
    static std::string prefix() { return *s_installed / "usr"; }
    /// Programs see neither the build folder nor settings of the user.
    CommandRun apart() {
        CommandRun command;
        command.in("/").with("HOME", m_folder / "home").with("XDG_STATE_HOME", std::nullopt).with("LD_LIBRARY_PATH", std::nullopt);
        return command;
    }

    io::TemporaryFolder m_folder;

private:
    static inline std::unique_ptr<io::TemporaryFolder> s_installed;
};

TEST_F(Installed, TheProgramsRunFromWhereTheyAre) {
    const std::string program = prefix() + "/bin/rubble-cli";
    expectOk(apart().run({program, "--version"}));
    const std::string fe = writeSmallCollapse(m_folder / "small.exo");
    const Outcome run = apart().run({program, "run", fe, "--set", "settle_time=0.5", "--json", "--out", m_folder / "s.run.h5"});
    expectOk(run);
    // The same program as that of the build folder, bit by bit.
    const Outcome built = cli({"run", fe, "--set", "settle_time=0.5", "--json"});
    EXPECT_EQ(run.json()["trajectory_hash"], built.json()["trajectory_hash"]);
    expectOk(apart().run({program, "figure", m_folder / "s.run.h5", "--out", m_folder / "s.png"}));
}

TEST_F(Installed, TheWindowFindsItsSampleAndDrawsIt) {
    fs::create_directories(m_folder / "home");
    const std::string sample = prefix() + "/share/rubble/samples/river-arch.rubble";
    ASSERT_TRUE(fs::exists(sample));
    const Outcome shown = apart().run({"xvfb-run", "-a", "-s", "-screen 0 1280x800x24", prefix() + "/bin/rubble", sample,
                                       "--screenshot", m_folder / "window.png", "--size", "1280x800"});
    expectOk(shown);
    EXPECT_GT(fs::file_size(m_folder / "window.png"), 50000u);
    EXPECT_TRUE(fs::exists(prefix() + "/share/rubble/samples/stone-arch.exo"));
}

TEST_F(Installed, NothingNamesTheBuildFolder) {
    std::size_t files = 0;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(prefix())) {
        if (entry.is_regular_file() && entry.path().extension() != ".exo") {
            ++files;
            const std::string text = textOf(entry.path().string());
            EXPECT_EQ(text.find(build), std::string::npos) << entry.path();
        }
    }
    EXPECT_GT(files, 15u);
}

TEST_F(Installed, TheDesktopKnowsTheProgramAndItsFiles) {
    const std::string share = prefix() + "/share";
    const Outcome entry = CommandRun().run({"desktop-file-validate", share + "/applications/org.rubble.Rubble.desktop"});
    expectOk(entry);
    EXPECT_EQ(entry.out, "");
    const Outcome about =
        CommandRun().run({"appstreamcli", "validate", "--no-net", share + "/metainfo/org.rubble.Rubble.metainfo.xml"});
    expectOk(about);
    expectOk(CommandRun().run({"update-mime-database", share + "/mime"}));
    EXPECT_THAT(textOf(share + "/mime/globs2"), HasSubstr("application/x-rubble-case:*.rubble"));
    EXPECT_TRUE(fs::exists(share + "/icons/hicolor/scalable/apps/org.rubble.Rubble.svg"));
    for (const char* name : {"rubble", "rubble-cli"}) {
        const std::string page = share + "/man/man1/" + name + ".1";
        const Outcome read = CommandRun().run({"groff", "-man", "-ww", "-T", "utf8", page});
        EXPECT_EQ(read.err, "") << page;
        const std::string completion = share + "/bash-completion/completions/" + name;
        expectOk(CommandRun().run({"bash", "-n", completion}));
    }
}

// find_package(Rubble) from a project of somebody else.
TEST(InstalledLibraries, WholeTheLibrariesBuildTheExamples) {
    const io::TemporaryFolder home;
    const std::string prefix = home / "usr";
    install("development", prefix);
    const std::string examples = prefix + "/share/rubble/examples/library";
    const std::string folder = home / "examples";
    expectOk(CommandRun().run(
        {"cmake", "-S", examples, "-B", folder, "-G", "Ninja", "-DCMAKE_PREFIX_PATH=" + prefix, "-DCMAKE_BUILD_TYPE=Debug"}));
    expectOk(CommandRun().run({"cmake", "--build", folder}));
    const Outcome wall = CommandRun().run({folder + "/falling_wall"});
    expectOk(wall);
    EXPECT_THAT(wall.out, HasSubstr("12 fragments, 12 bodies"));
    const std::string fe = writeSmallCollapse(home / "small.exo");
    const Outcome recorded = CommandRun().run({folder + "/record_run", fe, home / "r.run.h5"});
    expectOk(recorded);
    EXPECT_THAT(recorded.out, HasSubstr("5 fragments"));
    const Outcome verified = cli({"verify", home / "r.run.h5"});
    expectOk(verified);
    EXPECT_THAT(verified.out, HasSubstr("bit-equal"));
    const Outcome wrong = CommandRun().run({folder + "/record_run", home / "missing.exo", home / "r.run.h5"});
    EXPECT_EQ(wrong.exitCode, 1);
    EXPECT_THAT(wrong.err, HasSubstr("missing.exo"));
}

class Packaged : public testing::Test {
protected:
    std::string packageOf(const std::string& name) {
        for (const fs::directory_entry& entry : fs::directory_iterator(m_folder.path())) {
            if (entry.path().filename().string().starts_with(name + "_") && entry.path().extension() == ".deb") {
                return entry.path().string();
            }
        }
        return "";
    }
    std::string field(const std::string& package, const std::string& name) {
        return CommandRun().run({"dpkg-deb", "-f", package, name}).out;
    }

    io::TemporaryFolder m_folder;
};

TEST_F(Packaged, TheDebianPackagesHoldAllAndNameWhatTheyNeed) {
    // Quick to pack; what is handed out is packed small.
    const Outcome made =
        CommandRun().in(build).run({"cpack", "-G", "DEB", "-D", "CPACK_DEBIAN_COMPRESSION_TYPE=zstd", "-B", m_folder.path()});
    ASSERT_EQ(made.exitCode, 0) << made.out << made.err;
    const std::string programs = packageOf("rubble");
    const std::string libraries = packageOf("librubble-dev");
    ASSERT_NE(programs, "");
    ASSERT_NE(libraries, "");
    for (const char* needed : {"libc6", "libqt6widgets6", "libvtk9", "libhdf5", "libgdal", "libbullet"}) {
        EXPECT_THAT(field(programs, "Depends"), HasSubstr(needed));
    }
    EXPECT_THAT(field(programs, "Recommends"), HasSubstr("xvfb"));
    EXPECT_THAT(field(libraries, "Depends"), HasSubstr("libeigen3-dev"));
    const std::string content = CommandRun().run({"dpkg-deb", "-c", programs}).out;
    for (const char* file :
         {"./usr/bin/rubble\n", "./usr/bin/rubble-cli\n", "./usr/share/applications/org.rubble.Rubble.desktop\n",
          "./usr/share/mime/packages/org.rubble.Rubble.xml\n", "./usr/share/man/man1/rubble-cli.1\n",
          "./usr/share/bash-completion/completions/rubble-cli\n", "./usr/share/rubble/samples/stone-arch.exo\n"}) {
        EXPECT_THAT(content, HasSubstr(file));
    }
    EXPECT_THAT(content, Not(HasSubstr(".runs.json")));
    EXPECT_THAT(content, Not(testing::ContainsRegex("[^/]/usr/include")));
    // Alone with what it asks for, in a root that has nothing else.
    const std::string root = m_folder / "root";
    const std::string script = sourcePath("tests/packages/clean_root.sh");
    expectOk(CommandRun().run({script, "make", programs, root}));
    const auto there = [&](std::vector<std::string> words) {
        words.insert(words.begin(), {script, "run", root});
        return CommandRun().run(words);
    };
    EXPECT_NE(there({"test", "-e", build}).exitCode, 0) << "it is no root of its own";
    const Outcome version = there({"rubble-cli", "--version"});
    expectOk(version);
    EXPECT_EQ(version.out, cli({"--version"}).out);
    const std::string fe = writeSmallCollapse(root + "/tmp/small.exo");
    const Outcome run =
        there({"rubble-cli", "run", "/tmp/small.exo", "--set", "settle_time=0.5", "--json", "--out", "/tmp/s.run.h5"});
    expectOk(run);
    EXPECT_EQ(run.json()["trajectory_hash"], cli({"run", fe, "--set", "settle_time=0.5", "--json"}).json()["trajectory_hash"]);
    expectOk(there({"rubble-cli", "figure", "/tmp/s.run.h5", "--out", "/tmp/s.png"}));
    const Outcome shown =
        there({"xvfb-run", "-a", "-s", "-screen 0 1280x800x24", "rubble", "/usr/share/rubble/samples/river-arch.rubble",
               "--screenshot", "/tmp/window.png", "--size", "1280x800"});
    expectOk(shown);
    EXPECT_GT(fs::file_size(root + "/tmp/window.png"), 50000u);
}

/// A project that makes packages as ours does, and has found nothing before.
std::string packagesAlone() {
    return "cmake_minimum_required(VERSION 3.25)\nproject(Rubble VERSION 1.0 LANGUAGES NONE DESCRIPTION alone)\n"
           "set(RUBBLE_PYTHON ON)\ninclude(" +
           sourcePath("cmake/packages.cmake") + ")\n";
}

void expectVersions(const std::string& configPath) {
    const std::string config = io::wholeFile(configPath);
    EXPECT_THAT(config, HasSubstr("python3 (>= 3."));
    EXPECT_THAT(config, HasSubstr("python3 (<< 3."));
    EXPECT_THAT(config, Not(HasSubstr("= .")));
}

// An empty version makes a package that apt cannot install.
TEST(Package, NamesTheVersionsThatItDependsOn) {
    const io::TemporaryFolder folder;
    std::ofstream(folder / "CMakeLists.txt") << packagesAlone();
    expectOk(CommandRun().run({"cmake", "-G", "Ninja", "-S", folder.path(), "-B", folder / "package"}));
    expectVersions(folder / "package/CPackConfig.cmake");
}

TEST(Package, WholeThePresetNamesThemToo) {
    const io::TemporaryFolder folder;
    expectOk(CommandRun().in(sourcePath()).run({"cmake", "--preset", "package", "-B", folder / "package"}));
    expectVersions(folder / "package/CPackConfig.cmake");
}

}  // namespace

}  // namespace rubble::cli
