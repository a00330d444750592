#pragma once

#include <QDialog>
#include <QString>

#include "core/scenario/site.h"

class QCheckBox;
class QLabel;
class QLineEdit;
class QPushButton;
class QTableWidget;

namespace rubble::widgets {

class NumberField;
class Notice;

/// How the case lies in the world: its coordinate system, control points with their residuals, the shift of heights, and whether
/// debris falls on the surroundings. Nothing changes before it is accepted.
class SiteDialog : public QDialog {
    Q_OBJECT

public:
    explicit SiteDialog(QWidget* parent = nullptr);

    /// @param surroundings  meshes that the case has
    void setContent(const Site& site, const QString& crs, int surroundings);
    /// What the fields say.
    Site site() const { return m_site; }
    QString crs() const;

private:
    void buildTable();
    void addPoint();
    void removePoint();
    void fill();
    void take(int row, int column);
    void showFit();

    Site m_site;
    bool m_filling = false;
    QLineEdit* m_crs;
    NumberField* m_shift;
    QCheckBox* m_collide;
    QTableWidget* m_table;
    QPushButton* m_add;
    QPushButton* m_remove;
    QLabel* m_fit;
    Notice* m_notice;
};

}  // namespace rubble::widgets
