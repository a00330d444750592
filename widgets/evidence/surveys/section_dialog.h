#pragma once

#include <QDialog>
#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "core/base/finding.h"
#include "core/evidence/cautions.h"
#include "core/evidence/site_section.h"
#include "widgets/figures/report/section_picture.h"

class QLabel;
class QPushButton;

namespace rubble::widgets {

class FindingList;
class Notice;
class NumberField;
class SectionView;

/// The profile of a section through what was simulated and surveyed, with what is measured along it. Stays open beside the window.
class SectionDialog : public QDialog {
    Q_OBJECT

public:
    explicit SectionDialog(QWidget* parent = nullptr);

    /// Easting and northing of both ends of a line, m, in the system of the case.
    using Ends = std::array<Eigen::Vector2d, 2>;

    struct Content {
        std::shared_ptr<const SiteSection> section;  ///< null: none yet
        double time = 0.0;                           ///< s
        double zero = 0.0;                           ///< m, height of the local zero
        std::optional<Ends> ends;                    ///< of the line; unset: it is not known yet
        bool along = false;                          ///< the line was found along measured points
        Findings findings;
        std::vector<Caution> cautions;  ///< what must be known beside it
        QString complaint;              ///< what went wrong with the last one
        bool cutting = false;
        bool stale = false;  ///< it is of another run, survey or place
    };
    void setContent(const Content& content);
    const Content& content() const { return m_content; }
    double width() const;
    double step() const;
    /// How the picture is drawn that is saved.
    figures::SectionPictureStyle printed() const;

signals:
    /// Another width or step is wanted.
    void changed();
    /// The line is wanted elsewhere.
    void endsChanged(const Ends& ends);
    void saveRequested();

private:
    /// How one set of heights agrees, in words.
    static QString ofSource(const QString& name, const SectionAgreement& agreement);
    QString measures() const;
    QWidget* endsRow();
    void takeEnds();

    Content m_content;
    SectionView* m_view;
    NumberField* m_width;
    NumberField* m_step;
    std::array<NumberField*, 4> m_ends{};
    QLabel* m_measures;
    Notice* m_notice;
    FindingList* m_findings;
    QPushButton* m_save;
};

}  // namespace rubble::widgets
