#pragma once

#include <QDialog>
#include <QObject>
#include <optional>

#include "app/gui/evidence/validation_work.h"

class QWidget;

namespace rubble {

class Actions;
class Session;
namespace widgets {
class ValidationView;
}

/// The window that shows how far simulated falls are from measured ones, and simulates them.
class ValidationDisplay : public QObject {
    Q_OBJECT

public:
    /// @param window  that its own window belongs to
    ValidationDisplay(Session& session, Actions& actions, QWidget& window, QObject* parent = nullptr);
    ~ValidationDisplay() override;

    ValidationWork& work() { return m_work; }
    widgets::ValidationView& view() { return *m_view; }
    void open();
    bool opened() const { return m_dialog->isVisible(); }
    /// Other work that would spoil what is measured runs; empty: none does.
    void setBusy(const QString& why) { m_busy = why; }

signals:
    /// A validation began or ended.
    void changed();

private:
    /// What outlives the window.
    struct Kept {
        bool open = false;  ///< its window was open when the main window went
        std::optional<Failure> failure;
    };
    void start();
    void ended(const Failure* failure);
    void refresh();

    Session& m_session;
    ValidationWork& m_work;
    Kept& m_kept;
    QDialog* m_dialog;
    widgets::ValidationView* m_view;
    QString m_busy;
};

}  // namespace rubble
