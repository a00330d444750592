#pragma once

#include <QObject>
#include <functional>
#include <optional>

#include "app/gui/camera_overlay.h"
#include "app/gui/evidence_work.h"

namespace rubble {

class Computation;
class Document;
class PanelDeck;
struct PhotographsEdit;
class Playback;
namespace widgets {
class EvidencePage;
}

/// Brings the photographs of the case together with their panel, their page in the centre and the run: matches the camera as soon
/// as a point changes, shows the simulation from there at the time of the clock, and compares. Every edit is an undoable command.
class EvidenceDisplay : public QObject {
    Q_OBJECT

public:
    /// @param scene  what the views show
    EvidenceDisplay(Document& document, Computation& computation, PanelDeck& deck, widgets::EvidencePage& page, Playback& playback,
                    std::function<render::SceneData()> scene, QObject* parent = nullptr);
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
    int chosen() const { return m_chosen; }
    const std::optional<CameraMatch>& match() const { return m_match; }
    const std::shared_ptr<const PhotoComparison>& comparison() const { return m_comparison; }
    /// The place of a point in the model that belongs to the one clicked in the photograph, or the other way round.
    void placePicture(const QPointF& pixel);
    void placeModel(const Vec3& point, const QString& name);
    /// Everything is shown anew, as after another theme.
    void refresh();
    /// Asks for the fragment view to look as the camera does.
    void lookThrough();
    /// Nothing of what is shown is still being made.
    bool settled() const { return !m_work.busy() && m_overlay.settled(); }

signals:
    void told(const QString& what);
    /// The fragment view is to look as the matched camera does.
    void lookThroughRequested(const rubble::render::Camera& camera);

private:
    const Photograph* current() const;
    QString pathOf(const Photograph& photograph) const;
    void connectPanel();
    void connectPage();
    void takeFound(const FoundPhotos& found);
    void takeLoaded(const LoadedPhoto& photo);
    void edit(const Photograph& after, const QString& what);
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
    bool comparisonStale() const;
    QString whyNoComparison() const;

    Document& m_document;
    Computation& m_computation;
    PanelDeck& m_deck;
    widgets::EvidencePage& m_page;
    Playback& m_playback;
    std::function<render::SceneData()> m_scene;
    int m_chosen = -1;
    int m_chosenPair = -1;
    int m_chosenMask = -1;
    LoadedPhoto m_photo;
    QString m_loading;  // path that is being read
    std::optional<CameraMatch> m_match;
    std::optional<Failure> m_noMatch;
    std::vector<PointPair> m_matchedPairs;
    CameraKnowledge m_matchedKnowing;
    std::shared_ptr<const PhotoComparison> m_comparison;
    Photograph m_comparedPhoto;
    const void* m_comparedRun = nullptr;
    bool m_comparedFallen = true;
    QString m_complaint;
    std::optional<QPointF> m_pendingPixel;
    std::optional<Vec3> m_pendingModel;
    QString m_pendingName;
    render::SceneData m_modelScene;
    EvidenceWork m_work;
    CameraOverlay m_overlay;
};

}  // namespace rubble
