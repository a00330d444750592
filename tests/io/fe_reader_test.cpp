#include "io/fe/fe_reader.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <hdf5.h>

#include <fstream>

#include "core/base/error.h"
#include "io/base/files.h"
#include "io/case/case_file.h"
#include "io/fe/series_digest.h"
#include "tests/io/fe/d3plot/d3plot_builder.h"
#include "tests/io/fe/radioss/anim_builder.h"
#include "tests/support/temporary_folder.h"

namespace rubble::io {

namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

std::string openErrorOf(const std::string& path) {
    try {
        openFe(path, {}, {}, Execution{});
    } catch (const Error& error) {
        return englishText(error.message()) + " | " + englishText(error.remedy());
    }
    ADD_FAILURE() << "no error";
    return {};
}

TEST(FeReader, ContentDecidesNotTheName) {
    const TemporaryFolder folder;
    D3plotBuilder builder;
    builder.statesInRoot = 3;
    builder.write(folder / "looks_like.exo");
    EXPECT_EQ(openFe(folder / "looks_like.exo", {}, {}, Execution{})->contents().format, "LS-DYNA d3plot");
    AnimBuilder().write(folder.path(), {0});
    std::filesystem::rename(folder / "RUNA001", folder / "any.vtu");
    EXPECT_EQ(openFe(folder / "any.vtu", {}, {}, Execution{})->contents().format, "OpenRadioss animation");
}

TEST(FeReader, AFolderWithOneResultOpens) {
    const TemporaryFolder folder;
    EXPECT_THAT(openErrorOf(folder.path()), AllOf(HasSubstr("without an FE result"), HasSubstr("LS-DYNA d3plot")));
    D3plotBuilder().write(folder / "d3plot");
    std::ofstream(folder / "messages.txt") << "all is well\n";
    const auto fe = openFe(folder.path(), {}, {}, Execution{});
    EXPECT_EQ(fe->contents().path, folder / "d3plot");
    EXPECT_EQ(fe->contents().files.size(), 3u);
    EXPECT_EQ(feFiles(folder.path()), fe->contents().files);
    // A result of another format is named; a second one of the same format has to be chosen from.
    AnimBuilder().write(folder.path(), {0, 1});
    const auto preferred = openFe(folder.path(), {}, {}, Execution{});
    EXPECT_EQ(preferred->contents().format, "OpenRadioss animation");
    EXPECT_EQ(preferred->contents().findings.count("fe.folder_others"), 1);
    putFile(folder / "OTHERA001", AnimBuilder().file(0));
    EXPECT_THAT(openErrorOf(folder.path()), AllOf(HasSubstr("2 results"), HasSubstr("\"OTHERA001\", \"RUNA001\"")));
}

TEST(FeReader, DigestsOfSeries) {
    const TemporaryFolder folder;
    D3plotBuilder builder;
    builder.write(folder / "d3plot");
    std::string list;
    std::uint64_t bytes = 0;
    for (const char* name : {"d3plot", "d3plot01", "d3plot02"}) {
        list += sha256OfFile(folder / name) + "  " + name + "\n";
        bytes += std::filesystem::file_size(folder / name);
    }
    const auto fe = openFe(folder / "d3plot02", {}, {}, Execution{});
    EXPECT_EQ(fe->contents().sha256, sha256OfText(list));
    EXPECT_EQ(fe->contents().bytes, bytes);
    EXPECT_EQ(sha256OfFe(folder / "d3plot01"), sha256OfText(list));
    EXPECT_EQ(sha256OfText("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad") << "FIPS 180-4";
    for (const int threads : {1, 3}) {
        EXPECT_EQ(sha256OfSeries(fe->contents().files, Execution{}.withThreads(threads)), sha256OfText(list)) << threads;
    }
    // A file that stands alone, and one that is no FE result, are named by themselves.
    std::ofstream(folder / "notes") << "text";
    EXPECT_EQ(sha256OfFe(folder / "notes"), sha256OfFile(folder / "notes"));
    // A change in any member changes what is named.
    builder.deaths = {{0, 2}};
    builder.write(folder / "d3plot");
    EXPECT_NE(openFe(folder / "d3plot", {}, {}, Execution{})->contents().fingerprint, fe->contents().fingerprint);
}

TEST(FeReader, AListOfFilesIsNoCase) {
    const TemporaryFolder folder;
    std::ofstream(folder / "s.vtu.series") << "{\"file-series-version\": \"1.0\", \"files\": []}";
    std::ofstream(folder / "c.rubble") << " {\"format\": \"rubble-case\"}";
    EXPECT_FALSE(isCaseFile(folder / "s.vtu.series"));
    EXPECT_TRUE(isCaseFile(folder / "c.rubble"));
}

TEST(FeReader, WhatIsOutOfScopeIsSaid) {
    const TemporaryFolder folder;
    std::ofstream(folder / "collapse.out") << "0.25 Elem 17\n0.25 Node 3\n";
    EXPECT_THAT(openErrorOf(folder / "collapse.out"),
                AllOf(HasSubstr("OpenSees"), HasSubstr("recorder mpco"), HasSubstr("vtkhdf"), HasSubstr("pvd")));
    for (const char* deck :
         {"*Heading\n wall\n*NODE\n", "** wall\n*HEADING\n", "*KEYWORD\n", "#RADIOSS STARTER\n", "/VERS/2022\n"}) {
        std::ofstream(folder / "wall.inp") << deck;
        EXPECT_THAT(openErrorOf(folder / "wall.inp"), AllOf(HasSubstr("an input deck"), HasSubstr("read with it"))) << deck;
    }
    const std::string title(84, ' ');
    std::ofstream(folder / "RUNT01") << std::string(3, '\0') + "T" + title + std::string(3, '\0') + "T" + std::string(3, '\0') +
                                            "P  Fri Nov 20 02:32:25 2026 RADIOSS";
    EXPECT_THAT(openErrorOf(folder / "RUNT01"), AllOf(HasSubstr("a time history"), HasSubstr("RUNA001")));
    for (const char* listing : {" RUN_0001.out\n****\n**   OpenRadioss Engine   **\n", "SUMMARY OF JOB INFORMATION\n  STEP\n",
                                "\n stresses (elem, integ.pnt.,sxx) for set EALL and time  0.1E+01\n"}) {
        std::ofstream(folder / "wall.out") << listing;
        EXPECT_THAT(openErrorOf(folder / "wall.out"), AllOf(HasSubstr("a listing"), HasSubstr(".frd"))) << listing;
    }
    std::ofstream(folder / "wall.mac") << "! step 2\nekill,1\n";
    EXPECT_THAT(openErrorOf(folder / "wall.mac"), AllOf(HasSubstr("a macro of Ansys"), HasSubstr(".cdb")));
    std::ofstream(folder / "text") << "12.5 elephants\n";
    EXPECT_THAT(openErrorOf(folder / "text"), AllOf(HasSubstr("a text"), ::testing::Not(HasSubstr("a collapse log"))));
}

}  // namespace

}  // namespace rubble::io
