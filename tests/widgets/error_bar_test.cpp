#include "widgets/accuracy/error_bar.h"

#include <gtest/gtest.h>

#include <QPushButton>
#include <QSignalSpy>

namespace rubble::widgets {

TEST(ErrorBar, SaysWhatIsMissingAndHowToGetIt) {
    ErrorBar bar;
    auto* compute = bar.findChild<QPushButton*>(QStringLiteral("computeReference"));
    auto* cancel = bar.findChild<QPushButton*>(QStringLiteral("cancelReference"));
    EXPECT_TRUE(bar.text().contains(QStringLiteral("simulate first")));
    EXPECT_TRUE(compute->isHidden());
    bar.setState(ErrorBar::State::NoReference);
    EXPECT_TRUE(bar.text().contains(QStringLiteral("no reference")));
    QSignalSpy asked(&bar, &ErrorBar::computeRequested);
    compute->click();
    EXPECT_EQ(asked.count(), 1);
    bar.setState(ErrorBar::State::Computing);
    EXPECT_TRUE(compute->isHidden());
    EXPECT_FALSE(cancel->isHidden());
    bar.setProgress(0.3, 125.0);
    EXPECT_TRUE(bar.text().contains(QStringLiteral("left")));
    bar.setState(ErrorBar::State::Waiting, QStringLiteral("A run is being simulated."));
    EXPECT_FALSE(compute->isEnabled());
    EXPECT_TRUE(bar.text().contains(QStringLiteral("A run is being simulated.")));
    bar.setState(ErrorBar::State::Failed, QStringLiteral("The disk is full."));
    EXPECT_TRUE(bar.text().contains(QStringLiteral("The disk is full.")));
    EXPECT_TRUE(compute->isEnabled()) << "it may be tried again";
    bar.setState(ErrorBar::State::Shown);
    EXPECT_TRUE(compute->isHidden());
}

}  // namespace rubble::widgets
