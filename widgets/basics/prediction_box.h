#pragma once

#include <QWidget>
#include <array>
#include <optional>
#include <vector>

#include "core/analysis/accuracy/prediction.h"

class QGridLayout;
class QLabel;

namespace rubble::widgets {

/// What is said of one figure of a setting: before a run its prediction, after it what came of it.
struct PredictedFigure {
    Predicted what = Predicted::WallSeconds;
    Prediction prediction;           ///< not known: with the reason
    std::optional<double> measured;  ///< in the last run of this setting
};

/// What a setting will cost and how accurate it will be.
struct PredictionContent {
    enum class State : std::uint8_t {
        None,        ///< nothing is open
        Pending,     ///< being worked out for a setting that has just changed
        Current,     ///< of the setting as it stands
        Afterwards,  ///< of the last run, as said before it, beside what it came to
    };
    State state = State::None;
    std::int64_t bodies = 0;
    std::vector<PredictedFigure> figures;
};

/// The predicted wall time, live FPS and accuracy of a setting with their 80 % intervals, or why they are not known; one line each.
/// Stands in every panel with a costly control.
class PredictionBox : public QWidget {
    Q_OBJECT

public:
    explicit PredictionBox(QWidget* parent = nullptr);
    void setContent(const PredictionContent& content);
    /// All that it says, line by line: for tests and for reading aloud.
    QString text() const;

signals:
    /// The user wants figures where there are none: settings compared, or the machine calibrated.
    void helpRequested();

private:
    struct Line {
        QLabel* name;
        QLabel* value;
        QLabel* interval;
    };
    void showFigure(Line& line, const PredictedFigure& figure, PredictionContent::State state);
    void showReasons(const PredictionContent& content);

    QLabel* m_heading;
    std::array<Line, predictedCount> m_lines{};
    QLabel* m_reasons;
};

/// "wall time", "live FPS", "mass map difference", ...
QString predictedWords(Predicted what);
/// A value with no more digits than its interval deserves, with its unit. @param width  of the interval, half
QString shownPredicted(Predicted what, double value, double width);

}  // namespace rubble::widgets
