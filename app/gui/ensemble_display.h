#pragma once

#include <QObject>
#include <memory>

#include "app/gui/cluster_work.h"
#include "app/gui/study_work.h"
#include "core/base/hash.h"
#include "core/fe/orthophoto.h"

namespace rubble {

class Computation;
class Document;
namespace widgets {
class EnsemblePage;
class EnsemblePanel;
}  // namespace widgets

/// Brings the ensemble of the case together with its panel and its page in the centre. What it varies is kept in the case; every
/// edit of that is an undoable command.
class EnsembleDisplay : public QObject {
    Q_OBJECT

public:
    EnsembleDisplay(Document& document, Computation& computation, StudyWork& work, widgets::EnsemblePanel& panel,
                    widgets::EnsemblePage& page, QObject* parent = nullptr);

    /// What the panel asks for, of the case as it is.
    StudyOrder order() const;
    StudyCase openCase() const;
    void simulate();
    /// Members are made on a cluster.
    ClusterWork& cluster() { return m_cluster; }
    /// Other work runs beside which nothing can be simulated; empty: none does.
    void setBusy(const QString& why);
    void refresh();
    /// The ensemble as far as it is made; its report is null if there is none.
    const MadeEnsemble& made() const { return m_made; }
    /// Whether it is of the case as it is now.
    bool stale() const;
    /// What is to lie on the ground of the views; null: nothing.
    const std::shared_ptr<const Orthophoto>& groundPicture() const { return m_ground; }
    /// Writes the map that is shown: GeoTIFF or CSV with all layers, PNG of the layer shown.
    void saveMapTo(const QString& path);
    void saveTableTo(const QString& path);

signals:
    void told(const QString& what);
    void failed(const QString& what, const QString& remedy);
    /// Another map is to lie on the ground of the views, or none.
    void groundChanged();

private:
    /// The ensemble for a cluster. @param submits  false: only what was submitted earlier is gone on with
    ClusterWork::Study onCluster(bool submits);
    void cancel();
    bool running() const { return m_work.simulating() || m_cluster.running(); }
    void take(const MadeEnsemble& made);
    void ended(const Failure* failure);
    void showPanel();
    void showPage();
    void showGround();
    void saveMap();
    void saveTable();
    Digest keyNow() const;

    Document& m_document;
    Computation& m_computation;
    StudyWork& m_work;
    widgets::EnsemblePanel& m_panel;
    widgets::EnsemblePage& m_page;
    MadeEnsemble m_made;
    std::shared_ptr<const DebrisMap> m_map;
    std::shared_ptr<const Orthophoto> m_ground;
    const void* m_fe = nullptr;  // of the result that it was made of
    Digest m_key;                // of what it was made from
    Digest m_startedKey;
    bool m_simulating = false;  // a run, as the panel was last told
    QString m_busy;
    int m_generation = 0;  // what a cluster made for an older start is not taken
    // Last, so that it has ended before anything it uses goes.
    ClusterWork m_cluster;
};

}  // namespace rubble
