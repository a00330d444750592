#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "tests/support/command_run.h"
#include "tests/support/small_collapse.h"

namespace rubble::cli {

namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class OutputFolder : public SmallRun {};

TEST_F(OutputFolder, EveryCommandThatWritesMakesTheFolderOfItsFile) {
    m_out = m_folder / "new/runs/small.run.h5";
    const auto path = [this](const std::string& name) { return m_folder / ("made/" + name); };
    run({"--export", "fragments=" + path("1/a/f.csv")}, "0.5");
    EXPECT_TRUE(fs::exists(m_out));
    EXPECT_TRUE(fs::exists(path("1/a/f.csv")));
    const auto made = [&](std::vector<std::string> words, const std::string& name) {
        const Outcome outcome = cli(words);
        EXPECT_EQ(outcome.exitCode, 0) << words.front() << outcome.err;
        EXPECT_TRUE(fs::exists(path(name))) << words.front();
    };
    made({"export", m_out, "--export", "series=" + path("2/s.pvd")}, "2/s.pvd");
    made({"export", m_out, "--export", "vtkhdf=" + path("3/t.vtkhdf")}, "3/t.vtkhdf");
    made({"export", m_out, "--export", "bodies=" + path("4/b.xdmf")}, "4/b.xdmf");
    made({"export", m_out, "--export", "gltf=" + path("5/g.glb")}, "5/g.glb");
    made({"export", m_out, "--export", "debris-map=" + path("6/d.tif")}, "6/d.tif");
    made({"map", m_out, "--out", path("7/b/m.gpkg"), "--csv", path("8/m.csv")}, "7/b/m.gpkg");
    made({"convert", m_path, path("9/copy.exo")}, "9/copy.exo");
}

TEST_F(OutputFolder, WhereNoneCanBeMadeTheErrorSaysWhy) {
    run({}, "0.5");
    std::ofstream(m_folder / "file") << "no folder";
    for (const std::vector<std::string>& words : std::vector<std::vector<std::string>>{
             {"export", m_out, "--export", "gltf=" + (m_folder / "file/g.glb")},
             {"map", m_out, "--out", m_folder / "file/m.tif"},
             {"figure", m_out, "--out", m_folder / "file/f.png"},
             {"report", m_out, "--out", m_folder / "file/r"},
             {"convert", m_path, m_folder / "file/c.exo"},
         }) {
        const Outcome outcome = cli(words);
        EXPECT_EQ(outcome.exitCode, 1) << words.front();
        EXPECT_THAT(outcome.err, HasSubstr("file")) << words.front();
        EXPECT_THAT(outcome.err, HasSubstr("cannot be made: Not a directory")) << words.front();
        EXPECT_THAT(outcome.err, HasSubstr("Name another folder")) << words.front();
    }
}

}  // namespace

}  // namespace rubble::cli
