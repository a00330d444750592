#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "tests/support/command_run.h"
#include "tests/support/places.h"
#include "tests/support/temporary_folder.h"

namespace rubble::cli {

namespace {

namespace fs = std::filesystem;

using testing::HasSubstr;
using testing::Not;

// What the fakes do: the files `installed` and `plan` say what there is, `asked` keeps what was asked of apt.
constexpr const char* dpkgQuery = R"sh(
for name; do
    if grep -qx -- "$name" "$WORLD/installed"; then echo "ii  $name"; fi
done
)sh";
constexpr const char* aptGet = R"sh(
echo "$*" >>"$WORLD/asked"
case " $* " in
    *" -s "*) cat "$WORLD/plan"; exit "$(cat "$WORLD/plan-rc")" ;;
    *" install "*)
        echo "dlstatus:1:50.0:Downloading"
        echo "pmstatus:libvtk9-dev:40.0:Installing"
        cp packages.txt "$WORLD/installed" ;;
esac
)sh";
constexpr const char* aptCache = R"sh(
printf 'libvtk9-dev\n  Depends: python3-vtk9\ncmake\n  Depends: libc6\n'
)sh";
constexpr const char* cmake = R"sh(
echo "cmake $*" >>"$WORLD/built"
if [ "$1" = --preset ]; then
    mkdir -p "build/$2/bin"
    echo "CMAKE_HOME_DIRECTORY:INTERNAL=$PWD" >"build/$2/CMakeCache.txt"
    echo >"build/$2/build.ninja"
    printf '#!/bin/sh\necho "workbench $*"\n' >"build/$2/bin/rubble"
    chmod +x "build/$2/bin/rubble"
else
    for step in 1 2 3; do echo "building $step of 3 Compiling"; done
fi
)sh";
constexpr const char* ninja = R"sh(
if [ -e "$WORLD/stale" ]; then echo "[3/3] Linking"; else echo "ninja: no work to do."; fi
)sh";

/// ./run in a folder of its own, where apt, dpkg, CMake and ninja are fakes: nothing is installed or built.
class Start : public testing::Test {
protected:
    void SetUp() override {
        fs::create_directories(m_folder / "bin");
        fs::copy_file(sourcePath("run"), m_folder / "run");
        write("packages.txt", "cmake\nlibvtk9-dev\nninja-build\n");
        write("CMakePresets.json", "{}");
        // Older than what CMake writes, as in a tree that was fetched a while ago.
        fs::last_write_time(m_folder / "CMakePresets.json", fs::file_time_type::clock::now() - std::chrono::hours(1));
        installed("cmake\nlibvtk9-dev\nninja-build\n");
        plan("Inst cmake\nInst libvtk9-dev\nInst python3-vtk9\n", 0);
        fake("dpkg-query", dpkgQuery);
        fake("apt-get", aptGet);
        fake("apt-cache", aptCache);
        fake("cmake", cmake);
        fake("ninja", ninja);
        fake("nproc", "echo 8");
        // Root, unless a test says otherwise.
        fake("id", "echo 0");
        fake("sudo", "exit 1");
        write("asked", "");
        write("built", "");
    }
    void write(const std::string& name, const std::string& text) { std::ofstream(m_folder / name) << text; }
    void fake(const std::string& name, const std::string& script) {
        write("bin/" + name, "#!/bin/bash\n" + script);
        fs::permissions(m_folder / ("bin/" + name), fs::perms::owner_all);
    }
    void installed(const std::string& names) { write("installed", names); }
    /// What `apt-get -s install` says.
    void plan(const std::string& words, int exitCode) {
        write("plan", words);
        write("plan-rc", std::to_string(exitCode));
    }
    Outcome start() {
        return CommandRun()
            .in(m_folder.path())
            .with("PATH", m_folder / "bin" + ":" + std::getenv("PATH"))
            .with("WORLD", m_folder.path())
            .with("DISPLAY", ":none")
            .run({m_folder / "run"});
    }
    std::string asked() { return textOf(m_folder / "asked"); }
    std::string built() { return textOf(m_folder / "built"); }

    io::TemporaryFolder m_folder;
};

TEST_F(Start, InstallsBuildsAndOpensAndSaysBeforeHowLongItTakes) {
    installed("cmake\n");
    write("stale", "");
    const Outcome outcome = start();
    EXPECT_EQ(outcome.exitCode, 0) << outcome.out << outcome.err;
    const std::vector<std::string> inOrder{"The first build takes long",
                                           "minutes on two cores",
                                           "on the 8 of this machine",
                                           "Installing 2, with all that they need 3 packages",
                                           "libvtk9-dev ninja-build",
                                           "installing: 70 %",
                                           "Configuring",
                                           "Building: preset release, 3 steps",
                                           "building 3 of 3",
                                           "Starting",
                                           "workbench resources/samples/stone-arch.rubble"};
    std::size_t at = 0;
    for (const std::string& said : inOrder) {
        at = outcome.out.find(said, at);
        ASSERT_NE(at, std::string::npos) << said << " is missing or too early in:\n" << outcome.out;
    }
    EXPECT_THAT(asked(), HasSubstr("install -y --no-remove"));
    EXPECT_THAT(asked(), Not(HasSubstr("cmake"))) << "it is there";
}

TEST_F(Start, AsksNothingOfAptWhenAllIsThereAndIsQuickTheSecondTime) {
    start();
    write("built", "");
    const auto begin = std::chrono::steady_clock::now();
    const Outcome second = start();
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
    EXPECT_EQ(second.exitCode, 0) << second.err;
    EXPECT_EQ(asked(), "");
    EXPECT_THAT(built(), Not(HasSubstr("cmake --preset"))) << "configured already";
    EXPECT_THAT(built(), HasSubstr("--build"));
    EXPECT_THAT(second.out, Not(HasSubstr("minutes")));
    EXPECT_THAT(second.out, HasSubstr("workbench"));
    EXPECT_LT(took.count(), 2.0);
}

TEST_F(Start, ConfiguresAnewAfterAChangeOfThePresetsOrAMoveOfTheTree) {
    start();
    write("built", "");
    fs::last_write_time(m_folder / "CMakePresets.json", fs::file_time_type::clock::now() + std::chrono::hours(1));
    start();
    EXPECT_THAT(built(), HasSubstr("cmake --preset release"));
    fs::last_write_time(m_folder / "CMakePresets.json", fs::file_time_type::clock::now() - std::chrono::hours(1));
    write("built", "");
    write("build/release/CMakeCache.txt", "CMAKE_HOME_DIRECTORY:INTERNAL=/elsewhere\n");
    start();
    EXPECT_THAT(built(), HasSubstr("cmake --preset release"));
}

// As apt 2.6 says it with ParaView's Python package.
TEST_F(Start, TellsAConflictAndInstallsNothing) {
    installed("cmake\npython3-paraview\n");
    plan(
        "Some packages could not be installed.\n\nThe following packages have unmet dependencies:\n"
        " python3-paraview : Conflicts: python3-vtk9 but 9.1.0 is to be installed\n"
        "E: Error, pkgProblemResolver::Resolve generated breaks, this may be caused by held packages.\n",
        100);
    const Outcome outcome = start();
    EXPECT_EQ(outcome.exitCode, 1);
    EXPECT_THAT(outcome.err,
                HasSubstr("python3-paraview, which is installed, conflicts with python3-vtk9, which libvtk9-dev needs"));
    EXPECT_THAT(outcome.err, HasSubstr("./run removes nothing"));
    EXPECT_THAT(outcome.err, HasSubstr("  ./run deb\n"));
    EXPECT_EQ(outcome.out, "") << "no estimate of what cannot be done";
    EXPECT_THAT(asked(), HasSubstr("-s "));
    EXPECT_THAT(asked(), Not(HasSubstr("install -y"))) << "only asked, never done";
    EXPECT_EQ(built(), "");
}

TEST_F(Start, NamesWhatAptWouldRemove) {
    installed("cmake\n");
    plan(
        "The following packages will be REMOVED:\n  python3-paraview* paraview-doc*\nThe following NEW packages will be "
        "installed:\n"
        "  libvtk9-dev\nE: Packages need to be removed but remove is disabled.\n",
        100);
    const Outcome outcome = start();
    EXPECT_EQ(outcome.exitCode, 1);
    EXPECT_THAT(outcome.err, HasSubstr("have to remove python3-paraview\n"));
    EXPECT_THAT(outcome.err, HasSubstr("have to remove paraview-doc\n"));
    EXPECT_THAT(outcome.err, Not(HasSubstr("remove libvtk9-dev")));
    EXPECT_THAT(asked(), Not(HasSubstr("install -y")));
}

TEST_F(Start, SaysAllThatIsMissingAtOnceToAUserWithoutSudo) {
    installed("cmake\n");
    fake("id", "echo 1000");
    const Outcome outcome = start();
    EXPECT_EQ(outcome.exitCode, 1);
    EXPECT_THAT(outcome.err, HasSubstr("2 packages are missing"));
    EXPECT_THAT(outcome.err, HasSubstr("apt-get install --no-remove --no-install-recommends libvtk9-dev ninja-build\n"));
    EXPECT_THAT(asked(), Not(HasSubstr("install -y")));
}

TEST_F(Start, RefusesOtherWords) {
    const Outcome outcome = CommandRun().in(m_folder.path()).run({m_folder / "run", "fast"});
    EXPECT_EQ(outcome.exitCode, 1);
    EXPECT_THAT(outcome.err, HasSubstr("./run [test [quick|all] | deb]"));
}

}  // namespace

}  // namespace rubble::cli
