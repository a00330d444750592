#include "io/case/journal.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "io/case/case_file.h"
#include "io/case/journal_check.h"
#include "tests/support/temporary_folder.h"

namespace rubble::io {
namespace {

using nlohmann::json;
using testing::ElementsAre;

class JournalOfACase : public testing::Test {
protected:
    void SetUp() override {
        m_case = saveCase(m_path, caseForFe("/x/bridge.exo", m_path));
        m_case.scenarios[0].scenario.simulation.friction = 0.5;
        m_case = saveCase(m_path, m_case);
    }
    json document() const {
        std::ifstream in(m_path);
        return json::parse(in);
    }
    void write(const json& document) const { std::ofstream(m_path) << document.dump(2) << '\n'; }

    TemporaryFolder m_folder;
    std::string m_path = m_folder / "bridge.rubble";
    Case m_case;
};

TEST_F(JournalOfACase, SaysWhatChangedAndIsChained) {
    ASSERT_EQ(m_case.journal.entries.size(), 2u);
    const JournalEntry& second = m_case.journal.entries[1];
    ASSERT_EQ(second.changes.size(), 1u);
    EXPECT_EQ(second.changes[0], (JournalChange{"scenarios/scenario-1/settings/friction", "", "0.5"}));
    EXPECT_FALSE(second.who.empty());
    EXPECT_EQ(second.when.size(), 20u);
    EXPECT_EQ(second.digest.size(), 64u);
    EXPECT_NE(second.digest, m_case.journal.entries[0].digest);
    const JournalCheck check = checkJournal(m_path);
    EXPECT_TRUE(check.sound());
    EXPECT_EQ(check.entries, 2u);
}

TEST_F(JournalOfACase, NamesEntriesOfAnEarlierTimeThanTheOneBefore) {
    json document = this->document();
    document["journal"][0]["when"] = "2198-01-01T00:00:00Z";
    write(document);
    const JournalCheck check = checkJournal(m_path);
    EXPECT_THAT(check.backward, ElementsAre(2u));
    EXPECT_EQ(check.last, "2198-01-01T00:00:00Z");
    EXPECT_EQ(check.head, m_case.journal.entries[1].digest);
}

TEST_F(JournalOfACase, GrowsOnlyWhenSomethingHasChanged) {
    const json before = document();
    saveCase(m_path, loadCase(m_path));
    EXPECT_EQ(document(), before);
}

TEST_F(JournalOfACase, NamesWhatWasAlteredInTheFile) {
    json document = this->document();
    document["scenarios"][0]["settings"]["friction"] = 0.7;
    document["title"] = "another bridge";
    write(document);
    const JournalCheck check = checkJournal(m_path);
    EXPECT_FALSE(check.sound());
    EXPECT_TRUE(check.broken.empty());
    EXPECT_THAT(check.altered, ElementsAre(JournalChange{"scenarios/scenario-1/settings/friction", "0.5", "0.7"},
                                           JournalChange{"title", "\"bridge\"", "\"another bridge\""}));
}

TEST_F(JournalOfACase, NamesTheEntryThatWasAlteredOrTakenOut) {
    json altered = document();
    altered["journal"][0]["who"] = "somebody else";
    write(altered);
    EXPECT_THAT(checkJournal(m_path).broken, ElementsAre(1u));
    json forged = document();
    // Consistent with the file, but not with the chain.
    forged["journal"][1]["changes"][0]["after"] = 0.7;
    forged["scenarios"][0]["settings"]["friction"] = 0.7;
    forged["journal"][0]["who"] = m_case.journal.entries[0].who;
    write(forged);
    EXPECT_THAT(checkJournal(m_path).broken, ElementsAre(2u));
    EXPECT_TRUE(checkJournal(m_path).altered.empty());
    json shorter = document();
    shorter["journal"].erase(0);
    write(shorter);
    EXPECT_THAT(checkJournal(m_path).broken, ElementsAre(1u));
}

TEST_F(JournalOfACase, AnAlterationStaysKnownAfterTheNextSaving) {
    json document = this->document();
    document["scenarios"][0]["settings"]["friction"] = 0.7;
    write(document);
    Case theCase = loadCase(m_path);
    theCase.title = "a bridge";
    saveCase(m_path, theCase);
    const JournalCheck check = checkJournal(m_path);
    EXPECT_TRUE(check.sound());
    ASSERT_EQ(check.entries, 4u);
    ASSERT_EQ(check.outside.size(), 1u);
    EXPECT_THAT(check.outside[0].changes, ElementsAre(JournalChange{"scenarios/scenario-1/settings/friction", "0.5", "0.7"}));
    EXPECT_TRUE(check.outside[0].who.empty());
}

TEST_F(JournalOfACase, AScenarioKeepsItsPlaceWhenAnotherGoes) {
    m_case.scenarios.push_back(m_case.scenarios[0]);
    m_case.scenarios[1].id = "scenario-2";
    m_case = saveCase(m_path, m_case);
    m_case.scenarios.erase(m_case.scenarios.begin());
    m_case.activeScenario = "scenario-2";
    m_case = saveCase(m_path, m_case);
    for (const JournalChange& change : m_case.journal.entries.back().changes) {
        EXPECT_FALSE(change.place.starts_with("scenarios/scenario-2")) << change.place;
    }
    EXPECT_TRUE(checkJournal(m_path).sound());
}

TEST(Journal, ACaseOfBeforeHasNoneAndIsSound) {
    const TemporaryFolder folder;
    const Case theCase = caseForFe("/x/bridge.exo", folder / "a.rubble");
    json old = json::parse(caseText(theCase));
    old.erase("journal");
    old["version"] = 3;
    std::ofstream(folder / "a.rubble") << old.dump();
    EXPECT_EQ(loadCase(folder / "a.rubble"), theCase);
    const JournalCheck check = checkJournal(folder / "a.rubble");
    EXPECT_TRUE(check.sound());
    EXPECT_EQ(check.entries, 0u);
}

}  // namespace
}  // namespace rubble::io
