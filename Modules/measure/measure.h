#pragma once

// What devices are: excitations and responses, modes identified from them, modes learnt from plays and followed.
// Rooms and their headers: Docs/Architecture.md.

#include <antinode_identification/Comparison.h>
#include <antinode_identification/Identification.h>
#include <antinode_learning/FollowDrift.h>
#include <antinode_learning/LearnModes.h>
#include <antinode_measurement/Excitation.h>
#include <antinode_measurement/SurfaceMeasurement.h>
