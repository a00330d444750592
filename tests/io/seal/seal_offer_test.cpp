#include "io/seal/seal_offer.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "core/base/error.h"
#include "io/base/files.h"
#include "io/case/case_file.h"
#include "io/run/run_file.h"
#include "io/seal/bundle_verdict.h"
#include "io/seal/run_repeat.h"
#include "tests/io/seal/sealed_small_case.h"
#include "tests/support/error_id.h"

namespace rubble::io {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using Kind = OfferedPart::Kind;

/// The small case alone in a folder, with its run.
class SealOffer : public testing::Test {
protected:
    void SetUp() override {
        for (const char* name : {"small.rubble", "small.exo", "north.jpg", "south.jpg", "small.run.h5"}) {
            fs::copy_file(SealedSmallCase::the().path(name), m_folder / name);
        }
    }
    std::vector<OfferedPart> offer() { return sealOffer(m_case, Execution()); }
    /// Names of all parts of a kind, "-" before those that are not chosen.
    static std::vector<std::string> names(const std::vector<OfferedPart>& parts, Kind kind) {
        std::vector<std::string> found;
        for (const OfferedPart& part : parts) {
            if (part.kind == kind && part.run.empty()) {
                found.push_back((part.chosen ? "" : "-") + fs::path(part.path).filename().string());
            }
        }
        return found;
    }
    /// Kinds that can be made, with the name of the run.
    static std::vector<std::string> missing(const std::vector<OfferedPart>& parts) {
        std::vector<std::string> found;
        for (const OfferedPart& part : parts) {
            if (!part.run.empty()) {
                EXPECT_FALSE(part.chosen);
                found.push_back((part.kind == Kind::Report ? "report of " : "page of ") + fs::path(part.run).filename().string());
            }
        }
        return found;
    }
    /// A page that says that it was made of a run with a fingerprint.
    std::string page(const std::string& fingerprint) {
        return "<html><!--{\"rubble_provenance\":1,\"simulated\":true,\"fingerprint\":\"" + fingerprint + "\",\"case_path\":\"" +
               m_case + "\",\"inputs\":[{\"role\":\"fe\",\"path\":\"small.exo\",\"sha256\":\"00\"}]}-->";
    }
    std::string provenance() {
        return "{\"fingerprint\": \"" + openRun(m_folder / "small.run.h5")->origin().fingerprint.hex() + "\"}";
    }

    TemporaryFolder m_folder;
    std::string m_case = m_folder / "small.rubble";
};

TEST_F(SealOffer, ListsWhatTheCaseHasAndWhatWasMadeOfIt) {
    writeIn(m_folder / "table.csv", "fragment_id\n");
    writeIn(m_folder / "table.csv.provenance.json", provenance());
    writeIn(m_folder / "other.csv", "fragment_id\n");
    writeIn(m_folder / "other.csv.provenance.json", "{\"fingerprint\": \"00\"}");
    writeIn(m_folder / "broken.csv", "fragment_id\n");
    writeIn(m_folder / "broken.csv.provenance.json", "[7");
    const std::string page = "<html><!--{\"rubble_provenance\":1,\"case_path\":\"" + m_case +
                             "\",\"inputs\":[{\"role\":\"fe\",\"path\":\"small.exo\",\"sha256\":\"00\"}]}-->";
    writeIn(m_folder / "report/report.html", page);
    writeIn(m_folder / "page.html", page);
    const std::vector<OfferedPart> parts = offer();
    EXPECT_THAT(names(parts, Kind::Input), ElementsAre("small.exo", "north.jpg", "south.jpg"));
    EXPECT_THAT(names(parts, Kind::Run), ElementsAre("small.run.h5"));
    EXPECT_THAT(names(parts, Kind::Export), ElementsAre("table.csv"));
    EXPECT_THAT(names(parts, Kind::Report), ElementsAre("report"));
    EXPECT_THAT(names(parts, Kind::Page), ElementsAre("page.html"));
    EXPECT_EQ(parts[1].bytes, fs::file_size(m_folder / "north.jpg"));
}

TEST_F(SealOffer, OfTwoRunsOfAScenarioTheNewestIsChosenAndWhatIsGoneIsSaid) {
    fs::copy_file(m_folder / "small.run.h5", m_folder / "before.run.h5");
    fs::last_write_time(m_folder / "before.run.h5", fs::file_time_type::clock::now() - std::chrono::hours(1));
    fs::remove(m_folder / "north.jpg");
    const std::vector<OfferedPart> parts = offer();
    EXPECT_THAT(names(parts, Kind::Run), ElementsAre("small.run.h5", "-before.run.h5"));
    EXPECT_THAT(names(parts, Kind::Input), ElementsAre("small.exo", "-north.jpg", "south.jpg"));
    EXPECT_EQ(parts[1].remark.id, "io.seal.offer_missing");
}

TEST_F(SealOffer, WhatARunLacksCanBeMade) {
    EXPECT_THAT(missing(offer()), ElementsAre("report of small.run.h5", "page of small.run.h5"));
    writeIn(m_folder / "page.html", page("00"));
    const std::vector<OfferedPart> other = offer();
    EXPECT_THAT(missing(other), ElementsAre("report of small.run.h5", "page of small.run.h5"));
    EXPECT_EQ(other.back().remark.id, "io.seal.offer_of_others");
    writeIn(m_folder / "page.html", page(openRun(m_folder / "small.run.h5")->origin().fingerprint.hex()));
    EXPECT_THAT(missing(offer()), ElementsAre("report of small.run.h5"));
    fs::copy_file(m_folder / "page.html", m_folder / "earlier.rubblecase");
    EXPECT_THAT(names(offer(), Kind::Export), ElementsAre()) << "a bundle is not sealed into another";
    const OfferedPart run = addedPart(m_folder / "small.run.h5");
    EXPECT_THAT(missing(missingOf(run, {addedPart(m_folder / "page.html")})), ElementsAre("report of small.run.h5"));
    const SealedExtra made = placeOfMade(Kind::Report, m_folder / "small.run.h5", 2, "/made");
    EXPECT_EQ(made.folder, "report/2-small");
    EXPECT_EQ(made.path, "/made/2-small");
}

// Files of two reports have the same names, and each refers to its own.
TEST_F(SealOffer, TwoReportsHaveAFolderEach) {
    std::vector<OfferedPart> parts;
    for (const char* name : {"first", "second"}) {
        writeIn(m_folder / (std::string("elsewhere/") + name + "/report.html"), name);
        parts.push_back(addedPart(m_folder / (std::string("elsewhere/") + name)));
    }
    SealRequest request = SealedSmallCase::the().request();
    choose(request, parts);
    sealCase(m_folder / "small.rubblecase", request, Execution());
    PackedFiles files = packedFiles(m_folder / "small.rubblecase");
    EXPECT_EQ(contentAt(files, "data/report/1-first/report.html"), "first");
    EXPECT_EQ(contentAt(files, "data/report/2-second/report.html"), "second");
}

TEST_F(SealOffer, ARunStandsOnTheFilesOfItsCase) {
    const std::shared_ptr<RunReader> run = openRun(m_folder / "small.run.h5");
    EXPECT_EQ(originInCase(*run, m_case, loadCase(m_case), Execution()).fePath, m_folder / "small.exo");
    fs::remove(m_folder / "small.exo");
    EXPECT_EQ(idOfError([&] { originInCase(*run, m_case, loadCase(m_case), Execution()); }), "io.run.not_of_case");
}

TEST_F(SealOffer, WhatIsChosenComesIntoTheRequest) {
    std::vector<OfferedPart> parts = offer();
    parts[2].chosen = false;
    writeIn(m_folder / "elsewhere/report/report.html", "<html>");
    parts.push_back(addedPart(m_folder / "elsewhere/report"));
    SealRequest request = SealedSmallCase::the().request();
    request.casePath = m_case;
    request.runs.clear();
    choose(request, parts);
    EXPECT_THAT(request.leftHome, ElementsAre("south"));
    EXPECT_EQ(request.runs.size(), 1u);
    ASSERT_EQ(request.extras.size(), 1u);
    EXPECT_EQ(request.extras[0].folder, "report");
    sealCase(m_folder / "small.rubblecase", request, Execution());
    const SealCheck check = checkBundle(m_folder / "small.rubblecase", {}, Execution());
    EXPECT_TRUE(check.sound());
    EXPECT_TRUE(check.statement.inputs[2].files.empty());
    fs::remove_all(m_folder / "elsewhere");
    EXPECT_EQ(idOfError([&] { sealCase(m_folder / "small.rubblecase", request, Execution()); }), "io.seal.extra_missing");
}

TEST(BundleVerdict, EveryPartHasAVerdictAndWhatItIsAbout) {
    const auto proofs = [](const SealCheck& check) {
        std::vector<std::string> list;
        for (const CheckedPart& part : checkedParts(check)) {
            list.push_back(englishText(proofText(part.proof)));
        }
        return list;
    };
    const SealedSmallCase& sealed = SealedSmallCase::the();
    const SealCheck sound = checkBundle(sealed.bundle(), {}, Execution());
    EXPECT_THAT(proofs(sound), ElementsAre("holds", "holds", "not proven", "not proven", "holds", "holds", "not there"));
    const TemporaryFolder folder;
    PackedFiles files = packedFiles(sealed.bundle());
    contentAt(files, "data/inputs/north/north.jpg") = "another view";
    packFiles(folder / "altered.rubblecase", files);
    const SealCheck altered = checkBundle(folder / "altered.rubblecase", {}, Execution());
    EXPECT_EQ(proofs(altered)[1], "does not hold");
    std::size_t said = 0;
    for (const CheckedPart& part : checkedParts(altered)) {
        said += part.said.size();
    }
    EXPECT_EQ(said, altered.faults.size() + altered.doubts.size()) << "each is told once";
    EXPECT_EQ(englishText(bundleVerdict(altered, {}, false)), "not as it was sealed");
}

}  // namespace
}  // namespace rubble::io
