#pragma once

#include <QObject>
#include <memory>

#include "app/gui/session/worker.h"
#include "core/clusters/sizing.h"
#include "core/fe/fe_result.h"
#include "widgets/accuracy/grid_panel.h"

namespace rubble {

/// Counts clusters for the place of a slider, on a worker of its own: what no grid changes is kept between counts. A count that is
/// asked for while one runs waits for it; of those that wait only the newest is made.
class GridCount : public QObject {
    Q_OBJECT

public:
    explicit GridCount(QObject* parent = nullptr);

    /// What is counted from now on; null parts: nothing.
    void setScene(std::shared_ptr<const FeResult> fe, std::shared_ptr<const FragmentSet> fragments,
                  std::shared_ptr<const Components> components);
    bool ready() const { return m_scene != nullptr; }
    /// Answers with counted().
    void count(const GridSettings& settings);
    /// Counts at the published multiples; answers with publishedCounted().
    void countPublished(const GridSettings& settings);

signals:
    void counted(const rubble::GridSettings& settings, std::shared_ptr<const rubble::Sizing> sizing);
    void publishedCounted(const std::vector<rubble::widgets::GridPanel::PublishedCount>& counts);

private:
    struct Scene;
    std::shared_ptr<Scene> m_scene;
    // Last, so that it has ended before anything it uses goes.
    Worker m_worker;
};

}  // namespace rubble
