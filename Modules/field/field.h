#pragma once

// What is wanted and what is played: foci, waveforms at fingers, voltages sample by sample and the motion that follows.
// Rooms and their headers: Docs/Architecture.md.

#include <antinode_engine/OfflineRender.h>
#include <antinode_engine/PlateModel.h>
#include <antinode_engine/VoltageLimiter.h>
#include <antinode_focus/DesignFocus.h>
#include <antinode_focus/Prediction.h>
#include <antinode_tracks/TrackDesign.h>
