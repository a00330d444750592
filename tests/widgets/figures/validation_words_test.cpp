#include "widgets/figures/report/validation_words.h"

#include <gtest/gtest.h>

#include <QCoreApplication>
#include <QTranslator>

#include "core/validation/scene_sets.h"
#include "io/validation/set_folder.h"
#include "tests/scenes/validation_records.h"
#include "tests/support/places.h"
#include "widgets/figures/figure_file.h"
#include "widgets/figures/report/validation_rows.h"

namespace rubble::figures {

namespace {

/// Says every text with a mark, so that one sees what is said at all.
class Marking : public QTranslator {
public:
    Marking() { QCoreApplication::installTranslator(this); }
    ~Marking() override { QCoreApplication::removeTranslator(this); }
    Marking(const Marking&) = delete;
    Marking& operator=(const Marking&) = delete;
    bool isEmpty() const override { return false; }
    QString translate(const char*, const char* source, const char*, int) const override {
        return QStringLiteral("~") + QString::fromUtf8(source);
    }
};

/// Translators belong to an application.
class ValidationWords : public testing::Test {
protected:
    void SetUp() override { ensureGuiApplication(); }
};

bool isSaid(const std::string& english) {
    return validationWords(english).startsWith(u'~');
}

/// Where numbers come from: people and a year, a system, an address.
bool isCitation(const std::string& source) {
    return source.find(" (1") != std::string::npos || source.find(" (2") != std::string::npos ||
           source.find("EnviDat") != std::string::npos;
}

std::vector<ValidationSet> shippedSets() {
    std::vector<ValidationSet> sets;
    for (const SceneSet& scene : sceneSets()) {
        sets.push_back(scene.about);
    }
    for (const io::SetPlace& place : io::setsIn(sourcePath("resources/validation"))) {
        sets.push_back(io::readSet(place, Execution()));
    }
    return sets;
}

TEST_F(ValidationWords, AllThatShippedSetsSayIsKnown) {
    const Marking marking;
    const std::vector<ValidationSet> sets = shippedSets();
    ASSERT_GE(sets.size(), 5U);
    for (const ValidationSet& set : sets) {
        EXPECT_TRUE(isSaid(set.title)) << set.title;
        EXPECT_TRUE(isSaid(set.source) || isCitation(set.source)) << set.source;
        for (const SetVariant& variant : set.variants) {
            EXPECT_TRUE(isSaid(variant.name)) << variant.name;
            for (const SetParameter& parameter : variant.parameters) {
                EXPECT_TRUE(isSaid(parameter.source) || isCitation(parameter.source)) << parameter.source;
            }
            for (const SetVaried& varied : variant.varied) {
                EXPECT_TRUE(isSaid(varied.source)) << varied.source;
            }
        }
    }
}

TEST_F(ValidationWords, WhatASetOfTheUserSaysStaysAsItIs) {
    const Marking marking;
    EXPECT_EQ(validationWords("blocks of the quarry"), QStringLiteral("blocks of the quarry"));
    EXPECT_EQ(validationWords(""), QString());
}

TEST_F(ValidationWords, WhatIsAskedIsSaidInTheLanguageThatIsSpoken) {
    ValidationRecord record = scenes::tossRecord();
    record.variants[0].verdicts[0].asked = "at least 0.54, below run_out_m[Plate].simulated 84.2";
    const auto asked = [&] { return validationRows(record)[1].asked; };
    EXPECT_EQ(asked(), QStringLiteral("at least 0.54 and below 84.2 (run-out, Plate): <b>does not hold</b>"));
    const Marking marking;
    for (const char* said : {"~at least 0.54", "~below 84.2 (~run-out, Plate)"}) {
        EXPECT_TRUE(asked().contains(QLatin1String(said))) << asked().toStdString();
    }
}

}  // namespace

}  // namespace rubble::figures
