#include "widgets/basics/wording.h"

#include <gtest/gtest.h>

#include <QCoreApplication>
#include <QFile>
#include <QHash>
#include <QLocale>
#include <QRegularExpression>
#include <QTest>
#include <QTranslator>
#include <QXmlStreamReader>
#include <cmath>
#include <limits>

#include "tests/support/places.h"
#include "widgets/basics/fixed_number.h"
#include "widgets/basics/study_start.h"
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

/// All that the window can say, by the source of its catalogue: context and text, with the translation.
class WholeCatalogue : public QTranslator {
public:
    WholeCatalogue() {
        QFile file(QString::fromStdString(sourcePath("translations/rubble_zh_CN.ts")));
        EXPECT_TRUE(file.open(QIODevice::ReadOnly));
        QXmlStreamReader xml(&file);
        QString context, source;
        while (!xml.atEnd()) {
            if (xml.readNext() != QXmlStreamReader::StartElement) {
                continue;
            }
            if (xml.name() == QLatin1String("name")) {
                context = xml.readElementText();
            } else if (xml.name() == QLatin1String("source")) {
                source = xml.readElementText();
            } else if (xml.name() == QLatin1String("translation")) {
                m_texts[context][source] = xml.readElementText(QXmlStreamReader::IncludeChildElements);
            }
        }
    }
    const QHash<QString, QString>& of(const char* context) const { return m_texts.find(QLatin1String(context)).value(); }
    QString translate(const char* context, const char* source, const char*, int) const override {
        const auto texts = m_texts.find(QString::fromUtf8(context));
        return texts == m_texts.end() ? QString() : texts->value(QString::fromUtf8(source));
    }
    bool isEmpty() const override { return false; }

private:
    QHash<QString, QHash<QString, QString>> m_texts;
};

/// Options of other programs, which are typed as they are: of sbatch in a field of the window, of projsync in a shell.
QString withoutOptionsOfOthers(QString text) {
    static const QRegularExpression others(QStringLiteral("--(?:partition|account|file)\\b"));
    return text.remove(others);
}

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

TEST(Wording, KeysOfComponentsAreFieldsInTheWindow) {
    const auto said = [](const std::string& pattern) { return worded(Message{"x", pattern, {Argument("pier 2")}}); };
    EXPECT_EQ(said("no component is marked as reinforced (component[NAME].reinforced)"),
              QStringLiteral("no component is marked as reinforced (“Reinforced”)"));
    EXPECT_EQ(said("Set component[{0}].density to a positive number."),
              QStringLiteral("Set “Density” of “pier 2” to a positive number."));
    EXPECT_EQ(said("or set component[{0}].structural = false"), QStringLiteral("or set “Limits the grid” of “pier 2” = off"));
    EXPECT_EQ(said("such as pair[stone,soil].friction."), QStringLiteral("such as “Friction” of “stone,soil”."));
    EXPECT_EQ(said("a list[1].of things"), QStringLiteral("a list[1].of things"));
}

// "0.0 s left" stood for half a minute beside what went on.
TEST(Wording, NoTimeIsLeftWhereLessThanHalfASecondWouldBe) {
    EXPECT_EQ(shownProgress(QStringLiteral("drawing"), 12.0), QStringLiteral("Drawing · about 12 s left"));
    EXPECT_EQ(shownProgress(QStringLiteral("drawing"), 0.2), QStringLiteral("Drawing"));
    EXPECT_EQ(shownProgress(QStringLiteral("drawing"), std::nan("")), QStringLiteral("Drawing"));
}

// "About 4.9 s left" stood for half a minute.
TEST(Wording, TimeThatIsLeftGoesOnBetweenReports) {
    ProgressLabel label;
    label.setProgress(QStringLiteral("drawing"), 3000.0);
    label.show();
    const QString first = label.text();
    EXPECT_TRUE(first.contains(QStringLiteral("50 min 00 s")) || first.contains(QStringLiteral("49 min 59 s")))
        << qPrintable(first);
    EXPECT_TRUE(QTest::qWaitFor([&] { return label.text() != first; }, 60'000));
    EXPECT_TRUE(label.text().contains(QStringLiteral("49 min")));
    label.setProgress(QStringLiteral("drawing"), -10.0);
    EXPECT_TRUE(label.text().endsWith(QStringLiteral("takes longer than estimated"))) << "the time is over";
    label.setProgress(QStringLiteral("drawing"), std::nan(""));
    EXPECT_EQ(label.text(), QStringLiteral("Drawing"));
}

TEST(Wording, OptionsOfTheCommandLineAreFieldsInTheWindow) {
    const auto said = [](const std::string& pattern) { return worded(Message{"x", pattern, {Argument("fe-1")}}); };
    EXPECT_EQ(said("count it (--live)"), QStringLiteral("count it (“Fallen structure counts as debris” under “Evidence”)"));
    EXPECT_EQ(said("leave it out (--area, --leave-out)"),
              QStringLiteral("leave it out (“Draw an area of interest”, “Draw what is left out” under “Evidence”)"));
    EXPECT_EQ(said("seal without it: rubble-cli seal --leave-out {0}; its digest stays"),
              QStringLiteral("seal without it: rubble-cli seal; its digest stays"));
    EXPECT_EQ(said("Frames mostly have y up: --set up_axis=y."),
              QStringLiteral("Frames mostly have y up: “Up axis of the file” = y."));
    EXPECT_EQ(said("options of sbatch (--partition)"), QStringLiteral("options of sbatch (--partition)"));
}

TEST(Wording, TipsOfSettingsNameOthersAsTheirFieldsDo) {
    for (const Parameter& row : parameterTable()) {
        for (const Parameter& other : parameterTable()) {
            const bool isKey = other.key.find('_') != std::string_view::npos && !other.keyed();
            EXPECT_FALSE(isKey &&
                         shownHelp(row).split(QRegularExpression(QStringLiteral("\\W+"))).contains(QLatin1String(other.key)))
                << row.key << ": " << other.key;
        }
    }
}

// "raise “Steps per second” or substeps": what is called otherwise beside its field is no key on screen.
TEST(Wording, NoMessageHasAKeyOfASettingInTheWindow) {
    WholeCatalogue chinese;
    const QStringList sources = chinese.of("messages").keys();
    QStringList keys;
    for (const Parameter& row : parameterTable()) {
        const QString key = QString::fromUtf8(row.key.data(), static_cast<qsizetype>(row.key.size()));
        if (!row.keyed() && key.contains(u'_')) {
            keys << key;
        }
    }
    ASSERT_GT(keys.size(), 30);
    // A translation has no English word where it does not mean the setting.
    const QStringList wordsOfChinese{QStringLiteral("substeps"), QStringLiteral("iterations"), QStringLiteral("multiple"),
                                     QStringLiteral("solver"), QStringLiteral("revival")};
    static const QRegularExpression apart(QStringLiteral("[^A-Za-z0-9_]+"));
    for (const bool translated : {false, true}) {
        if (translated) {
            QCoreApplication::installTranslator(&chinese);
        }
        for (const QString& source : sources) {
            const QString words = worded(Message{"x", source.toStdString(), {}});
            const QStringList parts = words.split(apart);
            for (const QString& key : translated ? keys + wordsOfChinese : keys) {
                EXPECT_FALSE(parts.contains(key)) << key.toStdString() << ": " << words.toStdString();
            }
        }
    }
    EXPECT_FALSE(
        worded(
            Message{
                "x",
                "raise step_rate or substeps; light bodies between far heavier ones ask for it. Where as many are held back after "
                "that, what they did is less sure",
                {}})
            .contains(QStringLiteral("substeps")));
    QCoreApplication::removeTranslator(&chinese);
    EXPECT_EQ(worded(Message{"x", "raise step_rate or substeps", {}}), QStringLiteral("raise “Steps per second” or “Substeps”"));
}

TEST(Wording, UnitsOfSentencesAreRaised) {
    EXPECT_EQ(worded(Message{"x", "set it in kg/m3, m/s2 or kN/m3; {2} beam2 m3x", {}}),
              QStringLiteral("set it in kg/m³, m/s² or kN/m³; {2} beam2 m3x"));
    for (const Parameter& row : parameterTable()) {
        EXPECT_FALSE(shownHelp(row).contains(QRegularExpression(QStringLiteral("/m[23]\\b|/s2\\b")))) << row.key;
    }
}

TEST(Wording, NoMessageNamesAnOptionInTheWindow) {
    WholeCatalogue chinese;
    const QStringList sources = chinese.of("messages").keys();
    ASSERT_GT(sources.size(), 1000);
    for (const bool translated : {false, true}) {
        if (translated) {
            QCoreApplication::installTranslator(&chinese);
        }
        for (const QString& source : sources) {
            const QString words = worded(Message{"x", source.toStdString(), {}});
            EXPECT_FALSE(withoutOptionsOfOthers(words).contains(QLatin1String("--"))) << words.toStdString();
        }
    }
    // What stands for an option is what its field is called: its words are in the catalogue.
    for (const QString& source : sources) {
        const QString words = worded(Message{"x", source.toStdString(), {}});
        static const QRegularExpression name(QStringLiteral("“[A-Z]"));
        EXPECT_FALSE(source.contains(QLatin1String(" (--")) && words.contains(name)) << words.toStdString();
    }
    QCoreApplication::removeTranslator(&chinese);
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
    EXPECT_EQ(shownDuration(0.07), QStringLiteral("0.07 s"));
    EXPECT_EQ(shownDuration(0.0042), QStringLiteral("0.004 s"));
    EXPECT_EQ(shownDuration(0.13), QStringLiteral("0.1 s"));
    EXPECT_EQ(shownDuration(0.0), QStringLiteral("0.0 s"));
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
