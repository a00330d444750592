#include "widgets/evidence/surveys/scan_dialog.h"

#include <QCoreApplication>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QScreen>
#include <QTimer>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "widgets/basics/number_field.h"
#include "widgets/basics/panel.h"
#include "widgets/basics/unit_label.h"
#include "widgets/basics/wording.h"
#include "widgets/evidence/surveys/scanner_field.h"

namespace rubble::widgets {

namespace {

constexpr double radians = std::numbers::pi / 180.0;  // in a degree
constexpr double usualStep = 0.2;                     // degrees

}  // namespace

ScanDialog::ScanDialog(QWidget* parent)
    : QDialog(parent),
      m_scanners(new ScannerField(tr("four around the debris"))),
      m_instant(new NumberField(tr("Instant that is scanned"))),
      m_moving(new Notice),
      m_step(new NumberField(tr("Step between rays"))),
      m_range(new NumberField(tr("Range of the scanners"))),
      m_noise(new NumberField(tr("Noise along a ray"))),
      m_seed(new NumberField(tr("Seed of directions and noise"))),
      m_said(new QLabel),
      m_notice(new Notice),
      m_findings(new FindingList),
      m_scan(new QPushButton(tr("Scan and save…"))),
      m_cancel(new QPushButton(tr("Cancel the scan"))) {
    setWindowTitle(tr("Scan the run"));
    auto* column = new QVBoxLayout(this);
    auto* words = new QLabel(
        tr("Makes a point cloud as laser scanners would take it of what the run leaves. It shows what a scan can tell of a "
           "collapse; what is hidden has no points."));
    words->setWordWrap(true);
    words->setMinimumWidth(440);
    column->addWidget(words);
    auto* form = new QFormLayout;
    const ScanSettings usual;
    m_step->setRange(0.001, 10.0);
    m_step->setNumber(usualStep);
    m_step->setToolTip(tr("One ray falls to each square of this side, degrees"));
    m_range->setRange(0.1, 10'000.0);
    m_range->setNumber(usual.range);
    m_range->setToolTip(tr("Farthest that a ray goes, m"));
    m_noise->setRange(0.0, 10.0);
    m_noise->setNumber(usual.noise);
    m_noise->setToolTip(tr("Standard deviation along the ray, m"));
    m_seed->setRange(0.0, 1e9);
    m_seed->setNumber(static_cast<double>(usual.seed));
    m_seed->setToolTip(tr("Equal seeds give equal points"));
    m_instant->setEmptyMeans(tr("the end, all at rest"));
    m_instant->setUnit("s");
    m_instant->setToolTip(tr(
        "Instant of the run on the clock of the FE result. A LAS or PLY keeps it, so that the cloud is compared with that instant "
        "once it is a survey; of a CSV it must be said there"));
    auto* instant = new QHBoxLayout;
    instant->addWidget(m_instant, 1);
    instant->addWidget(new UnitLabel(QStringLiteral("s")));
    form->addRow(tr("Scanners"), m_scanners);
    form->addRow(tr("Instant"), instant);
    form->addRow(tr("Step, °"), m_step);
    form->addRow(tr("Range, m"), m_range);
    form->addRow(tr("Noise, m"), m_noise);
    form->addRow(tr("Seed"), m_seed);
    column->addLayout(form);
    column->addWidget(m_moving);
    auto* row = new QHBoxLayout;
    row->addWidget(m_scan);
    row->addWidget(m_cancel);
    row->addStretch(1);
    column->addLayout(row);
    m_said->setWordWrap(true);
    m_said->setTextInteractionFlags(Qt::TextSelectableByMouse);
    column->addWidget(m_said);
    column->addWidget(m_notice);
    column->addWidget(m_findings);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
    for (QPushButton* button : {m_scan, m_cancel, buttons->button(QDialogButtonBox::Close)}) {
        button->setAutoDefault(false);  // Enter in a field takes its number
    }
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    column->addWidget(buttons);
    connect(m_scan, &QPushButton::clicked, this, &ScanDialog::scanRequested);
    connect(m_cancel, &QPushButton::clicked, this, &ScanDialog::cancelRequested);
    setContent({});
}

ScanSettings ScanDialog::settings() const {
    ScanSettings settings;
    settings.scanners = m_scanners->places().value_or(std::vector<Vec3>());
    settings.step = radians * m_step->number().value_or(usualStep);
    settings.range = m_range->number().value_or(settings.range);
    settings.noise = m_noise->number().value_or(settings.noise);
    settings.seed = static_cast<std::uint64_t>(std::llround(m_seed->number().value_or(1.0)));
    return settings;
}

std::optional<double> ScanDialog::instant() const {
    return m_instant->number();
}

void ScanDialog::setMoving(std::int64_t moving, std::int64_t bodies) {
    m_instant->setEmptyMeans(moving > 0 ? tr("the end, not all at rest") : tr("the end, all at rest"));
    m_moving->set(Notice::Kind::Finding,
                  moving > 0 ? tr("At the end of the run %1 of %2 bodies still move: a scan shows them where they are then, which "
                                  "is not where they will lie.")
                                   .arg(shownCount(moving), shownCount(bodies))
                             : QString());
}

void ScanDialog::setContent(const Content& content) {
    m_content = content;
    m_scan->setEnabled(!content.scanning);
    m_cancel->setVisible(content.scanning);
    m_said->setText(content.scanning ? tr("The site is being scanned.") : content.said);
    m_said->setVisible(!m_said->text().isEmpty());
    m_notice->set(Notice::Kind::Error, content.complaint);
    m_findings->set(content.findings);
    // Once all of it is laid out: a dialog does not ask for the height that wrapped sentences need.
    QTimer::singleShot(0, this, [this] {
        QCoreApplication::sendPostedEvents(nullptr, QEvent::LayoutRequest);
        const int needed = std::min(layout()->totalHeightForWidth(width()), screen()->availableGeometry().height());
        if (isVisible() && needed > height()) {
            resize(width(), needed);
        }
    });
}

}  // namespace rubble::widgets
