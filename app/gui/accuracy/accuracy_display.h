#pragma once

#include <QObject>
#include <optional>

#include "app/gui/accuracy/accuracy_work.h"

namespace rubble {

class Computation;
class Document;
class Session;
class PanelDeck;
namespace widgets {
class AccuracyPage;
}

/// Brings the comparison of settings together with its panel, its page in the centre, the rail and the case: a point that is chosen
/// becomes an undoable edit of the scenario.
class AccuracyDisplay : public QObject {
    Q_OBJECT

public:
    AccuracyDisplay(Session& session, PanelDeck& deck, widgets::AccuracyPage& page, QObject* parent = nullptr);

    ~AccuracyDisplay() override;

    AccuracyWork& work() { return m_work; }
    /// Starts a comparison as soon as the case is prepared.
    void compareWhenReady();
    bool waiting() const { return m_kept.compareWhenReady; }
    /// Starts what the panel asks for.
    void compare();
    /// The scenario of a row becomes that of the case.
    void adopt(int row);
    /// Other work runs beside which nothing can be timed; empty: none does.
    void setBusy(const QString& why);
    /// Shows what is known now.
    void refresh();

signals:
    /// A comparison began or ended.
    void changed();

private:
    /// What outlives the window.
    struct Kept {
        const void* fe = nullptr;  ///< of the result that was compared
        double fraction = 0.0;
        bool compareWhenReady = false;
        std::optional<Failure> failure;
        std::optional<widgets::AccuracyPanel::Request> asked;  ///< what the panel asked for when a window went
    };
    void prepared();
    void cancel();
    void ended(const Failure* failure);
    void showPanel();
    void showOutcome();
    void showRail();
    /// The row whose setting is that of the case.
    std::optional<int> rowInUse() const;
    /// The case has changed so that other points would come out.
    bool stale() const;

    Session& m_session;
    Document& m_document;
    Computation& m_computation;
    PanelDeck& m_deck;
    widgets::AccuracyPage& m_page;
    AccuracyWork& m_work;
    Kept& m_kept;
    QString m_busy;
};

}  // namespace rubble
