#pragma once

namespace rubble::figures {

/// A round step (1, 2 or 5 times a power of ten) that puts at most `count` marks over `span`; 1 where there is no span or no count.
double roundStep(double span, double count);

/// How many significant digits a mark of a scale needs to be told from the next one. @param step  between marks, above 0
int digitsOfMark(double mark, double step);

}  // namespace rubble::figures
