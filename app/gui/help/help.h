#pragma once

#include <QObject>
#include <QPointer>
#include <QString>

class QLabel;
class QWidget;

namespace rubble {

class ManualWindow;

/// A place of the manual: a page, a heading of it (empty: its beginning) and words to point at (empty: none).
struct HelpTopic {
    QString page;
    QString heading;
    QString words;

    friend bool operator==(const HelpTopic&, const HelpTopic&) = default;
};

/// What of the manual is about a widget: its parameter, the figure it shows, what its property "help" says ("Page#Heading"), or the
/// page of the part of the window that it stands in.
HelpTopic helpAbout(const QWidget* widget);

/// Leads from the window into the manual: F1 on what has the focus, and "What is this number?" on every figure of the panels.
class Help : public QObject {
    Q_OBJECT

public:
    /// @param window  figures in it get the entry of the context menu
    explicit Help(QWidget& window);

    void showAbout(const QWidget* widget);
    /// Opens the manual with the cursor where words to find are typed.
    void search();
    ManualWindow& manual();
    /// The title of the page that is open; empty: none is.
    QString openPage() const;

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    /// A dialog that blocks the window would block the manual as well, unless it is the dialog's own.
    void lendManual(QWidget* to);

    QWidget& m_window;
    QPointer<ManualWindow> m_manual;
};

}  // namespace rubble
