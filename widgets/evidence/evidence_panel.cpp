#include "widgets/evidence/evidence_panel.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDateTime>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPainter>
#include <QPushButton>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "widgets/basics/fixed_number.h"
#include "widgets/basics/number_field.h"
#include "widgets/basics/theme.h"
#include "widgets/basics/wording.h"
#include "widgets/evidence/evidence_table.h"
#include "widgets/evidence/photo_pairs.h"
#include "widgets/evidence/photo_view.h"
#include "widgets/evidence/survey_box.h"
#include "widgets/figures/number_text.h"
#include "widgets/figures/shown_units.h"
#include "widgets/run/caution_words.h"

namespace rubble::widgets {

namespace {

QString sentenceOf(const std::vector<Caution>& cautions) {
    const QString words = cautionWords(cautions);
    return words.isEmpty() ? words : words.left(1).toUpper() + words.mid(1);
}

enum PrincipalChoice { Middle, Found };

QWidget* buttonRow(std::initializer_list<QPushButton*> buttons) {
    auto* row = new QWidget;
    auto* line = new QHBoxLayout(row);
    line->setContentsMargins(0, 0, 0, 0);
    for (QPushButton* button : buttons) {
        line->addWidget(button, 1);
    }
    return row;
}

/// As many decimals as the deviation deserves: two of its digits.
QString withSpread(double value, double deviation) {
    if (!std::isfinite(value)) {
        return QStringLiteral("–");
    }
    const int decimals =
        deviation > 0.0 && std::isfinite(deviation) ? std::clamp(1 - static_cast<int>(std::floor(std::log10(deviation))), 0, 6) : 2;
    return QStringLiteral("%1 ± %2").arg(shownFixed(value, decimals), shownFixed(deviation, decimals));
}

QPixmap swatch(MaskClass kind) {
    QPixmap picture(14, 14);
    picture.fill(Qt::transparent);
    QPainter painter(&picture);
    painter.setPen(QPen(maskColour(kind).darker(130), 1.0));
    painter.setBrush(maskColour(kind));
    painter.drawRect(2, 2, 10, 10);
    return picture;
}

QString factsText(const PhotoFacts& facts, const QString& unchanged) {
    QStringList parts;
    parts << EvidencePanel::tr("%1 × %2 px").arg(shownCount(facts.width), shownCount(facts.height));
    if (facts.orientation != 1) {
        parts << EvidencePanel::tr("turned upright");
    }
    if (facts.focalLength) {
        parts << (facts.focalLength35 ? EvidencePanel::tr("focal length %1 mm (%2 mm on 36 × 24 mm)")
                                            .arg(shownNumber(*facts.focalLength), shownNumber(*facts.focalLength35))
                                      : EvidencePanel::tr("focal length %1 mm").arg(shownNumber(*facts.focalLength)));
    } else if (facts.focalLength35) {
        parts << EvidencePanel::tr("focal length %1 mm on 36 × 24 mm").arg(shownNumber(*facts.focalLength35));
    }
    if (!facts.camera.empty()) {
        parts << QString::fromStdString(facts.camera);
    }
    const QDateTime taken =
        QDateTime::fromString(QString::fromStdString(clockTime(facts.taken)), QStringLiteral("yyyy-MM-dd HH:mm:ss"));
    parts << (taken.isValid() ? EvidencePanel::tr("taken %1 by its clock")
                                    .arg(QLocale().toString(taken.date(), QLocale::LongFormat) + u' ' +
                                         taken.time().toString(QStringLiteral("HH:mm:ss")))
                              : EvidencePanel::tr("time taken unknown"));
    if (facts.position) {
        parts << EvidencePanel::tr("%1° N, %2° E")
                     .arg(QLocale().toString((*facts.position)[0], 'f', 5), QLocale().toString((*facts.position)[1], 'f', 5));
    }
    parts << unchanged;
    return parts.join(QStringLiteral(" · "));
}

}  // namespace

EvidencePanel::EvidencePanel(QWidget* parent)
    : Panel(tr("Evidence"), tr("What photographs show, and how far the simulated debris agrees."), parent),
      m_list(new EvidenceTable),
      m_photographs(new QComboBox),
      m_add(new QPushButton(tr("Add photographs…"))),
      m_remove(new QPushButton(tr("Remove"))),
      m_facts(new QLabel),
      m_findings(new FindingList),
      m_note(new QLineEdit),
      m_atRest(new QCheckBox(tr("when all lay at rest"))),
      m_time(new NumberField(tr("Time of the photograph"))),
      m_uncertainty(new NumberField(tr("Uncertainty of the time"))),
      m_pairs(new PhotoPairs),
      m_focal(new NumberField(tr("Focal length"))),
      m_principal(new QComboBox),
      m_radial(new QComboBox),
      m_verdict(new Notice),
      m_doubts(new FindingList),
      m_masks(new QListWidget),
      m_removeMask(new QPushButton(tr("Delete"))),
      m_withFallen(new QCheckBox(tr("Fallen structure counts as debris"))),
      m_compare(new QPushButton(tr("Compare"))),
      m_cancel(new QPushButton(tr("Cancel"))),
      m_whyNot(new QLabel),
      m_agreement(new Notice),
      m_survey(new SurveyBox) {
    buildList();
    buildTime();
    buildPoints();
    buildCamera();
    buildMasks();
    buildAgreement();
    addGroup(tr("Survey"))->addWide(m_survey);
    setContent({});
}

void EvidencePanel::buildList() {
    addWide(m_list);
    m_photographs->setAccessibleName(tr("Photographs"));
    m_photographs->setToolTip(tr("The photograph that is shown"));
    m_photographs->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    addWide(m_photographs);
    m_add->setObjectName(QStringLiteral("addPhotographs"));
    m_add->setToolTip(tr("Add photographs to the case: JPEG, PNG, TIFF or HEIC. Their files are only read, never changed"));
    m_remove->setToolTip(tr("Take the photograph out of the case, with its points and masks; the file stays"));
    addWide(buttonRow({m_add, m_remove}));
    m_facts->setObjectName(QStringLiteral("muted"));
    m_facts->setWordWrap(true);
    addWide(m_facts);
    addWide(m_findings);
    connect(m_add, &QPushButton::clicked, this, &EvidencePanel::addRequested);
    connect(m_remove, &QPushButton::clicked, this, &EvidencePanel::removeRequested);
    connect(m_photographs, &QComboBox::activated, this, &EvidencePanel::photographChosen);
}

void EvidencePanel::buildTime() {
    PanelGroup* group = addGroup(tr("Time"));
    m_details.push_back(group);
    m_atRest->setToolTip(tr("The photograph shows the debris after all has come to rest: it is held against the end of the run"));
    group->addWide(m_atRest);
    m_time->setRange(-1e6, 1e6);
    m_time->setUnit("s");
    group->addField(tr("taken at"), m_time, QStringLiteral("s"),
                    tr("When the photograph was taken, on the clock of the FE result"));
    m_uncertainty->setRange(0.0, 1e6);
    m_uncertainty->setUnit("s");
    group->addField(tr("give or take"), m_uncertainty, QStringLiteral("s"),
                    tr("How far the time may be off, as much before as after. From 0 to 1,000,000 s"));
    m_note->setAccessibleName(tr("Note"));
    m_note->setPlaceholderText(tr("note: who took it, from where"));
    m_note->setToolTip(tr("A note on the photograph, kept in the case"));
    group->addWide(m_note);
    connect(m_atRest, &QCheckBox::clicked, this, [this](bool atRest) {
        edit([] { return tr("time of the photograph"); },
             [&](Photograph& p) {
                 p.time = atRest ? std::nullopt : std::optional(0.0);
                 if (atRest) {
                     p.timeUncertainty = 0.0;
                 }
             });
    });
    connect(m_time, &NumberField::edited, this, [this](std::optional<double> time) {
        edit([] { return tr("time of the photograph"); }, [&](Photograph& p) { p.time = time; });
    });
    connect(m_uncertainty, &NumberField::edited, this, [this](std::optional<double> spread) {
        edit([] { return tr("uncertainty of the time"); }, [&](Photograph& p) { p.timeUncertainty = *spread; });
    });
    connect(m_note, &QLineEdit::editingFinished, this, [this] {
        if (m_note->isModified()) {
            m_note->setModified(false);
            edit([] { return tr("note on the photograph"); }, [&](Photograph& p) { p.note = m_note->text().toStdString(); });
        }
    });
}

void EvidencePanel::buildPoints() {
    PanelGroup* group = addGroup(tr("Points"));
    m_details.push_back(group);
    group->addWide(m_pairs);
    connect(m_pairs, &PhotoPairs::pairsEdited, this, [this](const std::vector<PointPair>& pairs, const Wording& what) {
        edit(what, [&](Photograph& p) { p.pairs = pairs; });
    });
    connect(m_pairs, &PhotoPairs::pairChosen, this, &EvidencePanel::pairChosen);
    connect(m_pairs, &PhotoPairs::addToggled, this, &EvidencePanel::addToggled);
    connect(m_pairs, &PhotoPairs::readRequested, this, &EvidencePanel::readPairsRequested);
}

void EvidencePanel::buildCamera() {
    PanelGroup* group = addGroup(tr("Camera"));
    m_details.push_back(group);
    m_focal->setRange(1.0, 1e7);
    m_focal->setEmptyMeans(tr("to be found"));
    group->addField(
        tr("focal length"), m_focal, tr("px"),
        tr("In pixels, if it is known: in millimetres times the width in pixels over that of the sensor in millimetres. "
           "Left empty it is found from the points. From 1 to 10,000,000 px"));
    m_focalNoted = group->addValue(tr("noted in the file"), tr("px"),
                                   tr("Focal length that the camera noted in the photograph; it is not taken for the true one"));
    m_principal->addItems({tr("the middle"), tr("to be found")});
    m_principal->setAccessibleName(tr("Principal point"));
    group->addField(tr("principal point"), m_principal, {},
                    tr("Where the axis of the lens meets the picture: the middle unless the photograph was cropped, px"));
    m_radial->addItems({tr("automatic"), tr("none"), tr("one term"), tr("two terms")});
    m_radial->setAccessibleName(tr("Distortion"));
    group->addField(tr("distortion"), m_radial, {},
                    tr("Terms of radial distortion that are found from the points. Automatic: as far as these tell them; what they "
                       "leave open is that of real lenses. None: of a picture whose distortion was taken out"));
    group->addWide(m_verdict);
    group->addWide(m_doubts);
    m_place = group->addValue(tr("position"), tr("m"), tr("Where the camera stood: x, y, z in the frame of the case"));
    m_placeSpread =
        group->addValue(tr("within (95 %)"), tr("m"), tr("With 95 % confidence the camera stood within this of the position"));
    m_turnSpread = group->addValue(tr("direction within"), tr("°"),
                                   tr("With 95 % confidence the camera looked within this of the direction found, degrees"));
    m_focalFound = group->addValue(tr("focal length"), tr("px"), tr("With its standard deviation where it was found, pixels"));
    m_fit =
        group->addValue(tr("fit, RMS"), tr("px"), tr("Root of the mean square of the residuals of the points that agree, pixels"));
    connect(m_focal, &NumberField::edited, this, [this](std::optional<double> focal) {
        edit([] { return tr("focal length of the camera"); }, [&](Photograph& p) { p.camera.focal = focal; });
    });
    connect(m_principal, &QComboBox::activated, this, [this](int choice) {
        edit([] { return tr("principal point of the camera"); }, [&](Photograph& p) { p.camera.freePrincipal = choice == Found; });
    });
    connect(m_radial, &QComboBox::activated, this, [this](int choice) {
        edit([] { return tr("distortion of the camera"); },
             [&](Photograph& p) { p.camera.radialTerms = choice == 0 ? std::nullopt : std::optional(choice - 1); });
    });
}

void EvidencePanel::buildMasks() {
    PanelGroup* group = addGroup(tr("Drawn on it"));
    m_details.push_back(group);
    m_masks->setAccessibleName(tr("Outlines and masks"));
    m_masks->setObjectName(QStringLiteral("masks"));
    group->addWide(m_masks);
    m_removeMask->setToolTip(tr("Delete the chosen outline or mask"));
    group->addWide(buttonRow({m_removeMask}));
    connect(m_masks, &QListWidget::currentRowChanged, this, [this](int row) {
        if (!m_showing) {
            emit maskChosen(row);
        }
    });
    connect(m_removeMask, &QPushButton::clicked, this, [this] {
        const int chosen = m_content.chosenMask;
        if (chosen >= 0 && chosen < static_cast<int>(m_content.photograph.masks.size())) {
            edit(
                [kind = m_content.photograph.masks[static_cast<std::size_t>(chosen)].kind] {
                    return tr("%1 deleted").arg(maskWords(kind));
                },
                [&](Photograph& p) { p.masks.erase(p.masks.begin() + chosen); });
        }
    });
}

void EvidencePanel::buildAgreement() {
    PanelGroup* group = addGroup(tr("Agreement with the photograph"));
    m_details.push_back(group);
    m_withFallen->setChecked(true);
    m_withFallen->setToolTip(
        tr("Live elements that moved farther than %1 are debris; else they only hide what lies behind them").arg(shownLength(1.0)));
    connect(m_withFallen, &QCheckBox::toggled, this, [this](bool with) {
        if (!m_showing) {
            emit withFallenChosen(with);
        }
    });
    group->addWide(m_withFallen);
    m_compare->setObjectName(QStringLiteral("primary"));
    m_compare->setToolTip(
        tr("Hold the silhouette of the simulated debris against the outline drawn, with 64 cameras that the match allows"));
    m_cancel->setToolTip(tr("Stop comparing"));
    group->addWide(buttonRow({m_compare, m_cancel}));
    m_whyNot->setObjectName(QStringLiteral("muted"));
    m_whyNot->setWordWrap(true);
    group->addWide(m_whyNot);
    m_iou = group->addValue(tr("overlap"), {},
                            tr("Area in both silhouettes over area in either, with the camera as found; 1: the same"));
    m_iouMean = group->addValue(tr("as the camera allows"), {},
                                tr("Mean and standard deviation of the overlap over the cameras that the match allows"));
    m_edge = group->addValue(tr("edges apart"), tr("m"),
                             tr("Mean distance of the edges of the silhouettes at the distance of the debris"));
    m_edgePixels = group->addValue(QString(), tr("px"), tr("The same in pixels of the photograph"));
    m_overTime = group->addValue(tr("over its time"), {},
                                 tr("Least and greatest overlap from the earliest to the latest time of the photograph"));
    group->addWide(m_agreement);
    connect(m_compare, &QPushButton::clicked, this, &EvidencePanel::compareRequested);
    connect(m_cancel, &QPushButton::clicked, this, &EvidencePanel::cancelRequested);
}

void EvidencePanel::edit(const Wording& what, const std::function<void(Photograph&)>& change) {
    if (m_content.chosen < 0) {
        return;
    }
    Photograph after = m_content.photograph;
    change(after);
    if (!(after == m_content.photograph)) {
        emit photographEdited(after, what);
    }
}

void EvidencePanel::setAdding(bool adding) {
    m_pairs->setAdding(adding);
}

void EvidencePanel::setContent(const Content& content) {
    m_content = content;
    m_showing = true;
    m_withFallen->setChecked(content.withFallen);
    const bool one = content.chosen >= 0;
    m_photographs->clear();
    m_photographs->addItems(content.names);
    m_photographs->setCurrentIndex(content.chosen);
    m_photographs->setVisible(!content.names.isEmpty());
    m_add->setEnabled(content.available);
    m_remove->setEnabled(one);
    for (QWidget* widget : m_details) {
        widget->setVisible(one);
    }
    showFacts();
    if (one) {
        showTime();
        m_pairs->setContent(content.photograph.pairs, content.match ? &*content.match : nullptr, content.chosenPair);
        showCamera();
        showMasks();
        showAgreement();
    }
    m_showing = false;
}

void EvidencePanel::showFacts() {
    if (m_content.chosen >= 0) {
        m_facts->setText(factsText(m_content.photograph.facts, m_content.unchanged));
    } else {
        m_facts->setText(
            m_content.available
                ? tr("A photograph of the site shows what the debris really did. Add one, click points that the model has "
                     "too, and the camera is found; then the simulation is seen from there.")
                : tr("Open a result first."));
    }
    m_findings->set(m_content.chosen >= 0 ? m_content.findings : Findings());
}

void EvidencePanel::showTime() {
    const Photograph& photograph = m_content.photograph;
    m_atRest->setChecked(!photograph.time);
    m_time->setEnabled(photograph.time.has_value());
    m_uncertainty->setEnabled(photograph.time.has_value());
    const QString closed = photograph.time ? QString() : tr("at rest");
    m_time->setPlaceholderText(closed);
    m_uncertainty->setPlaceholderText(photograph.time ? QString() : QStringLiteral("–"));
    m_time->setNumber(photograph.time);
    m_uncertainty->setNumber(photograph.time ? std::optional(photograph.timeUncertainty) : std::nullopt);
    m_note->setText(QString::fromStdString(photograph.note));
    if (!m_note->hasFocus()) {
        m_note->setCursorPosition(0);
    }
}

void EvidencePanel::showCamera() {
    const CameraKnowledge& known = m_content.photograph.camera;
    m_focal->setNumber(known.focal);
    const auto noted = focalFrom(m_content.photograph.facts);
    m_focalNoted->setText(noted ? QLocale().toString(*noted, 'f', 0) : QStringLiteral("–"));
    m_principal->setCurrentIndex(known.freePrincipal ? Found : Middle);
    m_radial->setCurrentIndex(known.radialTerms ? *known.radialTerms + 1 : 0);
    const bool matched = m_content.match.has_value();
    m_doubts->set(matched ? m_content.match->findings : Findings());
    for (QLabel* value : {m_place, m_placeSpread, m_turnSpread, m_focalFound, m_fit}) {
        value->setText(QStringLiteral("–"));
    }
    if (!matched) {
        m_verdict->set(Notice::Kind::Note, m_content.noMatch, m_content.remedy);
        return;
    }
    const CameraMatch& match = *m_content.match;
    QStringList place;
    for (int axis = 0; axis < 3; ++axis) {
        place << shownPlace(match.camera.place[axis], match.placeRadius < 0.05 ? 2 : 1);
    }
    m_place->setText(place.join(QStringLiteral("  ")));
    m_placeSpread->setText(shownIn(match.placeRadius, "m", 2));
    m_turnSpread->setText(shownNumber(match.turnRadius * 180.0 / std::numbers::pi, 2));
    const auto focal = std::find(match.found.begin(), match.found.end(), 6);
    const auto at = static_cast<Eigen::Index>(focal - match.found.begin());
    m_focalFound->setText(focal != match.found.end() ? withSpread(match.camera.focal, std::sqrt(match.covariance(at, at)))
                                                     : shownNumber(match.camera.focal, 4));
    m_fit->setText(tr("%1 of %2").arg(QLocale().toString(match.rms, 'f', 1)).arg(match.used.size() - match.wrong().size()));
    // One pixel at the middle of the points, and the turn, bound what an edge there is worth.
    const double edge = std::hypot(match.sigma * match.distance / match.camera.focal, match.turnRadius * match.distance);
    const QString worth = tr("An edge %1 away is certain to about %2.").arg(shownLength(match.distance, 2), shownLength(edge, 2));
    if (cameraStated(m_content.photograph)) {
        m_verdict->set(Notice::Kind::Finding, sentenceOf(photographCautions(m_content.photograph, &match, nullptr)), QString());
        return;
    }
    switch (match.verdict) {
        case MatchVerdict::Good:
            m_verdict->set(Notice::Kind::Note, tr("Good match."), worth);
            break;
        case MatchVerdict::Usable:
            m_verdict->set(Notice::Kind::Note, tr("Usable match."),
                           worth + u' ' + tr("More points, spread in depth and to the corners, make it better."));
            break;
        case MatchVerdict::Poor:
            m_verdict->set(Notice::Kind::Finding, sentenceOf(photographCautions(m_content.photograph, &match, nullptr)),
                           worth + u' ' + tr("Add points, spread in depth and to the corners of the picture."));
            break;
    }
}

void EvidencePanel::showMasks() {
    m_masks->clear();
    for (const PhotoMask& mask : m_content.photograph.masks) {
        auto* item =
            new QListWidgetItem(QIcon(swatch(mask.kind)), tr("%1, corners: %2").arg(maskWords(mask.kind)).arg(mask.corners.size()));
        m_masks->addItem(item);
    }
    m_masks->setCurrentRow(m_content.chosenMask);
    const int count = static_cast<int>(m_content.photograph.masks.size());
    m_masks->setVisible(count > 0);
    m_masks->setFixedHeight(std::clamp(count, 1, 5) * 24 + 4);
    m_removeMask->setEnabled(m_content.chosenMask >= 0 && m_content.chosenMask < count);
}

void EvidencePanel::showAgreement() {
    const auto& made = m_content.comparison;
    m_compare->setEnabled(m_content.noComparison.isEmpty() && !m_content.comparing);
    m_cancel->setVisible(m_content.comparing);
    m_whyNot->setText(m_content.comparing ? tr("Comparing…") : m_content.noComparison);
    m_whyNot->setVisible(!m_whyNot->text().isEmpty());
    const auto text = [](const SpreadNumber& number) { return withSpread(number.best, number.spread); };
    m_iou->setText(made ? QLocale().toString(made->iou.best, 'f', 2) : QStringLiteral("–"));
    m_iouMean->setText(made ? withSpread(made->iou.mean, made->iou.spread) : QStringLiteral("–"));
    const double perMetre = figures::shownUnit("m").perSi;
    const QString cautions = sentenceOf(m_content.cautions);
    m_edge->setText(made ? withSpread(perMetre * made->edgeMetres.best, perMetre * made->edgeMetres.spread) : QStringLiteral("–"));
    m_edgePixels->setText(made ? text(made->edgePixels) : QStringLiteral("–"));
    m_overTime->setText(made && made->iouOverTime ? tr("%1 to %2")
                                                        .arg(QLocale().toString((*made->iouOverTime)[0], 'f', 2),
                                                             QLocale().toString((*made->iouOverTime)[1], 'f', 2))
                                                  : QStringLiteral("–"));
    if (!m_content.comparisonComplaint.isEmpty()) {
        m_agreement->set(Notice::Kind::Finding, m_content.comparisonComplaint);
    } else if (made && m_content.comparisonStale) {
        m_agreement->set(Notice::Kind::Note, tr("Something has changed since: compare again."));
    } else if (made) {
        m_agreement->set(cautions.isEmpty() ? Notice::Kind::Note : Notice::Kind::Finding,
                         tr("Debris at %1, %2.")
                             .arg(figures::timeText(made->time),
                                  made->withFallen ? tr("fallen structure with it") : tr("fallen structure apart")),
                         cautions);
    } else {
        m_agreement->set(Notice::Kind::Finding, cautions);
    }
}

}  // namespace rubble::widgets
