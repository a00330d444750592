#pragma once

#include <QObject>

class QComboBox;

namespace rubble {

class Actions;
struct WindowRooms;
class Session;

/// Which actions can be used, as the case, its run and the work on them stand.
class ActionStates : public QObject {
    Q_OBJECT

public:
    /// @param rooms   that are asked and told when something has changed
    /// @param colours chooses what the colour of a fragment says
    ActionStates(Session& session, WindowRooms& rooms, Actions& actions, QComboBox& colours, QObject* parent = nullptr);

    void refresh();
    /// What the colour of a fragment says is seen in the views alone.
    void offerColours();

private:
    void connectUndo();
    void nameUndo();

    Session& m_session;
    WindowRooms& m_rooms;
    Actions& m_actions;
    QComboBox& m_colours;
    QString m_coloursTip;
};

}  // namespace rubble
