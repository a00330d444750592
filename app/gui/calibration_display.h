#pragma once

#include <QDialog>
#include <QObject>

#include "app/gui/calibration_work.h"

class QWidget;

namespace rubble {

class Document;
class PanelDeck;
namespace widgets {
class CalibrationView;
}

/// The window that shows what this machine carries and calibrates it; the Basic Grid panel takes its advice from there.
class CalibrationDisplay : public QObject {
    Q_OBJECT

public:
    /// @param window  that the calibration's own window belongs to
    CalibrationDisplay(Document& document, PanelDeck& deck, QWidget& window, QObject* parent = nullptr);

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
    void told(const QString& what);

private:
    void calibrate();
    void ended(const Failure* failure);
    void targetChanged();

    Document& m_document;
    PanelDeck& m_deck;
    CalibrationWork m_work;
    QDialog* m_dialog;
    widgets::CalibrationView* m_view;
    const Calibration* m_before = nullptr;  // what there was when measuring began
    QString m_busy;
    double m_target = 0.0;  // frames per second that the curves are marked for
};

}  // namespace rubble
