#pragma once

#include <QString>
#include <string>

#include "core/scenario/case.h"

class QWidget;

namespace rubble {

/// Lets a cloud or a table be read so, if it can. @return  why it cannot; empty: the input says so now
QString tryCloudReading(CaseInput& input, const std::string& path, const CloudRequest& read);

/// Asks how a cloud or a table is read that becomes an input, if its file leaves that open. @return  false: somebody gave up
bool askCloudReading(QWidget* window, CaseInput& input, const QString& path, const Frame& frame);

}  // namespace rubble
