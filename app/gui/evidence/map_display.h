#pragma once

#include <QObject>
#include <QTimer>
#include <memory>
#include <optional>
#include <vector>

#include "app/gui/evidence/evidence_work.h"
#include "app/gui/session/worker.h"
#include "app/gui/studies/answer.h"
#include "core/evidence/maps/run_map.h"
#include "core/fe/orthophoto.h"
#include "core/scenario/case.h"
#include "io/exports/provenance.h"
#include "io/run/run_file.h"
#include "widgets/evidence/run_map_panel.h"

class QDockWidget;

namespace rubble {

class Actions;
class Computation;
class DockArea;
class Document;
class Playback;
class Session;

/// The map of the run at hand, whoever shows it.
class MapWork : public QObject {
    Q_OBJECT

public:
    /// What is mapped, and how.
    struct Order {
        const void* run = nullptr;
        std::size_t frames = 0;
        bool complete = false;
        std::optional<double> time;  ///< s; unset: the end
        std::optional<double> cell;  ///< m; unset: as usualMapCell()
        bool live = true;
        std::vector<CaseInput> surveys = {};
        bool operator==(const Order&) const = default;
    };
    struct Made {
        RunMap map;
        std::shared_ptr<const io::RunReader> run;
        std::vector<figures::MapOutline> outlines;
        std::vector<io::ShownFile> drawn;  ///< of evidence whose outline is among these
    };

    explicit MapWork(Session& session);

    /// Maps a run; answers with changed(). @param folder  that paths of surveys start from
    void start(const Order& order, const EvidenceRun& run, std::shared_ptr<const io::RunReader> reader, const Case& theCase,
               const Frame& frame, const std::string& base);

    /// Nothing is awaited or shown any more.
    void forget();

    Answer<Order, Made> answer;
    std::optional<Order> making;   ///< the latest that was asked for
    widgets::RunMapChoice choice;  ///< what was chosen when a window went

signals:
    void changed();

private:
    std::shared_ptr<Made> m_making;  // null: what is made is not awaited any more
    // Last, so that it has ended before anything it uses goes.
    Worker m_worker;
};

/// Shows the debris map of the run at hand in a dock beside the views, and lays it on their ground. Maps in the background, and
/// only while it is seen.
class MapDisplay : public QObject {
    Q_OBJECT

public:
    MapDisplay(Session& session, Playback& playback, DockArea& docks, Actions& actions, QObject* parent = nullptr);
    ~MapDisplay() override;

    widgets::RunMapPanel& panel() { return *m_panel; }
    QDockWidget& dock() { return *m_dock; }
    /// Null: nothing lies on the ground.
    const std::shared_ptr<const Orthophoto>& groundPicture() const { return m_ground; }
    /// Writes the map as GeoTIFF, GeoPackage, CSV or PNG, by the ending.
    void saveTo(const QString& path);
    void refresh();

signals:
    void groundChanged();

private:
    bool wanted() const;
    std::optional<MapWork::Order> orderNow() const;
    void show();
    void showGround();
    void save();

    Session& m_session;
    Document& m_document;
    Computation& m_computation;
    Playback& m_playback;
    MapWork& m_work;
    widgets::RunMapPanel* m_panel;
    QDockWidget* m_dock;
    QTimer m_rest;            ///< an instant is mapped once playback rests on it
    bool m_waitTold = false;  ///< the status line says that the map is awaited
    std::shared_ptr<const Orthophoto> m_ground;
};

}  // namespace rubble
