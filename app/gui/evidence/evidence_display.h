#pragma once

#include <QObject>
#include <optional>

#include "app/gui/evidence/camera_overlay.h"
#include "app/gui/evidence/evidence_work.h"
#include "app/gui/studies/answer.h"
#include "widgets/evidence/photo_view.h"

namespace rubble {

class Actions;
class Computation;
class Document;
class Session;
class PanelDeck;
struct PhotographsEdit;
class Playback;
class SceneDisplay;
namespace widgets {
class EvidencePage;
}

/// Brings the photographs of the case together with their panel, their page in the centre and the run: matches the camera as soon
/// as a point changes, shows the simulation from there at the time of the clock, and compares. Every edit is an undoable command.
class EvidenceDisplay : public QObject {
    Q_OBJECT

public:
    EvidenceDisplay(Session& session, PanelDeck& deck, widgets::EvidencePage& page, Playback& playback, SceneDisplay& scene,
                    Actions& actions, QObject* parent = nullptr);
    ~EvidenceDisplay() override;

    EvidenceWork& work() { return m_work; }
    /// Whether files that are dropped are photographs and there is a case for them.
    bool takes(const QStringList& paths) const;
    void add(const QStringList& paths);
    void chooseFiles();
    void chooseTable();
    /// Pairs of a table are added to those of the photograph.
    void readPairs(const QString& path);
    void compare();
    void choose(int photograph);
    int chosen() const { return m_kept.chosen; }
    const std::optional<CameraMatch>& match() const { return m_kept.match; }
    const std::shared_ptr<const PhotoComparison>& comparison() const { return m_kept.answer.result(); }
    /// The place of a point in the model that belongs to the one clicked in the photograph, or the other way round.
    void placePicture(const QPointF& pixel);
    void placeModel(const Vec3& point, const QString& name);
    /// Everything is shown anew, as after another theme.
    void refresh();
    /// Asks for the fragment view to look as the camera does.
    void lookThrough();
    /// The comparison is of another run, or of other drawings.
    bool comparisonStale() const;
    /// Nothing of what is shown is still being made.
    bool settled() const { return !m_work.busy() && m_overlay.settled(); }

signals:
    /// What the panel shows has changed.
    void changed();
    /// The fragment view is to look as the matched camera does.
    void lookThroughRequested(const rubble::render::Camera& camera);

private:
    /// What the outline on a photograph is held against.
    struct Compared {
        Photograph photograph;  ///< without its note
        const void* run = nullptr;
        bool withFallen = true;
        bool operator==(const Compared&) const = default;
    };
    /// What outlives the window.
    struct Kept {
        int chosen = -1;
        int chosenPair = -1;
        int chosenMask = -1;
        LoadedPhoto photo;
        QString loading;  ///< path that is being read
        std::optional<CameraMatch> match;
        std::optional<Failure> noMatch;
        std::vector<PointPair> matchedPairs;
        CameraKnowledge matchedKnowing;
        Answer<Compared, PhotoComparison> answer;
        bool beside = false;  ///< what the page was set to when a window went
        widgets::PhotoView::Show show = widgets::PhotoView::Show::Photograph;
    };
    const Photograph* current() const;
    Compared comparedNow(const Photograph& photograph, const RunRecord& record) const;
    QString pathOf(const Photograph& photograph) const;
    void connectPanel();
    void connectPage();
    void connectActions(Actions& actions);
    void takeFound(const FoundPhotos& found);
    void takeLoaded(const LoadedPhoto& photo);
    void edit(const Photograph& after, const widgets::Wording& what);
    void put(const PhotographsEdit& edit);
    void remove();
    void photographsChanged();
    void loadCurrent();
    void matchCurrent();
    void toItsTime();
    void finishPair();
    void forgetPair();
    void showPanel();
    void showPage();
    void showRail();
    void drawLater();
    bool visible() const;
    QString whyNoComparison() const;

    Session& m_session;
    Document& m_document;
    Computation& m_computation;
    PanelDeck& m_deck;
    widgets::EvidencePage& m_page;
    Playback& m_playback;
    SceneDisplay& m_scene;
    EvidenceWork& m_work;
    Kept& m_kept;
    std::optional<QPointF> m_pendingPixel;
    std::optional<Vec3> m_pendingModel;
    QString m_pendingName;
    render::SceneData m_modelScene;
    CameraOverlay m_overlay;
};

}  // namespace rubble
