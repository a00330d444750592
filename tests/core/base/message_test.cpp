#include "core/base/message.h"

#include <gtest/gtest.h>

#include <limits>

#include "core/base/error.h"
#include "core/base/finding.h"

namespace rubble {
namespace {

TEST(Message, PutsArgumentsWithUnitsIntoThePattern) {
    const Message message{"x", "{1} of {0} weigh {2}", {49561, "bridge", Argument(65869.4, "t")}};
    EXPECT_EQ(englishText(message), "bridge of 49,561 weigh 65,869 t");
}

TEST(Message, LeavesBracesAloneThatNameNoArgument) {
    EXPECT_EQ(englishText({"x", "{7} {} {a} {0", {1}}), "{7} {} {a} {0");
}

TEST(Message, GroupsThousandsAtEverySize) {
    EXPECT_EQ(englishInteger(0), "0");
    EXPECT_EQ(englishInteger(-999), "-999");
    EXPECT_EQ(englishInteger(1000), "1,000");
    EXPECT_EQ(englishInteger(-1234567), "-1,234,567");
    EXPECT_EQ(englishInteger(std::numeric_limits<std::int64_t>::min()), "-9,223,372,036,854,775,808");
}

TEST(Message, PrintsNumbersToFourSignificantDigits) {
    EXPECT_EQ(englishNumber(0.123456), "0.1235");
    EXPECT_EQ(englishNumber(12.0), "12");
    EXPECT_EQ(englishNumber(-2400.4), "-2,400");
    EXPECT_EQ(englishNumber(std::numeric_limits<double>::quiet_NaN()), "not a number");
    EXPECT_EQ(englishNumber(-std::numeric_limits<double>::infinity()), "minus infinite");
}

TEST(Error, SaysWhatAndRemedy) {
    const WorldError error({"file.missing", "{0} cannot be read.", {"a.exo"}}, {"file.check", "Check the path.", {}});
    EXPECT_STREQ(error.what(), "a.exo cannot be read.\nCheck the path.");
    EXPECT_EQ(error.message().id, "file.missing");
}

TEST(Findings, CountsByIdAndKeepsTheFirstExample) {
    Findings findings;
    findings.add({"a", "A", {}}, {}, "first");
    findings.add({"b", "B", {}}, {}, "other");
    findings.add({"a", "A", {}}, {}, "second", 3);
    ASSERT_EQ(findings.list().size(), 2u);
    EXPECT_EQ(findings.count("a"), 4);
    EXPECT_EQ(findings.list()[0].example, "first");
    EXPECT_EQ(findings.count("c"), 0);

    Findings more;
    more.add({"b", "B", {}}, {}, "x", 5);
    findings.append(more);
    EXPECT_EQ(findings.count("b"), 6);
    EXPECT_EQ(findings.list()[1].example, "other");
}

}  // namespace
}  // namespace rubble
