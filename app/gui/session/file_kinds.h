#pragma once

#include <QString>

namespace rubble {

/// What a dialog lists, in small and in capital letters: all surveys that are read, then each kind of them, then all files.
QString surveyFileKinds();
/// The same of what a terrain is read from: rasters, clouds and tables, meshes.
QString terrainFileKinds();
/// Files of polygons.
QString polygonFileKinds();
/// What measured and scanned points are written as.
QString writtenCloudKinds();
/// Point clouds and tables of points.
QString cloudFileKinds();

}  // namespace rubble
