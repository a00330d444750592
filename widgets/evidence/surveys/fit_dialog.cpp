#include "widgets/evidence/surveys/fit_dialog.h"

#include <QCheckBox>
#include <QDialogButtonBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>
#include <utility>

#include "widgets/basics/number_field.h"
#include "widgets/basics/panel.h"
#include "widgets/basics/wording.h"
#include "widgets/evidence/photo_view.h"

namespace rubble::widgets {

namespace {

constexpr int fitPlanPixels = 2500;  // longest side of the picture of a cloud
constexpr double usualRadius = 1.0;  // m

QString foundText(const FitDialog::Found& found) {
    const CloudFit& fit = found.fit;
    QStringList words{FitDialog::tr("Moved by %1 m, turned by %2°.").arg(shownNumber(fit.distance()), shownDegrees(fit.angle()))};
    words << FitDialog::tr("RMS of %1 points to their surfaces: %2 m before, %3 m after.")
                 .arg(shownCount(fit.pairs), shownNumber(fit.before), shownNumber(fit.after));
    words << FitDialog::tr("One point to each cube of %1 m was fitted.").arg(shownNumber(fit.cube));
    if (found.error) {
        words
            << FitDialog::tr("Places at the structure are then known to %1 m (standard deviation).").arg(shownNumber(*found.error));
    }
    return words.join(QLatin1Char(' '));
}

}  // namespace

FitDialog::FitDialog(SurveyHeights heights, const QString& name, const QString& against, QWidget* parent)
    : QDialog(parent),
      m_plan(std::move(heights)),
      m_name(name),
      m_picture(m_plan.picture(fitPlanPixels)),
      m_view(new PhotoView),
      m_everywhere(new QCheckBox(tr("Most of the cloud did not move: fit all of it"))),
      m_radius(new NumberField(tr("Radius of the fit"))),
      m_file(new QPushButton(tr("Areas from a file…"))),
      m_last(new QPushButton(tr("Remove last area"))),
      m_fit(new QPushButton(tr("Fit"))),
      m_cancel(new QPushButton(tr("Cancel the fit"))),
      m_said(new QLabel),
      m_notice(new Notice),
      m_findings(new FindingList) {
    setWindowTitle(tr("Fit to what did not move"));
    auto* column = new QVBoxLayout(this);
    auto* hint = new QLabel(
        tr("Click the corners around what did not move, such as streets and walls that still stand; a double click or Enter "
           "closes.") +
        u' ' + against);
    hint->setWordWrap(true);
    column->addWidget(hint);
    // Above what gives way to sentences: a row that moves is missed by the mouse.
    buildFields();
    m_view->setAccessibleName(tr("Cloud from above"));
    m_view->setMinimumSize(320, 200);
    m_view->setTool(PhotoView::Tool::Mask, MaskClass::NotDebris);
    column->addWidget(m_view, 1);
    m_said->setWordWrap(true);
    m_said->setTextInteractionFlags(Qt::TextSelectableByMouse);
    column->addWidget(m_said);
    column->addWidget(m_notice);
    column->addWidget(m_findings);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel);
    m_place = buttons->button(QDialogButtonBox::Ok);
    m_place->setText(tr("Place survey"));
    for (QPushButton* button : {m_place, buttons->button(QDialogButtonBox::Cancel), m_file, m_last, m_fit, m_cancel}) {
        // Enter closes an area; it must press nothing.
        button->setAutoDefault(false);
        button->setDefault(false);
    }
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    column->addWidget(buttons);
    connect(m_view, &PhotoView::maskDrawn, this, [this](const PhotoMask& mask) {
        OutlineRing ring;
        for (const Eigen::Vector2d& corner : mask.corners) {
            if (const auto place = m_plan.planAt({corner.x(), corner.y()})) {
                ring.push_back(*place);
            }
        }
        if (ring.size() > 2) {
            addAreas({{{ring}}});
        }
    });
    // Esc takes back what is being drawn; the next one leaves.
    connect(m_view, &PhotoView::toolLeft, this, &QDialog::reject);
    showState();
    m_view->setFocus();
}

void FitDialog::buildFields() {
    auto* row = new QHBoxLayout;
    row->addWidget(m_everywhere);
    row->addStretch(1);
    row->addWidget(m_file);
    row->addWidget(m_last);
    static_cast<QVBoxLayout*>(layout())->addLayout(row);
    auto* second = new QHBoxLayout;
    auto* label = new QLabel(tr("Radius, m"));
    label->setBuddy(m_radius);
    m_radius->setRange(0.001, 1000.0);
    m_radius->setNumber(usualRadius);
    m_radius->setMaximumWidth(90);
    m_radius->setToolTip(
        tr("Surfaces within it of a point are what the point is fitted to, m: more than the cloud is out of place"));
    second->addWidget(label);
    second->addWidget(m_radius);
    second->addStretch(1);
    second->addWidget(m_fit);
    second->addWidget(m_cancel);
    static_cast<QVBoxLayout*>(layout())->addLayout(second);
    m_everywhere->setToolTip(tr("The nearest 80 % of the points decide; what moved must be less than that"));
    m_file->setToolTip(tr("Take polygons of a file as areas that did not move"));
    m_fit->setToolTip(tr("Fits the points of the areas to the surfaces of the site"));
    connect(m_everywhere, &QCheckBox::toggled, this, [this] { change(m_areas); });
    connect(m_radius, &NumberField::edited, this, [this] { change(m_areas); });
    connect(m_file, &QPushButton::clicked, this, &FitDialog::polygonsRequested);
    connect(m_last, &QPushButton::clicked, this, [this] {
        Outline areas = m_areas;
        areas.polygons.pop_back();
        change(std::move(areas));
    });
    connect(m_fit, &QPushButton::clicked, this, &FitDialog::fitRequested);
    connect(m_cancel, &QPushButton::clicked, this, &FitDialog::cancelRequested);
}

std::optional<Outline> FitDialog::stable() const {
    if (m_everywhere->isChecked()) {
        return Outline();
    }
    return m_areas.polygons.empty() ? std::nullopt : std::optional(m_areas);
}

double FitDialog::radius() const {
    return m_radius->number().value_or(usualRadius);
}

void FitDialog::addAreas(const Outline& areas) {
    Outline all = m_areas;
    all.polygons.insert(all.polygons.end(), areas.polygons.begin(), areas.polygons.end());
    change(std::move(all));
}

void FitDialog::change(Outline areas) {
    m_areas = std::move(areas);
    m_content = {};
    showState();
    emit outdated();
}

void FitDialog::setContent(const Content& content) {
    m_content = content;
    showState();
}

void FitDialog::showState() {
    PhotoView::Content content;
    content.picture = m_picture;
    content.size = m_plan.size();
    content.title = m_name;
    for (const OutlinePolygon& polygon : m_areas.polygons) {
        for (const OutlineRing& ring : polygon) {
            PhotoMask mask{MaskClass::NotDebris, {}};
            for (const Eigen::Vector2d& corner : ring) {
                if (const auto pixel = m_plan.pixelOf(Vec3(corner.x(), corner.y(), 0.0))) {
                    mask.corners.emplace_back(pixel->x(), pixel->y());
                }
            }
            content.masks.push_back(std::move(mask));
        }
    }
    m_view->setContent(content);
    const bool any = stable().has_value();
    m_last->setEnabled(!m_areas.polygons.empty() && !m_content.fitting);
    m_fit->setEnabled(any && !m_content.fitting);
    m_cancel->setVisible(m_content.fitting);
    m_said->setText(m_content.fitting ? tr("The cloud is being fitted.")
                    : m_content.found ? foundText(*m_content.found)
                    : any             ? tr("Fit, and what is left is told here.")
                                      : tr("Nothing is said yet of what did not move."));
    m_notice->set(Notice::Kind::Error, m_content.complaint);
    m_findings->set(m_content.found ? m_content.found->findings : Findings());
    m_place->setEnabled(m_content.found.has_value());
}

}  // namespace rubble::widgets
