#pragma once

#include <QDialog>
#include <QImage>
#include <QSize>
#include <QTimer>
#include <optional>

#include "widgets/figures/figure_sheet.h"

class QCheckBox;
class QComboBox;
class QLabel;
class QSpinBox;

namespace rubble::widgets {

class Notice;

/// What a figure is to be.
struct FigureChoice {
    std::optional<figures::FigurePreset> preset;  ///< unset: as the views are
    QSize pixels{1600, 1000};                     ///< height 0: as what is shown needs
    int dpi = 200;
    bool selection = false;  ///< what is selected is shown in its colour

    friend bool operator==(const FigureChoice&, const FigureChoice&) = default;
};

/// Asks for arrangement and size of a figure, with a preview that follows.
class FigureDialog : public QDialog {
    Q_OBJECT

public:
    explicit FigureDialog(const FigureChoice& choice, QWidget* parent = nullptr);

    FigureChoice choice() const;
    /// Of the run: they stand below the picture and in an amber line here. @param cautions  as cautionWords()
    void setCautions(const QString& cautions);
    /// Shows how it will look; a null picture says why not.
    void setPreview(const QImage& picture, const QString& problem = {});

signals:
    /// The choice has changed and rests.
    void previewRequested(const rubble::widgets::FigureChoice& choice);

protected:
    void showEvent(QShowEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void fitPreview();
    void showSize();

    QComboBox* m_preset;
    QSpinBox* m_width;
    QSpinBox* m_height;
    QSpinBox* m_dpi;
    QCheckBox* m_selection;
    QLabel* m_print;
    Notice* m_cautions;
    QLabel* m_preview;
    QImage m_picture;  // that is previewed; null: none
    QTimer m_rest;
};

}  // namespace rubble::widgets
