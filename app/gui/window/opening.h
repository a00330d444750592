#pragma once

#include <QObject>
#include <QPointer>
#include <memory>

#include "app/gui/session/computation.h"
#include "widgets/render/basics/view.h"

class QWidget;

namespace rubble {

class Actions;
class Document;
class FigureReturn;
class FileCommands;
class HealthDisplay;
class Inspection;
struct LeftWork;
class NewCase;
class PanelDeck;
class Playback;
class SceneDisplay;
class Session;
class ViewArea;

/// What comes into the window and leaves it: files that are opened, the sample, what was left unsaved, cases that the wizard makes.
class Opening : public QObject {
    Q_OBJECT

public:
    /// Rooms of the window that show what was opened.
    struct Shown {
        PanelDeck& deck;
        ViewArea& area;
        Playback& playback;
        SceneDisplay& scene;
        HealthDisplay& health;
        Inspection& inspection;
        FileCommands& files;
    };
    Opening(Session& session, const Shown& shown, Actions& actions, QWidget& window);
    ~Opening() override;

    /// Opens a case, an FE result, a run, a figure or a sealed bundle; with `simulate`, simulates it as soon as it is prepared.
    void open(const QString& path, bool simulate = false);
    void openSample();
    /// Makes a new case by the wizard, from a file that is asked for if none is named. What is open stays until the case is made.
    void newCase(const QString& path = {});
    /// The case that is being made; null if none is.
    NewCase* caseInTheMaking() const;
    /// Opens what an earlier session left unsaved.
    void recover(const LeftWork& work);
    /// Reads the FE result again if files of it have grown or come; scenario, time and camera stay.
    void refreshResult();
    /// Nothing is simulated by itself any more.
    void stayStill();

signals:
    /// What was opened to be simulated is prepared.
    void simulateRequested();
    /// A sealed bundle was chosen: it is checked before anything of it opens.
    void sealedChosen(const QString& bundle);
    /// A run file was chosen: its case opens first.
    void runChosen(const QString& run);
    /// What is open, or how it stands, has changed.
    void changed();

private:
    /// What outlives the window.
    struct Kept {
        bool simulateWhenReady = false;
        bool askedToLeave = false;                  ///< the case has not been edited since somebody agreed to leave it for another
        std::shared_ptr<const FeResult> refreshed;  ///< what is being read again
    };
    void connectActions(Actions& actions);
    void connectSession();
    /// Opens a file that is no figure; false if what is open was not to be left.
    bool load(const QString& path, bool simulate);
    void forgetFailures();
    void closeCase();
    Welcome welcomeFor(const Opened& opened);
    void takeOpened(const Opened& opened);
    void takeMade(const Opened& opened, const render::View& looks);
    void showRefreshed(const FeResult& before, const render::View& view, double time);
    void tellTimes();
    void scenarioChanged();
    void prepared();
    void reopen();

    Session& m_session;
    Document& m_document;
    Computation& m_computation;
    Shown m_shown;
    QWidget& m_window;
    FigureReturn& m_return;
    Kept& m_kept;
    QPointer<NewCase> m_newCase;
};

}  // namespace rubble
