#include "app/gui/accuracy/grid_count.h"

#include "core/clusters/grid_sizer.h"

namespace rubble {

/// What counts stand on; the sizer is used by the worker alone, and made when it is first asked for.
struct GridCount::Scene {
    std::shared_ptr<const FeResult> fe;
    std::shared_ptr<const FragmentSet> fragments;
    std::shared_ptr<const Components> components;
    std::unique_ptr<GridSizer> sizer;

    Sizing size(const GridSettings& settings, const Execution& execution) {
        if (sizer == nullptr) {
            sizer = std::make_unique<GridSizer>(*fragments, fe->mesh(), *components);
        }
        return sizer->size(settings, execution);
    }
};

GridCount::GridCount(QObject* parent) : QObject(parent) {}

void GridCount::setScene(std::shared_ptr<const FeResult> fe, std::shared_ptr<const FragmentSet> fragments,
                         std::shared_ptr<const Components> components) {
    if (fe == nullptr || fragments == nullptr || components == nullptr || fragments->list.empty()) {
        m_scene.reset();
        return;
    }
    if (m_scene != nullptr && m_scene->fe == fe && m_scene->fragments == fragments && m_scene->components == components) {
        return;
    }
    m_scene = std::make_shared<Scene>();
    m_scene->fe = std::move(fe);
    m_scene->fragments = std::move(fragments);
    m_scene->components = std::move(components);
}

void GridCount::count(const GridSettings& settings) {
    if (m_scene == nullptr) {
        return;
    }
    auto made = std::make_shared<std::shared_ptr<const Sizing>>();
    m_worker.startNext({Worker::Kind::Update,
                        [scene = m_scene, settings, made](const Execution& execution) {
                            *made = std::make_shared<const Sizing>(scene->size(settings, execution));
                        },
                        [this, scene = m_scene, settings, made](const std::exception_ptr&) {
                            if (*made != nullptr && scene == m_scene) {
                                emit counted(settings, *made);
                            }
                        }});
}

void GridCount::countPublished(const GridSettings& settings) {
    if (m_scene == nullptr) {
        return;
    }
    auto made = std::make_shared<std::vector<widgets::GridPanel::PublishedCount>>();
    m_worker.startNext({Worker::Kind::Study,
                        [scene = m_scene, settings, made](const Execution& execution) {
                            GridSettings published = settings;
                            published.oneBodyPerFragment = false;
                            published.length = published.width = published.height = std::nullopt;
                            for (const double multiple : widgets::GridPanel::publishedMultiples) {
                                published.multiple = multiple;
                                made->push_back({multiple, scene->size(published, execution).clusters});
                            }
                        },
                        [this, scene = m_scene, made](const std::exception_ptr& thrown) {
                            if (thrown == nullptr && scene == m_scene) {
                                emit publishedCounted(*made);
                            }
                        }});
}

}  // namespace rubble
