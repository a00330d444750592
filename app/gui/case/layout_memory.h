#pragma once

#include <QByteArray>
#include <QString>

class QMainWindow;
class QSplitter;

namespace rubble {

/// Keeps where things stand in the window from one start to the next: its place, docks and the panel's width.
class LayoutMemory {
public:
    /// Takes how they stand now for the layout that reset() goes back to.
    /// @param docks  the area with docks inside the window
    LayoutMemory(QMainWindow& window, QMainWindow& docks, QSplitter& splitter);

    /// How things stand.
    struct Layout {
        QByteArray window;  ///< place and size
        QByteArray bars;
        QByteArray docks;
        QByteArray splitter;
    };
    Layout now() const;
    void show(const Layout& layout);
    /// As it was left; what makes no sense (another screen, a damaged setting) is left as it is.
    void restore();
    void save() const;
    /// Back to the layout of the first start, and forgets what was kept.
    void reset();

private:
    QMainWindow& m_window;
    QMainWindow& m_docks;
    QSplitter& m_splitter;
    QByteArray m_firstState;
    QByteArray m_firstDocks;
    QByteArray m_firstSplitter;
};

/// Moves a settings file that cannot be read aside, so that the program starts with its defaults. Gives where it is now, empty if
/// nothing was wrong. Call it before the first setting is read.
QString setDamagedSettingsAside();

}  // namespace rubble
