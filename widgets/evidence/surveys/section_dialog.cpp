#include "widgets/evidence/surveys/section_dialog.h"

#include <QDialogButtonBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QPushButton>
#include <QVBoxLayout>
#include <cmath>

#include "widgets/basics/number_field.h"
#include "widgets/basics/panel.h"
#include "widgets/basics/theme.h"
#include "widgets/basics/wording.h"
#include "widgets/run/caution_words.h"

namespace rubble::widgets {

/// Draws the profile as large as there is room.
class SectionView : public QWidget {
public:
    explicit SectionView(QWidget* parent = nullptr) : QWidget(parent) { setMinimumSize(480, 240); }

    void setSection(std::shared_ptr<const SiteSection> section, double zero) {
        m_section = std::move(section);
        m_zero = zero;
        update();
    }

protected:
    void paintEvent(QPaintEvent*) override {
        QPainter painter(this);
        painter.fillRect(rect(), tints().panel);
        if (m_section == nullptr) {
            return;
        }
        figures::SectionPictureStyle style;
        style.pixels = (QSizeF(size()) * devicePixelRatioF()).toSize();
        style.textPixels = 1.2 * devicePixelRatioF() * fontMetrics().ascent();
        style.theme = currentTheme();
        style.zero = m_zero;
        QImage picture = figures::sectionPicture(*m_section, style);
        picture.setDevicePixelRatio(devicePixelRatioF());
        painter.drawImage(QPoint(0, 0), picture);
    }

private:
    std::shared_ptr<const SiteSection> m_section;
    double m_zero = 0.0;
};

SectionDialog::SectionDialog(QWidget* parent)
    : QDialog(parent),
      m_view(new SectionView),
      m_width(new NumberField(tr("Width of the section"))),
      m_step(new NumberField(tr("Step along the section"))),
      m_measures(new QLabel),
      m_notice(new Notice),
      m_findings(new FindingList) {
    setWindowTitle(tr("Section"));
    auto* column = new QVBoxLayout(this);
    auto* row = new QHBoxLayout;
    const SectionLine usual;
    for (const auto& [label, field, number] :
         {std::tuple(tr("Width, m"), m_width, usual.width), std::tuple(tr("Step, m"), m_step, usual.step)}) {
        row->addWidget(new QLabel(label));
        field->setRange(0.01, 1000.0);
        field->setNumber(number);
        field->setMaximumWidth(90);
        row->addWidget(field);
        connect(field, &NumberField::edited, this, &SectionDialog::changed);
    }
    m_width->setToolTip(tr("Surveyed points within half of it to either side of the line count, m"));
    m_step->setToolTip(tr("Along the line: what is drawn, and what areas are summed over, m"));
    row->addStretch();
    column->addWidget(endsRow());
    column->addLayout(row);
    column->addWidget(m_view, 1);
    m_measures->setWordWrap(true);
    m_measures->setTextInteractionFlags(Qt::TextSelectableByMouse);
    column->addWidget(m_measures);
    column->addWidget(m_notice);
    column->addWidget(m_findings);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
    m_save = buttons->addButton(tr("Save picture…"), QDialogButtonBox::ActionRole);
    // Enter in a field takes its number.
    m_save->setAutoDefault(false);
    buttons->button(QDialogButtonBox::Close)->setAutoDefault(false);
    connect(m_save, &QPushButton::clicked, this, &SectionDialog::saveRequested);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    column->addWidget(buttons);
    setContent({});
}

/// A line that was found or clicked has no more digits than that.
double toMillimetres(double coordinate) {
    return std::round(1000.0 * coordinate) / 1000.0 + 0.0;
}

/// Both ends as numbers: a line can be given exactly, and by keyboard alone.
QWidget* SectionDialog::endsRow() {
    constexpr int coordinateDigits = 11;  // centimetres of a northing of ten million metres
    constexpr int fieldWidth = 110;
    auto* all = new QWidget;
    auto* row = new QHBoxLayout(all);
    row->setContentsMargins(0, 0, 0, 0);
    const std::array<QString, 4> labels{tr("From easting, m"), tr("northing, m"), tr("to easting, m"), tr("northing, m")};
    const std::array<QString, 4> names{tr("Easting of the first end"), tr("Northing of the first end"),
                                       tr("Easting of the second end"), tr("Northing of the second end")};
    for (std::size_t k = 0; k < m_ends.size(); ++k) {
        auto* label = new QLabel(labels[k]);
        m_ends[k] = new NumberField(names[k]);
        m_ends[k]->setDigits(coordinateDigits);
        m_ends[k]->setMaximumWidth(fieldWidth);
        label->setBuddy(m_ends[k]);
        row->addWidget(label);
        row->addWidget(m_ends[k]);
        connect(m_ends[k], &NumberField::edited, this, &SectionDialog::takeEnds);
    }
    row->addStretch();
    return all;
}

void SectionDialog::takeEnds() {
    std::array<double, 4> numbers{};
    for (std::size_t k = 0; k < m_ends.size(); ++k) {
        if (!m_ends[k]->number()) {
            return;
        }
        numbers[k] = *m_ends[k]->number();
    }
    emit endsChanged({Eigen::Vector2d(numbers[0], numbers[1]), Eigen::Vector2d(numbers[2], numbers[3])});
}

double SectionDialog::width() const {
    return m_width->number().value_or(SectionLine().width);
}

double SectionDialog::step() const {
    return m_step->number().value_or(SectionLine().step);
}

figures::SectionPictureStyle SectionDialog::printed() const {
    figures::SectionPictureStyle style;
    style.zero = m_content.zero;
    return style;
}

void SectionDialog::setContent(const Content& content) {
    m_content = content;
    m_view->setSection(content.section, content.zero);
    m_measures->setText(measures());
    for (std::size_t k = 0; k < m_ends.size(); ++k) {
        const auto end = static_cast<Eigen::Index>(k % 2);
        m_ends[k]->setNumber(content.ends ? std::optional(toMillimetres((*content.ends)[k / 2][end])) : std::nullopt);
        m_ends[k]->setEnabled(content.ends.has_value());
    }
    m_findings->set(content.findings);
    if (!content.complaint.isEmpty()) {
        m_notice->set(Notice::Kind::Error, content.complaint);
    } else if (content.stale && !content.cutting) {
        m_notice->set(Notice::Kind::Finding, tr("Of another run, survey or place: draw the section again."));
    } else {
        const QString known = content.section != nullptr ? cautionWords(content.cautions) : QString();
        m_notice->set(known.isEmpty() ? Notice::Kind::Note : Notice::Kind::Finding, known);
    }
    m_save->setEnabled(content.section != nullptr && !content.cutting && !content.stale);
}

QString SectionDialog::ofSource(const QString& name, const SectionAgreement& agreement) {
    QString words = tr("%1: %2 heights on it, %3 of them where the simulation has a surface.")
                        .arg(name, shownCount(agreement.points), shownCount(agreement.compared));
    if (agreement.compared > 0) {
        words +=
            QLatin1Char(' ') +
            tr("Simulated less surveyed: %1 m in the mean, %2 m RMS.").arg(shownNumber(agreement.mean), shownNumber(agreement.rms));
    }
    return words;
}

QString SectionDialog::measures() const {
    if (m_content.cutting || m_content.section == nullptr) {
        return m_content.cutting ? tr("Cutting…") : QString();
    }
    const SiteSection& section = *m_content.section;
    QStringList words{
        tr("At %1 s; %2 m long, %3 m wide.")
            .arg(shownNumber(m_content.time, 4), shownNumber(section.line.length()), shownNumber(section.line.width))};
    if (m_content.along) {
        words << tr("The line goes along the measured points, to half a width beyond them.");
    }
    if (section.sources.empty()) {
        words << tr("An outline has no heights: only what was simulated is cut.");
    }
    for (const SectionSource& source : section.sources) {
        words << ofSource(QString::fromStdString(source.name), source.agreement);
    }
    if (section.sources.size() > 1) {
        words << ofSource(tr("All"), section.agreement);
    }
    if (section.agreement.compared > 0) {
        words << tr("Area above the ground over %1 m with heights: %2 m² surveyed, %3 m² simulated.")
                     .arg(shownNumber(section.covered), shownNumber(section.measuredArea), shownNumber(section.simulatedArea));
    }
    return words.join(QLatin1Char('\n'));
}

}  // namespace rubble::widgets
