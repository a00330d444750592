#include "app/gui/window/options.h"

#include <gtest/gtest.h>

namespace rubble {

namespace {

Options parse(QStringList arguments) {
    return parseOptions(QStringList(QStringLiteral("rubble")) + arguments);
}

}  // namespace

TEST(Options, NoneOpensAnEmptyWindow) {
    const Options options = parse({});
    EXPECT_FALSE(options.wrong);
    EXPECT_TRUE(options.path.isEmpty());
    EXPECT_TRUE(options.text.isEmpty());
}

TEST(Options, AllTogether) {
    const Options options = parse({"--screenshot", "a.png", "--time", "5.76", "--size", "1280x800", "--theme", "dark", "--panel",
                                   "effects", "--simulate", "x.exo"});
    EXPECT_FALSE(options.wrong) << options.text.toStdString();
    EXPECT_EQ(options.screenshot, QStringLiteral("a.png"));
    EXPECT_DOUBLE_EQ(*options.time, 5.76);
    EXPECT_EQ(options.size, QSize(1280, 800));
    EXPECT_EQ(options.theme, QStringLiteral("dark"));
    EXPECT_EQ(options.panel, 3);
    EXPECT_TRUE(options.simulate);
    EXPECT_EQ(options.path, QStringLiteral("x.exo"));
}

TEST(Options, AChartNeedsTheComparison) {
    const Options options = parse({"--chart", "front.svg", "x.exo"});
    EXPECT_TRUE(options.accuracy);
    EXPECT_EQ(options.chart, QStringLiteral("front.svg"));
}

TEST(Options, MeasuringTakesAFile) {
    const Options options = parse({"--measure", "x.exo"});
    EXPECT_FALSE(options.wrong) << options.text.toStdString();
    EXPECT_TRUE(options.measure);
}

TEST(Options, WrongOnesSayWhy) {
    for (const QStringList& wrong : {QStringList{"--time", "soon"}, QStringList{"--time", "nan"}, QStringList{"--size", "12"},
                                     QStringList{"--theme", "pink"}, QStringList{"--panel", "dials"}, QStringList{"--measure"},
                                     QStringList{"--photo", "upside"}, QStringList{"--colour"}, QStringList{"a.exo", "b.exo"}}) {
        const Options options = parse(wrong);
        EXPECT_TRUE(options.wrong) << wrong.join(u' ').toStdString();
        EXPECT_FALSE(options.text.isEmpty()) << wrong.join(u' ').toStdString();
    }
}

TEST(Options, HelpNamesEveryOption) {
    const Options options = parse({"--help"});
    EXPECT_FALSE(options.wrong);
    for (const char* name :
         {"--sample", "--simulate", "--screenshot", "--time", "--size", "--theme", "--panel", "--photo", "--chart"}) {
        EXPECT_TRUE(options.text.contains(QLatin1String(name))) << name;
    }
}

}  // namespace rubble
