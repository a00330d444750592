#pragma once

#include <QObject>
#include <QString>

namespace rubble {

class MainWindow;
class Session;
struct Options;
namespace widgets {
class Tour;
}

/// Shows somebody who sees the program for the first time what it is for: the sample is simulated and plays, and the tour says a
/// sentence at a time beside what it speaks of. Over a case that is open the tour speaks alone and leaves that as it is.
class FirstVisit : public QObject {
    Q_OBJECT

public:
    FirstVisit(MainWindow& window, widgets::Tour& tour);

    /// Nothing was ever opened here, no tour was ever closed, no work was left, and the command line asks for nothing.
    static bool isDue(Session& session, const Options& options);
    void begin();

private:
    void look();

    MainWindow& m_window;
    widgets::Tour& m_tour;
    QString m_awaited;  ///< the sample that is being opened for the tour; empty: none
};

}  // namespace rubble
