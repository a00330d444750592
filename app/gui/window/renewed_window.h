#pragma once

#include <QObject>
#include <QTimer>
#include <memory>

namespace rubble {

class MainWindow;
class Session;

/// The main window of a session. When another language or other units are to be shown, a new window takes its place: the session,
/// with all that runs, goes on meanwhile.
class RenewedWindow : public QObject {
    Q_OBJECT

public:
    explicit RenewedWindow(Session& session, QObject* parent = nullptr);
    ~RenewedWindow() override;

    /// The window of now; renewed() tells when it is another.
    MainWindow& window() { return *m_window; }
    /// Makes the window anew in a language: "system" or one of widgets::languageCodes(). Windows that belong to it close.
    void speak(const QString& language);

signals:
    void renewed();

private:
    void preferencesChanged();
    /// A dialog that waits for an answer, or a wizard, is not taken away.
    bool mayGo() const;

    Session& m_session;
    std::unique_ptr<MainWindow> m_window;
    QString m_language;  // that was chosen and is not spoken yet
    QTimer m_wait;
};

}  // namespace rubble
