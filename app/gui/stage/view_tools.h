#pragma once

#include <QObject>
#include <functional>

#include "app/gui/stage/actions.h"
#include "widgets/render/basics/view.h"

namespace rubble {

class ViewArea;

/// The actions that change how the views look at the model: projection, standard directions, cut, measuring, marks and style.
class ViewTools : public QObject {
    Q_OBJECT

public:
    ViewTools(Actions& actions, ViewArea& area, QObject* parent = nullptr);

    /// Another view or another model is shown: brings actions and bar up to it.
    void refresh();

private:
    void connectCameras();
    void connectStyle();
    void connectTools();
    void change(const std::function<void(render::View&)>& edit);
    void setClip(bool on);

    Actions& m_actions;
    ViewArea& m_area;
};

}  // namespace rubble
