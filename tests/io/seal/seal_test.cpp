#include "io/seal/seal_case.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <functional>
#include <nlohmann/json.hpp>
#include <sstream>

#include "core/base/build.h"
#include "core/base/error.h"
#include "core/evidence/cautions.h"
#include "core/simulation/run/acknowledgement.h"
#include "io/base/files.h"
#include "io/case/case_file.h"
#include "io/case/journal_check.h"
#include "io/seal/bag.h"
#include "io/seal/seal_addition.h"
#include "io/seal/seal_check.h"
#include "io/seal/seal_readme.h"
#include "io/seal/time_stamp.h"
#include "io/seal/unpacked_bundle.h"
#include "tests/io/seal/sealed_small_case.h"
#include "tests/support/command_run.h"
#include "tests/support/time_stamp_service.h"

namespace rubble::io {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using testing::Contains;
using testing::ElementsAre;
using testing::IsEmpty;

std::vector<std::string> idsOf(const std::vector<SealFault>& faults) {
    std::vector<std::string> ids;
    for (const SealFault& fault : faults) {
        ids.push_back(fault.what.id);
    }
    return ids;
}

/// The id of the message that an action ends with; empty: it does not fail. Every message comes with a remedy.
std::string failureOf(const std::function<void()>& act) {
    try {
        act();
    } catch (const Error& error) {
        EXPECT_FALSE(error.remedy().empty());
        return error.message().id;
    }
    return {};
}

class Seal : public testing::Test {
protected:
    SealCheck check(const std::string& path, const SealTrust& trust = {}) { return checkBundle(path, trust, Execution()); }
    std::string copyOfBundle() {
        fs::copy_file(m_sealed.bundle(), m_bundle, fs::copy_options::overwrite_existing);
        return m_bundle;
    }
    /// Runs a line of the shell; what it says if it fails.
    std::string shell(const std::string& line, const std::string& folder) {
        const cli::Outcome outcome = cli::CommandRun().in(folder).run({"sh", "-c", line});
        return outcome.exitCode == 0 ? "" : line + ": " + outcome.out + outcome.err;
    }
    std::string answerOf(const std::string& request) { return m_service.answerTo(request); }

    const SealedSmallCase& m_sealed = SealedSmallCase::the();
    TemporaryFolder m_folder;
    TimeStampService m_service{m_folder.path()};
    std::string m_bundle = m_folder / "copy.rubblecase";
};

TEST_F(Seal, HoldsCaseInputsRunsAndStatement) {
    const SealCheck found = check(m_sealed.bundle());
    EXPECT_THAT(found.faults, IsEmpty());
    EXPECT_THAT(idsOf(found.doubts), ElementsAre("io.seal.no_stamp", "io.seal.key_alone"));
    const SealStatement& statement = found.statement;
    EXPECT_EQ(statement.title, "Two blocks");
    EXPECT_EQ(statement.sealedBy, "A. Engineer");
    EXPECT_EQ(statement.journalHead, checkJournal(m_sealed.casePath()).head);
    EXPECT_EQ(statement.journalEntries, 3);
    ASSERT_EQ(statement.inputs.size(), 3u);
    EXPECT_EQ(statement.inputs[1].files, std::vector<std::string>{"data/inputs/north/north.jpg"});
    ASSERT_EQ(statement.runs.size(), 1u);
    EXPECT_EQ(statement.runs[0].sha256, sha256OfFile(m_sealed.runPath()));
    // What must be known of the run goes with it, and who opens the bundle reads it.
    const auto known = [](const std::vector<Message>& list) {
        return std::any_of(list.begin(), list.end(), [](const Message& what) { return what.id == singleRunCaution().what.id; });
    };
    EXPECT_TRUE(known(statement.runs[0].cautions));
    EXPECT_EQ(found.sealSha256, m_sealed.report().sealSha256);
    EXPECT_TRUE(found.signature.matches);
    // The case travels byte for byte, so that its journal does.
    PackedFiles files = packedFiles(m_sealed.bundle());
    EXPECT_EQ(contentAt(files, "data/case/small.rubble"), contentOf(m_sealed.casePath()));
}

TEST_F(Seal, IsCheckedWithoutTheProgramAsItsReadmeSays) {
    const std::string key = makeKey(m_folder / "key.pem");
    SealRequest request = m_sealed.request();
    request.signer = {key, makeCertificate(key, m_folder / "roots.pem", "A. Engineer", -60, 3600), {}};
    request.service = [this](const std::string& asked) { return answerOf(asked); };
    sealCase(m_bundle, request, Execution());
    const SealCheck found = check(m_bundle, {{m_folder / "roots.pem", {}}, m_folder / "tsa.pem", {}});
    EXPECT_THAT(idsOf(found.faults), IsEmpty());
    EXPECT_THAT(idsOf(found.doubts), IsEmpty());
    const UnpackedBundle unpacked(m_bundle, found, m_folder / "opened", Execution());
    std::istringstream readme(contentOf(unpacked.pathOf(bag::readme)).value());
    int commands = 0;
    for (std::string line; std::getline(readme, line);) {
        if (!line.starts_with("   ") || line.ends_with("record.json")) {
            continue;
        }
        line = line.substr(0, line.find("       ("));
        const auto put = [&](const std::string& word, const std::string& path) {
            if (const std::size_t at = line.find(word); at != std::string::npos) {
                line.replace(at, word.size(), path);
            }
        };
        put("ROOTS-OF-THE-SERVICE.pem", m_folder / "tsa.pem");
        put("ROOTS.pem", m_folder / "roots.pem");
        EXPECT_EQ(shell(line, unpacked.folder()), "");
        ++commands;
    }
    EXPECT_GE(commands, 20);
    // What these commands say is what the statement says.
    EXPECT_EQ(shell("test $(find data -type f | wc -l) = $(wc -l < manifest-sha256.txt)", unpacked.folder()), "");
    EXPECT_EQ(shell("sha256sum manifest-sha256.txt | cut -c1-64 | xargs -I@ grep -q @ seal/seal.json", unpacked.folder()), "");
    EXPECT_EQ(shell("grep '\"digest\"' data/case/*.rubble | tail -n 1 | grep -q " + found.statement.journalHead, unpacked.folder()),
              "");
    EXPECT_EQ(shell("openssl pkey -pubin -in seal/public-key.pem -outform DER | sha256sum | grep -q " + found.statement.signer,
                    unpacked.folder()),
              "");
}

TEST_F(Seal, OpensReadOnlyAndItsRunsRepeat) {
    const SealCheck found = check(m_sealed.bundle());
    const UnpackedBundle unpacked(m_sealed.bundle(), found, m_folder / "opened", Execution());
    const RunRepeat repeat = unpacked.repeat(unpacked.runs().at(0), Execution());
    EXPECT_TRUE(repeat.equal);
    EXPECT_TRUE(repeat.firstDifference.empty());
    const fs::perms rights = fs::status(unpacked.pathOf("data/inputs/north/north.jpg")).permissions();
    EXPECT_EQ(rights & (fs::perms::owner_write | fs::perms::group_write | fs::perms::others_write), fs::perms::none);
    unpacked.writeWorkingCase(m_folder / "opened/small.rubble");
    const Case working = loadCase(m_folder / "opened/small.rubble");
    EXPECT_TRUE(fs::exists(inputPath(m_folder / "opened/small.rubble", working.inputs[2])));
    // Whoever goes on working does so in the same journal.
    EXPECT_EQ(working.journal.entries[2].digest, found.statement.journalHead);
    EXPECT_EQ(working.journal.entries.size(), 4u);
    EXPECT_EQ(failureOf([&] { UnpackedBundle(m_sealed.bundle(), found, m_folder / "opened", Execution()); }),
              "io.seal.folder_full");
}

TEST_F(Seal, ARunOfAnotherBuildIsNamedWhenItIsSealedAndWhenItIsOpened) {
    runSmallCase(m_sealed.casePath(), m_folder / "other.run.h5", "Rubble 9.9.9 another compiler");
    SealRequest request = m_sealed.request();
    request.runs = {m_folder / "other.run.h5"};
    const SealReport report = sealCase(m_bundle, request, Execution());
    EXPECT_EQ(report.findings.count("io.seal.run_build"), 1);
    EXPECT_THAT(idsOf(check(m_bundle).doubts), Contains("io.seal.other_build"));
}

TEST_F(Seal, AnInputThatDoesNotTravelIsNamedByItsDigest) {
    SealRequest request = m_sealed.request();
    request.leftHome = {"fe-1"};
    const SealReport report = sealCase(m_bundle, request, Execution());
    EXPECT_EQ(report.findings.count("io.seal.input_home"), 1);
    const SealCheck found = check(m_bundle);
    EXPECT_THAT(found.statement.inputs[0].files, IsEmpty());
    UnpackedBundle unpacked(m_bundle, found, m_folder / "opened", Execution());
    const SealedRun run = unpacked.runs().at(0);
    EXPECT_EQ(failureOf([&] { unpacked.repeat(run, Execution()); }), "io.seal.not_here");
    EXPECT_EQ(failureOf([&] { unpacked.locate("fe-1", m_sealed.path("north.jpg"), Execution()); }), "io.seal.located_differs");
    EXPECT_EQ(failureOf([&] { unpacked.locate("fe-2", m_sealed.path("small.exo"), Execution()); }), "io.seal.no_sealed_input");
    unpacked.locate("fe-1", m_sealed.path("small.exo"), Execution());
    EXPECT_TRUE(unpacked.repeat(run, Execution()).equal);
    request.leftHome = {"fe-9"};
    EXPECT_EQ(failureOf([&] { sealCase(m_bundle, request, Execution()); }), "io.seal.no_input");
}

TEST_F(Seal, ATimeStampIsOfThisBundleAndNoOther) {
    SealRequest request = m_sealed.request();
    request.stampRequest = true;
    const SealReport report = sealCase(m_bundle, request, Execution());
    EXPECT_THAT(idsOf(check(m_bundle).doubts), Contains("io.seal.stamp_missing"));
    EXPECT_EQ(timeStampRequestOf(m_bundle), report.stampRequest);
    const std::string another = answerOf(timeStampRequest("another file"));
    EXPECT_EQ(failureOf([&] { addTimeStamp(m_bundle, m_bundle, another, Execution()); }), "io.seal.stamp_of_another");
    const std::string right = answerOf(report.stampRequest);
    EXPECT_EQ(failureOf([&] { addTimeStamp(m_bundle, m_bundle, right.substr(0, 200), Execution()); }), "io.seal.stamp_damaged");
    addTimeStamp(m_bundle, m_bundle, right, Execution());
    const SealCheck stamped = check(m_bundle, {{}, m_folder / "tsa.pem", {}});
    EXPECT_THAT(idsOf(stamped.faults), IsEmpty());
    ASSERT_TRUE(stamped.stamp);
    EXPECT_NEAR(std::difftime(stamped.stamp->time, std::time(nullptr)), 0.0, 60.0);
    EXPECT_THAT(stamped.stamp->service, testing::HasSubstr("Service of the test"));
    EXPECT_THAT(idsOf(check(m_bundle).doubts), Contains("io.seal.stamp_no_roots"));
    const std::string stranger = makeCertificate(m_sealed.key(), m_folder / "stranger.pem", "Stranger", -60, 3600);
    EXPECT_THAT(idsOf(check(m_bundle, {{}, stranger, {}}).faults), Contains("io.seal.stamp_not_vouched"));
    PackedFiles asked = packedFiles(m_bundle);
    contentAt(asked, bag::stampRequest) = timeStampRequest("another file");
    listAnew(asked);
    packFiles(m_folder / "asked.rubblecase", asked);
    EXPECT_THAT(idsOf(check(m_folder / "asked.rubblecase").faults), Contains("io.seal.request_of_another"));
    std::erase_if(asked, [](const auto& file) { return file.first.ends_with(bag::stampRequest); });
    listAnew(asked);
    packFiles(m_folder / "asked.rubblecase", asked);
    EXPECT_THAT(idsOf(check(m_folder / "asked.rubblecase").faults), ElementsAre("io.seal.request_missing"));
    // A stamp that came in between two entries of custody leaves both their digests true.
    const SealAddition entry{"B. Clerk", std::nullopt, CustodyEntry{"A. Engineer", "B. Clerk", {}, {}, {}}, {}, {}, {}};
    sealCase(m_folder / "between.rubblecase", request, Execution());
    const std::string between = m_folder / "between.rubblecase";
    addRecord(between, between, entry, Execution());
    addTimeStamp(between, between, answerOf(timeStampRequestOf(between)), Execution());
    addRecord(between, between, entry, Execution());
    EXPECT_THAT(idsOf(check(between).faults), IsEmpty());
    EXPECT_THAT(idsOf(check(between).doubts), testing::Not(Contains("io.seal.custody_stamped")));
    // Another's time stamp in its place, and a signature that was made anew under it.
    PackedFiles files = packedFiles(m_bundle);
    contentAt(files, bag::stampAnswer) = another;
    listAnew(files);
    packFiles(m_bundle, files);
    EXPECT_THAT(idsOf(check(m_bundle).faults), Contains("io.seal.stamp_of_another"));
}

// A signer who states another time than that of the service: it is named, with the days between.
TEST_F(Seal, AStatementThatIsDatedBackDiffersFromItsTimeStamp) {
    SealRequest request = m_sealed.request();
    request.stampRequest = true;
    sealCase(m_bundle, request, Execution());
    const auto dated = [&](const std::string& when) {
        PackedFiles files = packedFiles(m_bundle);
        json statement = json::parse(contentAt(files, bag::statement));
        statement["sealed_at"] = when;
        contentAt(files, bag::statement) = statement.dump(1) + "\n";
        contentAt(files, bag::signature) = Signer({m_sealed.key(), {}, {}}).sign(contentAt(files, bag::statement));
        contentAt(files, bag::stampRequest) = timeStampRequest(contentAt(files, bag::signature));
        files.emplace_back(files[0].first.substr(0, files[0].first.find('/') + 1) + bag::stampAnswer,
                           answerOf(contentAt(files, bag::stampRequest)));
        listAnew(files);
        packFiles(m_folder / "dated.rubblecase", files);
        return check(m_folder / "dated.rubblecase");
    };
    EXPECT_THAT(idsOf(dated("2020-01-01T00:00:00Z").doubts), Contains("io.seal.before_stamp"));
    const SealCheck future = dated("2199-01-01T00:00:00Z");
    EXPECT_THAT(idsOf(future.faults), Contains("io.seal.after_stamp"));
    EXPECT_THAT(idsOf(future.doubts), Contains("io.seal.future"));
}

TEST_F(Seal, CustodyIsAChain) {
    copyOfBundle();
    const std::string received = sha256OfFile(m_bundle);
    SealAddition first{"B. Clerk", std::nullopt, CustodyEntry{"A. Engineer", "B. Clerk", "court, by disk", "file 7", {}},
                       {},         {},           {}};
    SealAddition second{"C. Expert",
                        SignerFiles{makeKey(m_folder / "c.pem"), {}, {}},
                        CustodyEntry{"B. Clerk", "C. Expert", "", "opinion", {}},
                        {},
                        {},
                        {}};
    const AddedRecord one = addRecord(m_bundle, m_bundle, first, Execution());
    const AddedRecord two = addRecord(m_bundle, m_bundle, second, Execution());
    EXPECT_EQ(one.record.custody.bundleSha256, received);
    EXPECT_EQ(two.record.before, one.sha256);
    const SealCheck found = check(m_bundle, {{}, {}, two.sha256});
    EXPECT_THAT(idsOf(found.faults), IsEmpty());
    EXPECT_THAT(idsOf(found.doubts), Contains("io.seal.record_unsigned"));
    ASSERT_EQ(found.records.size(), 2u);
    EXPECT_EQ(found.records[1].record.custody.to, "C. Expert");
    // The middle one left out, the last one left out, a name altered.
    const auto without = [&](const std::string& folder) {
        PackedFiles files = packedFiles(m_bundle);
        std::erase_if(files, [&](const auto& file) { return file.first.find(folder) != std::string::npos; });
        listAnew(files);
        packFiles(m_folder / "less.rubblecase", files);
        return idsOf(check(m_folder / "less.rubblecase", {{}, {}, two.sha256}).faults);
    };
    EXPECT_THAT(without("records/0001-custody"), testing::IsSupersetOf({"io.seal.record_number", "io.seal.record_chain"}));
    EXPECT_THAT(without("records/0002-custody"), testing::ElementsAre("io.seal.known_missing"));
    PackedFiles files = packedFiles(m_bundle);
    std::string& text = contentAt(files, "records/0001-custody/record.json");
    text.replace(text.find("B. Clerk"), 8, "D. Clerk");
    listAnew(files);
    packFiles(m_bundle, files);
    EXPECT_THAT(idsOf(check(m_bundle).faults), testing::ElementsAre("io.seal.record_chain"));
    EXPECT_EQ(failureOf([&] { addRecord(m_bundle, m_bundle, first, Execution()); }), "io.seal.unsound");
}

// An entry that nobody signed is written by anybody: what can be known of it is held against the bundle.
TEST_F(Seal, CustodyIsHeldAgainstWhatWasReceived) {
    copyOfBundle();
    SealAddition entry{"B. Clerk", std::nullopt, CustodyEntry{"A. Engineer", "B. Clerk", {}, {}, {}}, {}, {}, {}};
    for (int i = 0; i < 3; ++i) {
        addRecord(m_bundle, m_bundle, entry, Execution());
    }
    EXPECT_THAT(idsOf(check(m_bundle).faults), IsEmpty());
    const auto altered = [&](const std::string& from, const std::string& to) {
        PackedFiles files = packedFiles(m_bundle);
        std::string& text = contentAt(files, "records/0003-custody/record.json");
        text.replace(text.find(from), from.size(), to);
        listAnew(files);
        packFiles(m_folder / "altered.rubblecase", files);
        return check(m_folder / "altered.rubblecase");
    };
    const SealRecord record = check(m_bundle).records.at(2).record;
    EXPECT_THAT(idsOf(altered(record.custody.bundleSha256, std::string(64, '0')).faults), ElementsAre("io.seal.custody_digest"));
    EXPECT_THAT(idsOf(altered("\"A. Engineer\"", "\" \"").faults), ElementsAre("io.seal.nobody"));
    const SealCheck later = altered(record.when, "2199" + record.when.substr(4));
    EXPECT_THAT(idsOf(later.faults), IsEmpty());
    EXPECT_THAT(idsOf(later.doubts), Contains("io.seal.record_future"));
    entry.custody->from = " ";
    EXPECT_EQ(failureOf([&] { addRecord(m_bundle, m_bundle, entry, Execution()); }), "io.seal.no_name");
}

TEST_F(Seal, AnAddendumListsWhatAnotherAssumes) {
    copyOfBundle();
    const SealCheck found = check(m_bundle);
    const UnpackedBundle unpacked(m_bundle, found, m_folder / "opened", Execution());
    const std::string theirs = m_folder / "opened/small.rubble";
    unpacked.writeWorkingCase(theirs);
    SealAddition addition{"C. Expert", SignerFiles{makeKey(m_folder / "c.pem"), {}, {}}, std::nullopt, theirs, {}, "wet stone"};
    EXPECT_EQ(failureOf([&] { addRecord(m_bundle, m_bundle, addition, Execution()); }), "io.seal.nothing_changed");
    Case changed = loadCase(theirs);
    changed.scenarios[0].scenario.simulation.friction = 0.3;
    saveCase(theirs, changed);
    runSmallCase(theirs, m_folder / "theirs.run.h5");
    addition.runs = {m_folder / "theirs.run.h5"};
    SealAddition unsignedOne = addition;
    unsignedOne.signer.reset();
    EXPECT_EQ(failureOf([&] { addRecord(m_bundle, m_bundle, unsignedOne, Execution()); }), "io.seal.addendum_unsigned");
    addRecord(m_bundle, m_bundle, addition, Execution());
    const SealCheck after = check(m_bundle);
    EXPECT_THAT(idsOf(after.faults), IsEmpty());
    EXPECT_EQ(after.sealSha256, found.sealSha256);
    ASSERT_EQ(after.records.size(), 1u);
    const SealAddendum& addendum = after.records[0].record.addendum;
    ASSERT_EQ(addendum.differences.size(), 1u);
    EXPECT_EQ(addendum.differences[0], (JournalChange{"scenarios/scenario-1/settings/friction", "0.5", "0.3"}));
    const UnpackedBundle both(m_bundle, after, m_folder / "both", Execution());
    ASSERT_EQ(both.runs().size(), 2u);
    EXPECT_TRUE(both.repeat(both.runs()[1], Execution()).equal);
    PackedFiles files = packedFiles(m_bundle);
    // The list of differences is not believed.
    json record = json::parse(contentAt(files, "records/0001-addendum/record.json"));
    record["addendum"]["differences"] = json::array();
    const std::string silent = record.dump(1) + "\n";
    contentAt(files, "records/0001-addendum/record.json") = silent;
    contentAt(files, "records/0001-addendum/record.sig") = Signer(*addition.signer).sign(silent);
    listAnew(files);
    packFiles(m_folder / "silent.rubblecase", files);
    EXPECT_THAT(idsOf(check(m_folder / "silent.rubblecase").faults), ElementsAre("io.seal.differences"));
    files = packedFiles(m_bundle);
    contentAt(files, addendum.casePlace)[40] ^= 1;
    listAnew(files);
    packFiles(m_bundle, files);
    EXPECT_THAT(idsOf(check(m_bundle).faults), Contains("io.seal.record_file"));
}

TEST_F(Seal, ARunUnderOtherSettingsThanItsCaseIsSaidWithThem) {
    const std::string theirs = m_folder / "small.rubble";
    for (const char* name : {"small.rubble", "small.exo", "north.jpg", "south.jpg"}) {
        fs::copy_file(m_sealed.path(name), m_folder / name);
    }
    Case wet = loadCase(theirs);
    wet.scenarios[0].scenario.simulation.friction = 0.3;
    saveCase(theirs, wet);
    runSmallCase(theirs, m_folder / "wet.run.h5");
    SealRequest request = m_sealed.request();
    request.runs = {m_folder / "wet.run.h5"};
    const SealReport report = sealCase(m_bundle, request, Execution());
    ASSERT_EQ(report.statement.runs.size(), 1u);
    EXPECT_THAT(report.statement.runs[0].otherSettings, ElementsAre(OtherSetting{"friction", "0.3", "0.5"}));
    EXPECT_EQ(report.findings.count("io.seal.run_settings"), 1);
    const SealCheck found = check(m_bundle);
    EXPECT_THAT(idsOf(found.faults), IsEmpty());
    EXPECT_THAT(idsOf(found.doubts), Contains("io.seal.other_setting"));
    EXPECT_THAT(idsOf(check(m_sealed.bundle()).doubts), testing::Not(Contains("io.seal.other_setting")));
}

TEST_F(Seal, WhatARunOfAnotherBuildDoesNotHoldIsNotMadeUp) {
    const std::string theirs = m_folder / "small.rubble";
    for (const char* name : {"small.rubble", "small.exo", "north.jpg", "south.jpg"}) {
        fs::copy_file(m_sealed.path(name), m_folder / name);
    }
    runSmallCase(theirs, m_folder / "earlier.run.h5", "Rubble 0.1.0, sources 12345678, g++");
    runSmallCase(theirs, m_folder / "now.run.h5");
    Case later = loadCase(theirs);
    later.scenarios[0].scenario.simulation.overlapTime = 4.0;
    saveCase(theirs, later);
    SealRequest request = m_sealed.request();
    request.casePath = theirs;
    request.runs = {m_folder / "earlier.run.h5", m_folder / "now.run.h5"};
    const SealReport report = sealCase(m_bundle, request, Execution());
    ASSERT_EQ(report.statement.runs.size(), 2u);
    EXPECT_THAT(report.statement.runs[0].otherSettings, ElementsAre(OtherSetting{"overlap_time", "not recorded", "4"}));
    EXPECT_THAT(report.statement.runs[1].otherSettings, ElementsAre(OtherSetting{"overlap_time", "auto", "4"}));
}

TEST_F(Seal, SaysWhichProgramMadeItAndHowToGetIt) {
    PackedFiles files = packedFiles(m_sealed.bundle());
    const std::string text = contentAt(files, "data/build/build.txt");
    const std::string build(buildText());
    const std::size_t sources = build.find("sources ") + 8;
    for (const std::string& part :
         {"version   " + std::string(versionText()) + "\n", "build     " + build + "\n",
          "sources   " + build.substr(sources, build.find(',', sources) - sources) + "   (",
          "commit    " + (commitText().empty() ? "not named by this build" : std::string(commitText())) + "\n",
          std::string("./run deb"), std::string("cmake --preset release && cmake --build --preset release")}) {
        EXPECT_THAT(text, testing::HasSubstr(part));
    }
    EXPECT_THAT(text, testing::Not(testing::HasSubstr("{{")));
}

TEST_F(Seal, KeysThatCannotBeUsedAreRefusedWithARemedy) {
    const auto sealing = [&](const SignerFiles& signer) {
        SealRequest request = m_sealed.request();
        request.signer = signer;
        return failureOf([&] { sealCase(m_bundle, request, Execution()); });
    };
    const std::string key = makeKey(m_folder / "key.pem");
    EXPECT_EQ(sealing({m_folder / "none.pem", {}, {}}), "io.seal.key_unreadable");
    EXPECT_EQ(sealing({m_sealed.path("north.jpg"), {}, {}}), "io.seal.no_key");
    EXPECT_EQ(sealing({key, makeCertificate(key, m_folder / "old.pem", "A", -7200, -3600), {}}), "io.seal.certificate_expired");
    EXPECT_EQ(sealing({key, makeCertificate(key, m_folder / "early.pem", "A", 3600, 7200), {}}), "io.seal.certificate_early");
    EXPECT_EQ(sealing({key, makeCertificate(m_sealed.key(), m_folder / "other.pem", "A", -60, 3600), {}}), "io.seal.other_key");
    ASSERT_EQ(shell("openssl genpkey -algorithm ed25519 -aes256 -pass pass:right -out locked.pem && "
                    "openssl genrsa -out weak.pem 1024",
                    m_folder.path()),
              "");
    EXPECT_EQ(sealing({m_folder / "weak.pem", {}, {}}), "io.seal.weak_key");
    EXPECT_EQ(sealing({m_folder / "locked.pem", {}, {}}), "io.seal.passphrase");
    EXPECT_EQ(sealing({m_folder / "locked.pem", {}, "wrong"}), "io.seal.passphrase");
    EXPECT_FALSE(fs::exists(m_bundle));
    EXPECT_EQ(sealing({m_folder / "locked.pem", {}, "right"}), "");
}

// What was signed while the certificate was valid stays signed after its end.
TEST_F(Seal, ACertificateCountsAtTheTimeOfSealing) {
    const std::string key = makeKey(m_folder / "key.pem");
    SealRequest request = m_sealed.request();
    request.signer = {key, makeCertificate(key, m_folder / "cert.pem", "A. Engineer", -3600, 2), {}};
    sealCase(m_bundle, request, Execution());
    const SealTrust trusted{{m_folder / "cert.pem", {}}, {}, {}};
    EXPECT_THAT(idsOf(check(m_bundle, trusted).faults), IsEmpty());
    const std::string stranger = makeCertificate(makeKey(m_folder / "x.pem"), m_folder / "stranger.pem", "Stranger", -60, 3600);
    EXPECT_THAT(idsOf(check(m_bundle, {{stranger, {}}, {}, {}}).faults), Contains("io.seal.not_vouched"));
    EXPECT_THAT(idsOf(check(m_bundle, {{{}, stranger}, {}, {}}).faults), Contains("io.seal.other_signer"));
    EXPECT_EQ(failureOf([&] { check(m_bundle, {{m_folder / "none.pem", {}}, {}, {}}); }), "io.seal.key_unreadable");
}

TEST_F(Seal, AClockThatRunsBackwardsIsNamed) {
    Case theCase = loadCase(m_sealed.casePath());
    json document = json::parse(caseText(theCase));
    document["journal"][2]["when"] = "2198-01-01T00:00:00Z";
    writeIn(m_folder / "small.rubble", document.dump(1));
    for (const char* name : {"small.exo", "north.jpg", "south.jpg"}) {
        fs::copy_file(m_sealed.path(name), m_folder / name);
    }
    EXPECT_THAT(checkJournal(m_folder / "small.rubble").backward, IsEmpty());
    SealRequest request = m_sealed.request();
    request.casePath = m_folder / "small.rubble";
    EXPECT_EQ(failureOf([&] { sealCase(m_bundle, request, Execution()); }), "io.seal.clock");
    document["journal"][2]["when"] = "1998-01-01T00:00:00Z";
    writeIn(m_folder / "small.rubble", document.dump(1));
    EXPECT_THAT(checkJournal(m_folder / "small.rubble").backward, testing::ElementsAre(3u));
    const SealReport report = sealCase(m_bundle, request, Execution());
    EXPECT_EQ(report.findings.count("io.seal.journal_backward"), 1);
    EXPECT_THAT(idsOf(check(m_bundle).doubts), Contains("io.seal.journal_clock"));
}

TEST_F(Seal, NothingHalfWrittenStaysBehind) {
    const auto leftOver = [&] { return std::distance(fs::directory_iterator(m_folder.path()), fs::directory_iterator()); };
    Execution cancelled;
    cancelled.cancel();
    EXPECT_THROW(sealCase(m_bundle, m_sealed.request(), cancelled), Cancelled);
    EXPECT_THROW(UnpackedBundle(m_sealed.bundle(), check(m_sealed.bundle()), m_folder / "opened", cancelled), Cancelled);
    EXPECT_EQ(leftOver(), 0);
    {
        const FileSizeLimit full(20000);
        EXPECT_EQ(failureOf([&] { sealCase(m_bundle, m_sealed.request(), Execution()); }), "io.file.unwritable");
    }
    EXPECT_EQ(leftOver(), 0);
    // A file system that takes no files, as a disk that is read only.
    EXPECT_EQ(failureOf([&] { sealCase("/proc/self/sealed.rubblecase", m_sealed.request(), Execution()); }), "io.file.unwritable");
    const SealAddition addition{"B", std::nullopt, CustodyEntry{"A", "B", {}, {}, {}}, {}, {}, {}};
    EXPECT_EQ(failureOf([&] { addRecord(m_sealed.bundle(), "/proc/self/more.rubblecase", addition, Execution()); }),
              "io.file.unwritable");
}

TEST_F(Seal, WhatCannotBeSealedIsRefused) {
    SealRequest request = m_sealed.request();
    const std::string stopped = m_folder / "small.run.h5";
    std::ofstream(stopped) << "no run";
    request.runs = {stopped};
    EXPECT_NE(failureOf([&] { sealCase(m_bundle, request, Execution()); }), "");
    request = m_sealed.request();
    request.casePath = m_folder / "small.rubble";
    for (const char* name : {"small.rubble", "small.exo", "north.jpg"}) {
        fs::copy_file(m_sealed.path(name), m_folder / name);
    }
    EXPECT_EQ(failureOf([&] { sealCase(m_bundle, request, Execution()); }), "io.seal.input_missing");
    std::ofstream(m_folder / "south.jpg") << "another view";
    EXPECT_EQ(failureOf([&] { sealCase(m_bundle, request, Execution()); }), "io.seal.input_differs");
    EXPECT_EQ(failureOf([&] { check(m_sealed.casePath()); }), "io.seal.no_container");
    EXPECT_EQ(failureOf([&] { check(m_folder / "none.rubblecase"); }), "io.file.unreadable");
}

}  // namespace
}  // namespace rubble::io
