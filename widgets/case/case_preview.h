#pragma once

#include <QWidget>

#include "widgets/views/playback_clock.h"
#include "widgets/views/timeline.h"
#include "widgets/views/view_widget.h"

class QLabel;
class QToolButton;

namespace rubble::widgets {

/// One view of an FE result with a timeline of its own: what dies when, before there is a case.
class CasePreview : public QWidget {
    Q_OBJECT

public:
    explicit CasePreview(QWidget* parent = nullptr);

    ViewWidget& views() { return *m_views; }
    PlaybackClock& clock() { return m_clock; }
    Timeline& timeline() { return *m_timeline; }
    /// Another result or another stage of it; the camera is set for a result that was not there before.
    void setData(const render::SceneData& scene);
    /// Marks the elements of some components.
    void mark(const std::vector<std::string>& components);
    /// Dead elements as fragments at their birth place, or as gaps.
    void setFragmentsShown(bool shown);

protected:
    void changeEvent(QEvent* event) override;

private:
    void followTheme();
    void step(int states);
    void showTime();

    PlaybackClock m_clock;
    ViewWidget* m_views;
    Timeline* m_timeline;
    QToolButton* m_back;
    QToolButton* m_play;
    QToolButton* m_forward;
    QLabel* m_time;
};

}  // namespace rubble::widgets
