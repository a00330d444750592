#pragma once

#include <QByteArray>
#include <QString>

#include "core/base/finding.h"
#include "widgets/figures/report/pdf_tags.h"

namespace rubble::figures {

/// Writes a structure tree into a PDF that Qt made, its language, and an outline of its bookmarks. The squares that PdfTags painted
/// become marked content; all else on the pages becomes an artifact, which no reader speaks.
/// @param language  "en", "zh-CN"
/// Throws std::exception if the file is damaged or does not hold these squares in this order.
QByteArray withStructure(const QByteArray& pdf, const PdfTags& tags, const QString& language);

/// withStructure(), or the file as it is and a finding that says why.
QByteArray taggedPdf(const QByteArray& pdf, const PdfTags& tags, const QString& language, Findings& findings);

}  // namespace rubble::figures
