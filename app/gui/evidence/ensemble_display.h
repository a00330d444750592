#pragma once

#include <QObject>
#include <memory>
#include <optional>

#include "app/gui/studies/answer.h"
#include "app/gui/studies/cluster_work.h"
#include "app/gui/studies/study_work.h"
#include "core/base/hash.h"
#include "core/fe/orthophoto.h"

namespace rubble {

class Computation;
class Document;
class Session;
namespace widgets {
class EnsemblePage;
class EnsemblePanel;
}  // namespace widgets

/// The ensemble of the case as far as it is made, whoever shows it.
class EnsembleKept : public QObject {
    Q_OBJECT

public:
    EnsembleKept();

    Answer<Digest, MadeEnsemble> answer;   ///< ordered by what it is made from
    std::shared_ptr<const DebrisMap> map;  ///< of its members that are done; null: none are
    const void* fe = nullptr;              ///< of the result that it was made of
    int generation = 0;                    ///< what a cluster made for an older start is not taken
    // What panel and page were set to when a window went.
    SurfaceSettings surface;
    DebrisInstant instant = DebrisInstant::AtRest;
    std::optional<MapLayer> layer;
    bool onGround = false;
    bool onCluster = false;
    // Last, so that it has ended before anything it uses goes.
    ClusterWork cluster;

signals:
    /// More members are there.
    void grew(const rubble::MadeEnsemble& made);
};

/// Brings the ensemble of the case together with its panel and its page in the centre. What it varies is kept in the case; every
/// edit of that is an undoable command.
class EnsembleDisplay : public QObject {
    Q_OBJECT

public:
    EnsembleDisplay(Session& session, widgets::EnsemblePanel& panel, widgets::EnsemblePage& page, QObject* parent = nullptr);

    ~EnsembleDisplay() override;

    /// What the panel asks for, of the case as it is.
    StudyOrder order() const;
    StudyCase openCase() const;
    void simulate();
    /// Members are made on a cluster.
    ClusterWork& cluster() { return m_kept.cluster; }
    /// Other work runs beside which nothing can be simulated; empty: none does.
    void setBusy(const QString& why);
    void refresh();
    /// The ensemble as far as it is made; its report is null if there is none.
    const MadeEnsemble& made() const;
    /// Whether it is of the case as it is now.
    bool stale() const;
    /// What is to lie on the ground of the views; null: nothing.
    const std::shared_ptr<const Orthophoto>& groundPicture() const { return m_ground; }
    /// Writes the map that is shown: GeoTIFF or CSV with all layers, PNG of the layer shown.
    void saveMapTo(const QString& path);
    void saveTableTo(const QString& path);

signals:
    /// Another map is to lie on the ground of the views, or none.
    void groundChanged();

private:
    /// The ensemble for a cluster. @param submits  false: only what was submitted earlier is gone on with
    ClusterWork::Study onCluster(bool submits);
    void cancel();
    bool running() const { return m_work.simulating() || m_kept.cluster.running(); }
    void take(const MadeEnsemble& made);
    void ended(const Failure* failure);
    void showPanel();
    void showPage();
    void showGround();
    void showFailure();
    void saveMap();
    void saveTable();
    /// Names what an ensemble would be made from now.
    Digest keyNow() const;

    Session& m_session;
    Document& m_document;
    Computation& m_computation;
    StudyWork& m_work;
    widgets::EnsemblePanel& m_panel;
    widgets::EnsemblePage& m_page;
    EnsembleKept& m_kept;
    std::shared_ptr<const Orthophoto> m_ground;
    bool m_simulating = false;  // a run, as the panel was last told
    QString m_busy;
};

}  // namespace rubble
