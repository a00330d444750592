#pragma once

#include <QDialog>
#include <QString>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/base/finding.h"
#include "core/scenario/site.h"

class QCheckBox;
class QLabel;
class QLineEdit;
class QPushButton;
class QTableWidget;

namespace rubble::widgets {

class NumberField;
class Notice;

/// A mesh of the surroundings, and what is added to its coordinates.
struct SiteMeshOffset {
    QString mesh;                ///< for people
    std::optional<Vec3> offset;  ///< m; unset: as a file beside it says
};

/// How the case lies in the world: its coordinate system, control points with their residuals, the shift of heights, and the
/// offsets of the surroundings and whether debris falls on them. Nothing changes before it is accepted.
class SiteDialog : public QDialog {
    Q_OBJECT

public:
    explicit SiteDialog(QWidget* parent = nullptr);

    /// @param surroundings  meshes that the case has
    void setContent(const Site& site, const QString& crs, const std::vector<SiteMeshOffset>& surroundings = {});
    /// What finds out whether a place in a coordinate system can be right; without it only the control points are looked at.
    void setCheck(std::function<Findings(const Site&, const std::string&)> check);
    /// What was found when the terrain of the case was read: how it was laid on cells, and how its holes were filled.
    void setTerrain(const Findings& findings);
    /// What the fields say.
    Site site() const { return m_site; }
    QString crs() const;
    const std::vector<SiteMeshOffset>& surroundings() const { return m_meshes; }

private:
    void takeClasses();
    void showClasses();
    void buildTable();
    void buildOffsets();
    void fillOffsets();
    void takeOffset(int row, int column);
    void showFindings(std::size_t used);
    void addPoint();
    void removePoint();
    void fill();
    void take(int row, int column);
    void showFit();

    Site m_site;
    std::vector<SiteMeshOffset> m_meshes;
    std::function<Findings(const Site&, const std::string&)> m_check;
    bool m_filling = false;
    QLineEdit* m_crs;
    NumberField* m_shift;
    QCheckBox* m_collide;
    QLineEdit* m_classes;
    QLabel* m_terrain;
    QTableWidget* m_table;
    QTableWidget* m_offsets;
    QPushButton* m_add;
    QPushButton* m_remove;
    QLabel* m_fit;
    Notice* m_notice;
};

}  // namespace rubble::widgets
