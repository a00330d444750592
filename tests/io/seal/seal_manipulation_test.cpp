#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <random>

#include "core/base/error.h"
#include "io/base/files.h"
#include "io/case/case_file.h"
#include "io/exports/report_notes.h"
#include "io/seal/bag.h"
#include "io/seal/seal_check.h"
#include "io/seal/signature.h"
#include "tests/io/seal/sealed_small_case.h"

namespace rubble::io {
namespace {

using nlohmann::json;

/// Alters a sealed bundle in one way after the other, by a seed, and looks whether the alteration is named.
class Manipulation : public testing::Test {
protected:
    void SetUp() override {
        m_files = packedFiles(m_sealed.bundle());
        m_bytes = contentOf(m_sealed.bundle()).value();
        m_trust.signer.expected = m_sealed.report().statement.signer;
        // A case whose journal was written anew as a whole: chained well, and of other content.
        Case other = caseForFe(m_sealed.path("small.exo"), m_folder / "small.rubble");
        other.title = "Two blocks";
        m_otherCase = caseText(saveCase(m_folder / "small.rubble", other));
        runSmallCase(m_sealed.casePath(), m_folder / "other.run.h5", "Rubble 9.9.9 another compiler");
        m_otherRun = contentOf(m_folder / "other.run.h5").value();
        m_otherKey = makeKey(m_folder / "other.pem");
    }

    std::size_t below(std::size_t limit) { return std::uniform_int_distribution<std::size_t>(0, limit - 1)(m_random); }
    char otherByte(char byte) { return static_cast<char>(byte ^ static_cast<char>(1 + below(255))); }

    /// What the check says of a bundle: the places of its faults, or an error that it cannot be opened.
    std::vector<std::string> places(const std::string& path) {
        try {
            const SealCheck check = checkBundle(path, m_trust, Execution());
            std::vector<std::string> list;
            for (const SealFault& fault : check.faults) {
                list.push_back(fault.place);
            }
            return list;
        } catch (const ParseError& error) {
            return {"refused"};
        }
    }
    std::vector<std::string> placesOf(const PackedFiles& files) {
        packFiles(m_altered, files);
        return places(m_altered);
    }
    std::vector<std::string> placesOfBytes(const std::string& bytes) {
        std::ofstream(m_altered, std::ios::binary) << bytes;
        return places(m_altered);
    }

    /// Signs what lies in the bag as another would, with a key of theirs.
    void signAnew(PackedFiles& files, const std::function<void(json&)>& change = {}) {
        listAnew(files);
        json statement = json::parse(contentAt(files, bag::statement));
        const Signer signer({m_otherKey, {}, {}});
        statement["manifest"]["sha256"] = sha256OfText(contentAt(files, bag::manifest));
        statement["signer"]["key_sha256"] = signer.facts().fingerprint;
        if (change) {
            change(statement);
        }
        contentAt(files, bag::statement) = statement.dump(1) + "\n";
        contentAt(files, bag::signature) = signer.sign(contentAt(files, bag::statement));
        contentAt(files, bag::publicKey) = signer.publicKey();
        listAnew(files);
    }

    void alter(std::size_t kind);
    void anyByte();
    void byteOfAFile();
    void swappedPhotographs();
    void entryLeftOut();
    void backDated();
    void journalAnew();
    void runOfAnotherBuild();
    void cutShort();
    void filePutIn();

    static constexpr const char* m_north = "data/inputs/north/north.jpg";
    static constexpr const char* m_south = "data/inputs/south/south.jpg";
    static constexpr const char* m_run = "data/runs/small.run.h5";
    static constexpr const char* m_case = "data/case/small.rubble";
    static constexpr const char* m_notes = "data/case/small.rubble.report.json";
    const SealedSmallCase& m_sealed = SealedSmallCase::the();
    TemporaryFolder m_folder;
    std::string m_altered = m_folder / "altered.rubblecase";
    std::mt19937 m_random{41};
    SealTrust m_trust;
    PackedFiles m_files;
    std::string m_bytes, m_otherCase, m_otherRun, m_otherKey;
};

void Manipulation::anyByte() {
    std::string bytes = m_bytes;
    const std::size_t at = below(bytes.size());
    bytes[at] = otherByte(bytes[at]);
    EXPECT_FALSE(placesOfBytes(bytes).empty()) << "byte " << at;
}

void Manipulation::byteOfAFile() {
    PackedFiles files = m_files;
    auto& [name, content] = files[below(files.size())];
    char& byte = content[below(content.size())];
    byte = otherByte(byte);
    const std::string place = name.substr(name.find('/') + 1);
    const std::vector<std::string> named = placesOf(files);
    if (place == bag::declaration && named == std::vector<std::string>{"refused"}) {
        return;
    }
    // A list of files that was altered is named itself, or the file that it now tells of.
    EXPECT_TRUE(place == bag::tagManifest ? !named.empty() : testing::Value(named, testing::Contains(place))) << place;
}

void Manipulation::swappedPhotographs() {
    PackedFiles files = m_files;
    std::swap(contentAt(files, m_north), contentAt(files, m_south));
    const std::size_t way = below(3);
    if (way == 1) {
        listAnew(files);
        EXPECT_THAT(placesOf(files), testing::Contains(bag::manifest));
    } else if (way == 2) {
        signAnew(files);
        EXPECT_THAT(placesOf(files), testing::Contains(bag::signature));
    } else {
        EXPECT_THAT(placesOf(files), testing::IsSupersetOf({m_north, m_south}));
    }
}

void Manipulation::entryLeftOut() {
    PackedFiles files = m_files;
    const std::size_t at = below(files.size());
    const std::string place = files[at].first.substr(files[at].first.find('/') + 1);
    files.erase(files.begin() + static_cast<std::ptrdiff_t>(at));
    const bool lists = place == bag::manifest || place == bag::tagManifest;
    if (!lists && below(2) == 1) {
        listAnew(files);
    }
    EXPECT_FALSE(placesOf(files).empty()) << place;
}

void Manipulation::backDated() {
    PackedFiles files = m_files;
    const std::string year = std::to_string(1990 + below(30));
    const auto earlier = [&](json& statement) { statement["sealed_at"] = year + "-01-01T00:00:00Z"; };
    if (below(2) == 0) {
        json statement = json::parse(contentAt(files, bag::statement));
        earlier(statement);
        contentAt(files, bag::statement) = statement.dump(1) + "\n";
        listAnew(files);
    } else {
        signAnew(files, earlier);
    }
    // The journal is of a later time than a sealing that is dated back, whoever signs.
    EXPECT_THAT(placesOf(files), testing::IsSupersetOf({bag::signature, m_case}));
}

void Manipulation::journalAnew() {
    PackedFiles files = m_files;
    contentAt(files, m_case) = m_otherCase;
    if (below(2) == 0) {
        listAnew(files);
        EXPECT_THAT(placesOf(files), testing::IsSupersetOf({m_case, bag::manifest}));
    } else {
        signAnew(files, [&](json& statement) { statement["case"]["sha256"] = sha256OfText(m_otherCase); });
        EXPECT_THAT(placesOf(files), testing::IsSupersetOf({m_case, bag::signature}));
    }
}

void Manipulation::runOfAnotherBuild() {
    PackedFiles files = m_files;
    contentAt(files, m_run) = m_otherRun;
    const std::size_t way = below(3);
    if (way == 0) {
        EXPECT_THAT(placesOf(files), testing::Contains(m_run));
    } else if (way == 1) {
        listAnew(files);
        EXPECT_THAT(placesOf(files), testing::IsSupersetOf({m_run, bag::manifest}));
    } else {
        signAnew(files, [&](json& statement) { statement["runs"][0]["sha256"] = sha256OfText(m_otherRun); });
        EXPECT_THAT(placesOf(files), testing::Contains(bag::signature));
    }
}

void Manipulation::cutShort() {
    EXPECT_FALSE(placesOfBytes(m_bytes.substr(0, below(m_bytes.size()))).empty());
}

void Manipulation::filePutIn() {
    PackedFiles files = m_files;
    const std::string folder = files.front().first.substr(0, files.front().first.find('/') + 1);
    static const std::array<std::string, 5> places{"data/exports/more.csv", "records/0001-custody/more.txt", "OPINION.txt",
                                                   "seal/opinion-of-the-signer.txt", "records/0001-custody/signer.pem"};
    const std::string& place = places[below(places.size())];
    files.insert(files.begin() + 1 + static_cast<std::ptrdiff_t>(below(files.size())), {folder + place, "more"});
    const bool listed = below(2) == 1;
    if (listed) {
        listAnew(files);
    }
    // The list of the payload was signed; a file about the bag is named whoever lists it.
    EXPECT_THAT(placesOf(files), testing::Contains(listed && place.starts_with(bag::payload) ? bag::manifest : place));
}

void Manipulation::alter(std::size_t kind) {
    switch (kind) {
        case 0:
            return anyByte();
        case 1:
            return byteOfAFile();
        case 2:
            return swappedPhotographs();
        case 3:
            return entryLeftOut();
        case 4:
            return backDated();
        case 5:
            return journalAnew();
        case 6:
            return runOfAnotherBuild();
        case 7:
            return cutShort();
        default:
            return filePutIn();
    }
}

TEST_F(Manipulation, OfAThousandEveryOneIsNamed) {
    ASSERT_THAT(places(m_sealed.bundle()), testing::IsEmpty());
    for (int i = 0; i < 1000; ++i) {
        SCOPED_TRACE(i);
        const std::size_t kind = below(9);
        SCOPED_TRACE(kind);
        alter(kind);
        if (HasFailure()) {
            break;
        }
    }
}

// What lies behind a damaged byte was not touched, and is not accused.
TEST_F(Manipulation, ADamagedFileIsNamedAlone) {
    for (const char* place : {m_north, m_south, m_run, m_case, m_notes}) {
        std::string bytes = m_bytes;
        char& byte = bytes[bytes.find(contentAt(m_files, place)) + 5];
        byte = otherByte(byte);
        EXPECT_THAT(placesOfBytes(bytes), testing::Each(place)) << place;
    }
}

// Words of the report's author lie beside the case and are opened with it.
TEST_F(Manipulation, OtherWordsOfTheAuthorThanThoseSealedAreNamed) {
    const SealCheck whole = checkBundle(m_sealed.bundle(), m_trust, Execution());
    EXPECT_TRUE(whole.sound());
    EXPECT_EQ(whole.notes, m_notes);
    PackedFiles files = m_files;
    std::string& notes = contentAt(files, m_notes);
    EXPECT_EQ(reportNotesFrom(notes, m_notes).words.custody, "from the police");
    notes.replace(notes.find("from the police"), 15, "found by myself");
    EXPECT_THAT(placesOf(files), testing::Contains(m_notes));
    PackedFiles listed = files;
    listAnew(listed);
    EXPECT_THAT(placesOf(listed), testing::Contains(bag::manifest)) << "the list of files was signed";
    signAnew(files);
    EXPECT_THAT(placesOf(files), testing::Contains(bag::signature));
    // Left out, cut short by whoever sealed, or put where none were.
    PackedFiles less = m_files;
    std::erase_if(less, [](const auto& file) { return file.first.ends_with(m_notes); });
    EXPECT_THAT(placesOf(less), testing::Contains(m_notes));
    PackedFiles cut = m_files;
    contentAt(cut, m_notes).resize(20);
    signAnew(cut);
    EXPECT_THAT(placesOf(cut), testing::Contains(m_notes)) << "no notes, whoever signs";
    PackedFiles more = less;
    signAnew(more);
    EXPECT_THAT(placesOf(more), testing::Not(testing::Contains(m_notes)));
    more.push_back({more.front().first.substr(0, more.front().first.find('/') + 1) + m_notes, contentAt(m_files, m_notes)});
    EXPECT_THAT(placesOf(more), testing::Contains(m_notes));
}

// What is packed by another hand, with the same files in it, is told apart from what was altered.
TEST_F(Manipulation, ARepackedContainerIsNamedAsSuchAlone) {
    PackedFiles files = m_files;
    std::swap(files[3], files[4]);
    EXPECT_THAT(placesOf(files), testing::IsEmpty());
    std::string longer = m_bytes + "more";
    EXPECT_FALSE(placesOfBytes(longer).empty());
    const std::size_t date = m_bytes.find("small/bagit.txt") - 20;
    std::string dated = m_bytes;
    dated[date] = static_cast<char>(dated[date] + 1);
    EXPECT_THAT(placesOfBytes(dated), testing::ElementsAre(""));
}

}  // namespace
}  // namespace rubble::io
