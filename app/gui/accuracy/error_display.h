#pragma once

#include <QObject>

#include "app/gui/accuracy/reference_work.h"

namespace rubble {

class Computation;
class Session;
class ViewArea;

/// Brings the run that is shown together with its reference while fragments are coloured by their error.
class ErrorDisplay : public QObject {
    Q_OBJECT

public:
    ErrorDisplay(Session& session, ViewArea& area, QObject* parent = nullptr);

    ReferenceWork& work() { return m_work; }
    /// What views compare with; null: nothing.
    std::shared_ptr<const TrajectoryReader> reference() const;
    /// Fragments are coloured by their error, or no longer.
    void setShown(bool shown);
    /// Other work that a reference would spoil, or that would spoil its time, runs; empty: none does.
    void setBusy(const QString& why);
    /// The run or its state has changed.
    void refresh();

signals:
    /// There is another reference, or a computation of one began or ended.
    void changed();

private:
    /// What outlives the window.
    struct Kept {
        std::optional<Failure> failure;
    };
    void compute();
    void showBar();

    Session& m_session;
    Computation& m_computation;
    ViewArea& m_area;
    ReferenceWork& m_work;
    Kept& m_kept;
    bool m_shown = false;
    QString m_busy;
};

}  // namespace rubble
