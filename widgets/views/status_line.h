#pragma once

#include <QWidget>
#include <array>

class QLabel;
class QProgressBar;
class QPushButton;

namespace rubble::widgets {

/// The line at the foot of the window: what runs and how long it still takes, then named figures. A figure without a value is not
/// shown.
class StatusLine : public QWidget {
    Q_OBJECT

public:
    enum class Figure { Live, Playback, Bodies, Step, Energy, Health, Findings, Memory };

    explicit StatusLine(QWidget* parent = nullptr);

    /// What runs, in words; fraction < 0 for unknown; empty text when nothing runs.
    void setActivity(const QString& what, double fraction = -1.0);
    /// A quiet sentence when nothing runs.
    void setMessage(const QString& message);
    /// @param name   "Live"; @param value  "24.6 FPS"; @param aside  muted: "target 24"; an empty value hides the figure
    /// @param warns  in the colour of findings
    void setFigure(Figure figure, const QString& name, const QString& value, const QString& aside = {}, bool warns = false);
    /// The tooltip of a figure.
    void setFigureTip(Figure figure, const QString& tip);
    QString figureText(Figure figure) const;
    QString activityText() const;
    /// What it says never makes the window wider: figures that can be missed go where there is no room.
    QSize minimumSizeHint() const override;

protected:
    void resizeEvent(QResizeEvent* event) override;

signals:
    void cancelRequested();
    /// A figure that leads somewhere, Health or Findings, was clicked.
    void figureChosen(rubble::widgets::StatusLine::Figure figure);

private:
    void makeRoom();

    QLabel* m_activity;
    QProgressBar* m_progress;
    QPushButton* m_cancel;
    QString m_message;
    bool m_running = false;
    std::array<QLabel*, 8> m_figures{};
    std::array<bool, 8> m_wanted{};  ///< the figure has a value
};

}  // namespace rubble::widgets
