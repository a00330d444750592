#include "app/gui/studies/answer.h"

#include <gtest/gtest.h>

#include <string>

namespace rubble {

TEST(Answer, IsStaleWhenSomethingElseWouldBeAskedFor) {
    Answer<int, std::string> answer;
    EXPECT_FALSE(answer.stale(1)) << "there is none yet";
    answer.ask(1);
    EXPECT_TRUE(answer.running());
    answer.take(std::make_shared<const std::string>("one"));
    answer.end();
    EXPECT_FALSE(answer.running());
    EXPECT_EQ(*answer.result(), "one");
    EXPECT_FALSE(answer.stale(1));
    EXPECT_TRUE(answer.stale(2));
}

TEST(Answer, OneThatFailsLeavesTheOneBeforeAndWhatThatWasMadeOf) {
    Answer<int, std::string> answer;
    answer.ask(1);
    answer.take(std::make_shared<const std::string>("one"));
    answer.end();
    answer.ask(2);
    EXPECT_TRUE(answer.stale(2)) << "what is shown while the next is made answers the question before";
    const Failure failure{[] { return QStringLiteral("no room on the disk"); }, [] { return QStringLiteral("make some"); }, {}};
    answer.end(&failure);
    EXPECT_EQ(*answer.result(), "one");
    EXPECT_EQ(answer.answered(), 1);
    EXPECT_TRUE(answer.stale(2));
    ASSERT_TRUE(answer.failure());
    EXPECT_EQ(answer.failure()->what(), QStringLiteral("no room on the disk"));
    answer.ask(2);
    EXPECT_FALSE(answer.failure());
}

TEST(Answer, ThatIsDroppedMayStillBeMade) {
    Answer<int, std::string> answer;
    answer.ask(1);
    answer.take(std::make_shared<const std::string>("one"));
    answer.drop();
    EXPECT_EQ(answer.result(), nullptr);
    EXPECT_FALSE(answer.stale(2)) << "there is none";
    EXPECT_TRUE(answer.running());
    answer.take(std::make_shared<const std::string>("one, more complete"));
    EXPECT_EQ(*answer.result(), "one, more complete");
}

TEST(Answer, IsShownByTheRail) {
    using widgets::StageState;
    EXPECT_EQ(answerState(true, true, true), StageState::Running);
    EXPECT_EQ(answerState(false, false, true), StageState::NotYet);
    EXPECT_EQ(answerState(false, true, true), StageState::Stale);
    EXPECT_EQ(answerState(false, true, false), StageState::UpToDate);
}

}  // namespace rubble
