#pragma once

#include <QDialog>
#include <QObject>
#include <optional>

#include "app/gui/accuracy/calibration_work.h"

class QWidget;

namespace rubble {

class Document;
class PanelDeck;
class Session;
namespace widgets {
class CalibrationView;
}

/// The window that shows what this machine carries and calibrates it; the Basic Grid panel takes its advice from there.
class CalibrationDisplay : public QObject {
    Q_OBJECT

public:
    /// @param window  that the calibration's own window belongs to
    CalibrationDisplay(Session& session, PanelDeck& deck, QWidget& window, QObject* parent = nullptr);

    ~CalibrationDisplay() override;

    CalibrationWork& work() { return m_work; }
    widgets::CalibrationView& view() { return *m_view; }
    /// Opens the window.
    void open();
    bool opened() const { return m_dialog->isVisible(); }
    /// Other work that would spoil what is measured runs; empty: none does.
    void setBusy(const QString& why);
    void refresh();

signals:
    /// A calibration began or ended.
    void changed();

private:
    /// What outlives the window.
    struct Kept {
        const Calibration* before = nullptr;  ///< what there was when measuring began
        double target = 0.0;                  ///< frames per second that the curves are marked for
        std::optional<Failure> failure;
        bool open = false;  ///< its window was open when the main window went
    };
    void calibrate();
    void ended(const Failure* failure);
    void targetChanged();
    void showFailure();

    Session& m_session;
    Document& m_document;
    PanelDeck& m_deck;
    CalibrationWork& m_work;
    Kept& m_kept;
    QDialog* m_dialog;
    widgets::CalibrationView* m_view;
    QString m_busy;
};

}  // namespace rubble
