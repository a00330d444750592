#include "io/seal/seal_offer.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "core/base/error.h"
#include "io/base/files.h"
#include "io/case/case_file.h"
#include "io/run/run_file.h"
#include "io/seal/bundle_verdict.h"
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
            if (part.kind == kind) {
                found.push_back((part.chosen ? "" : "-") + fs::path(part.path).filename().string());
            }
        }
        return found;
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
