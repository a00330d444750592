#include "widgets/basics/wording.h"

#include <gtest/gtest.h>

#include <QCoreApplication>
#include <QLocale>
#include <QTranslator>
#include <cmath>
#include <limits>

#include "widgets/basics/fixed_number.h"
#include "widgets/figures/report/spoken_text.h"

namespace rubble::widgets {

namespace {

/// Knows one sentence, by its pattern.
class OneSentence : public QTranslator {
public:
    QString translate(const char*, const char* source, const char*, int) const override {
        return QLatin1String(source) == QLatin1String("{0} has {1}") ? QStringLiteral("{1} von {0}") : QString();
    }
    bool isEmpty() const override { return false; }
};

const Message sentence{"test.sentence", "{0} has {1}", {Argument("pier 2"), Argument(1234567)}};

}  // namespace

TEST(Wording, EnglishIsThePatternWithItsArguments) {
    EXPECT_EQ(worded(sentence), QStringLiteral("pier 2 has 1,234,567"));
    EXPECT_EQ(worded(Message{"x", "{0} and {9} {", {Argument("a")}}), QStringLiteral("a and {9} {"));
}

TEST(Wording, ATranslationIsFoundByThePatternOfTheMessage) {
    OneSentence translator;
    QCoreApplication::installTranslator(&translator);
    EXPECT_EQ(worded(sentence), QStringLiteral("1,234,567 von pier 2"));
    QCoreApplication::removeTranslator(&translator);
    EXPECT_EQ(worded(sentence), QStringLiteral("pier 2 has 1,234,567"));
}

TEST(Wording, WhatStandsInQuotationMarksIsAName) {
    EXPECT_TRUE(figures::isVerbatim("{0}: no component \"{1}\"", 1));
    EXPECT_FALSE(figures::isVerbatim("{0}: no component \"{1}\"", 0));
    EXPECT_TRUE(figures::isVerbatim("Set component[{0}].density", 0));
    EXPECT_FALSE(figures::isVerbatim("\"{1}\", \"{10}\" and {0}", 0));
}

TEST(Wording, NumbersShowWhatTheyDeserve) {
    EXPECT_EQ(shownNumber(0.0), QStringLiteral("0"));
    EXPECT_EQ(shownNumber(1.2345), QStringLiteral("1.23"));
    EXPECT_EQ(shownNumber(123456.0), QStringLiteral("123,000"));
    EXPECT_EQ(shownNumber(3.94e-16, 2), QString::fromUtf8("3.9 × 10⁻¹⁶"));
    EXPECT_EQ(shownNumber(9.999), QStringLiteral("10.00"));
    EXPECT_EQ(shownEnergy(7.886e9), QStringLiteral("7.89") + QChar(0x00A0) + QStringLiteral("GJ"));
    EXPECT_EQ(shownEnergy(-12.0), QStringLiteral("-12.0") + QChar(0x00A0) + QStringLiteral("J"));
    EXPECT_EQ(shownNumber(-0.012345), QStringLiteral("-0.0123"));
    EXPECT_EQ(shownNumber(std::numeric_limits<double>::quiet_NaN()), QString(QChar(0x2013)));
    EXPECT_EQ(shownShare(0.984), QStringLiteral("98.4 %"));
    EXPECT_LT(shownShare(3e200).size(), 16) << "no hundreds of digits";
    EXPECT_EQ(shownDuration(185.0), QStringLiteral("3 min 05 s"));
    EXPECT_EQ(shownName("oriented_box"), QStringLiteral("oriented box"));
}

TEST(Wording, WhatRoundsToZeroHasNoSign) {
    EXPECT_EQ(shownFixed(-0.0004, 3), QStringLiteral("0.000"));
    EXPECT_EQ(shownFixed(-0.0, 1), QStringLiteral("0.0"));
    EXPECT_EQ(shownFixed(-0.0006, 3), QStringLiteral("-0.001"));
    EXPECT_EQ(shownFixed(-1.25, 1).left(2), QStringLiteral("-1"));
    EXPECT_EQ(shownFixed(std::numeric_limits<double>::infinity(), 3), QString(QChar(0x2013)));
    EXPECT_EQ(shownPlace(-0.001), QStringLiteral("0.00"));
}

TEST(Wording, AnotherLocaleHasItsOwnSigns) {
    QLocale::setDefault(QLocale(QLocale::German));
    EXPECT_EQ(shownNumber(1.2345), QStringLiteral("1,23"));
    EXPECT_EQ(shownCount(1234567), QStringLiteral("1.234.567"));
    QLocale::setDefault(QLocale(QLocale::English));
}

}  // namespace rubble::widgets
