#pragma once

#include <QStackedWidget>

#include "widgets/panel.h"
#include "widgets/view_widget.h"

namespace rubble {

namespace widgets {
class ErrorBar;
}

/// The centre of the window: the views, or what would be here and how to get it.
class ViewArea : public QStackedWidget {
    Q_OBJECT

public:
    explicit ViewArea(QWidget* parent = nullptr);

    widgets::ViewWidget& views() { return *m_views; }
    /// Stands above the views while fragments are coloured by their error.
    widgets::ErrorBar& errorBar() { return *m_errorBar; }
    void showViews(bool show);
    /// An error in place of the views; an empty text removes it.
    void setError(const QString& what, const QString& remedy = {});
    /// "Opening ..." while a file is read.
    void setActivity(const QString& what);

signals:
    void openRequested();
    void sampleRequested();

private:
    QWidget* buildEmpty();

    widgets::ViewWidget* m_views;
    widgets::ErrorBar* m_errorBar;
    widgets::Notice* m_error;
    QLabel* m_activity;
};

}  // namespace rubble
