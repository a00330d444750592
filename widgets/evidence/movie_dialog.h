#pragma once

#include <QDialog>
#include <QSize>

#include "widgets/figures/movie.h"

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QSpinBox;

namespace rubble::widgets {

class Notice;

/// What a movie is to be.
struct MovieChoice {
    figures::MovieSettings settings;
    QSize pixels{1280, 720};
    bool encoded = true;  ///< an MP4, else a folder of pictures
};

/// Asks for span, pace and size of a movie, and says how long it gets.
class MovieDialog : public QDialog {
    Q_OBJECT

public:
    /// @param choice  its span is all that can be shown, of which a brief FE result is offered; its cameras are those that can be
    /// looked along
    /// @param encoder  whether an MP4 can be made on this machine
    MovieDialog(const MovieChoice& choice, bool encoder, QWidget* parent = nullptr);

    MovieChoice choice() const;
    /// Of the run: they stand below the picture and in an amber line here. @param cautions  as cautionWords()
    void setCautions(const QString& cautions);

private:
    void showLength();

    QDoubleSpinBox* m_from;
    QDoubleSpinBox* m_to;
    QComboBox* m_pace;
    QSpinBox* m_fps;
    QComboBox* m_size;
    QComboBox* m_format;
    QCheckBox* m_along;
    std::vector<CameraKey> m_cameras;
    QLabel* m_length;
    Notice* m_cautions;
    double m_first;  ///< s, of all that can be shown
    double m_last;   ///< s
};

}  // namespace rubble::widgets
