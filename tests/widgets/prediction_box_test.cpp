#include "widgets/basics/prediction_box.h"

#include <gtest/gtest.h>

#include <QLabel>
#include <QSignalSpy>
#include <cmath>

#include "widgets/basics/wording.h"
#include "widgets/run/run_panel.h"

namespace rubble::widgets {

namespace {

using State = PredictionContent::State;

Prediction between(double low, double value, double high, std::size_t points = 7) {
    Prediction prediction;
    prediction.known = true;
    prediction.low = low;
    prediction.value = value;
    prediction.high = high;
    prediction.points = points;
    prediction.fromCalibration = points == 0;
    return prediction;
}

Prediction unknown() {
    Prediction prediction;
    prediction.value = prediction.low = prediction.high = std::nan("");
    prediction.reason = {
        "prediction.few_points", "{0} earlier points with the same settings but for numbers; {1} are needed", {2, 4}};
    return prediction;
}

/// Time and FPS known, two measures of accuracy not.
PredictionContent content(State state) {
    PredictionContent content;
    content.state = state;
    content.bodies = 4453;
    content.figures = {{Predicted::WallSeconds, between(45.0, 52.0, 62.0), {}},
                       {Predicted::Fps, between(17.2, 21.3, 26.1, 0), {}},
                       {Predicted::MassMap, unknown(), {}},
                       {Predicted::FootprintIou, unknown(), {}}};
    return content;
}

}  // namespace

TEST(PredictionBox, ShowsValuesWithTheirIntervals) {
    PredictionBox box;
    EXPECT_TRUE(box.isHidden()) << "nothing is open";
    box.setContent(content(State::Current));
    EXPECT_FALSE(box.isHidden());
    EXPECT_TRUE(box.text().contains(
        QStringLiteral("Wall time: %1 (%2 to %3)").arg(shownDuration(52), shownDuration(45), shownDuration(62))))
        << box.text().toStdString();
    // No more digits than an interval of 4.5 FPS to either side deserves.
    EXPECT_TRUE(box.text().contains(QStringLiteral("Live rate: 21\u00A0FPS (17 to 26\u00A0FPS)"))) << box.text().toStdString();
}

TEST(PredictionBox, SaysOnceWhyFiguresAreNotKnown) {
    PredictionBox box;
    box.setContent(content(State::Current));
    EXPECT_EQ(box.text().count(QStringLiteral("2 earlier points")), 1) << box.text().toStdString();
    EXPECT_TRUE(box.text().contains(QStringLiteral("mass map difference, footprint overlap")));
    QSignalSpy asked(&box, &PredictionBox::helpRequested);
    for (QLabel* label : box.findChildren<QLabel*>()) {
        if (label->text().contains(QStringLiteral("href"))) {
            emit label->linkActivated(QStringLiteral("help"));
        }
    }
    EXPECT_EQ(asked.count(), 1);
}

TEST(PredictionBox, PutsMeasurementBesidePredictionAfterARun) {
    PredictionBox box;
    PredictionContent after = content(State::Afterwards);
    after.figures[0].measured = 58.0;
    after.figures[1].measured = 30.0;
    box.setContent(after);
    EXPECT_TRUE(box.text().contains(
        QStringLiteral("Wall time: %1 (said: %2 to %3 – held)").arg(shownDuration(58), shownDuration(45), shownDuration(62))))
        << box.text().toStdString();
    EXPECT_TRUE(box.text().contains(QStringLiteral("– missed"))) << box.text().toStdString();
    EXPECT_FALSE(box.text().contains(QStringLiteral("Not known")));
    after.figures[1].measured.reset();
    box.setContent(after);
    EXPECT_TRUE(box.text().contains(QStringLiteral("not measured"))) << box.text().toStdString();
}

TEST(PredictionBox, WhatReadsAsAnEndOfItsIntervalIsHeld) {
    PredictionBox box;
    PredictionContent after = content(State::Afterwards);
    after.figures[0].measured = after.figures[0].prediction.high + 0.3;
    after.figures.resize(1);
    box.setContent(after);
    EXPECT_TRUE(box.text().contains(QStringLiteral("– held"))) << box.text().toStdString();
    after.figures[0].measured = after.figures[0].prediction.high + 1.2;
    box.setContent(after);
    EXPECT_TRUE(box.text().contains(QStringLiteral("– missed"))) << box.text().toStdString();
}

TEST(PredictionBox, FiguresDeserveTheirDigits) {
    EXPECT_EQ(shownPredicted(Predicted::FootprintIou, 0.93257, 0.021), QStringLiteral("0.93"));
    EXPECT_EQ(shownPredicted(Predicted::MassMap, 0.11712, 0.0042), QStringLiteral("0.117"));
    EXPECT_EQ(shownPredicted(Predicted::Fps, 21.34, 0.6), QStringLiteral("21.3\u00A0FPS"));
    EXPECT_EQ(shownPredicted(Predicted::WallSeconds, 3.21, 0.4), QStringLiteral("3.2\u00A0s"));
    EXPECT_EQ(shownPredicted(Predicted::HeightRms, 0.4, std::nan("")), QStringLiteral("0.400\u00A0m"));
}

TEST(PredictionBox, StandsInAPanel) {
    RunPanel panel;
    ASSERT_NE(panel.prediction(), nullptr);
    QSignalSpy help(&panel, &Panel::predictionHelpRequested);
    panel.setPrediction(content(State::Current));
    emit panel.prediction()->helpRequested();
    EXPECT_EQ(help.count(), 1);
}

}  // namespace rubble::widgets
