#pragma once

#include "JsonReader.h"

namespace antinode
{
/** The allowed ranges in files, wide enough for any device that can be built. In the unit that the keys name. */
namespace ranges
{
constexpr std::size_t maximumCeramics = 1024;
constexpr std::size_t maximumModes = 5000;
constexpr std::size_t maximumPoints = 100000;
constexpr std::size_t maximumNameBytes = 200;
constexpr std::size_t maximumDescriptionBytes = 20000;

constexpr NumberRange lengthMillimetre { 1e-4, 1e5 };
constexpr NumberRange positionMillimetre { -1e5, 1e5 };
constexpr NumberRange angleDegrees { -360, 360 };
constexpr NumberRange supportStiffness { 0, 1e9 }; // in N and mm, per length, area or not
constexpr NumberRange supportDamping { 0, 1e9 };   // N s/m
constexpr NumberRange supportLossFactor { 0, 10 };
constexpr NumberRange massPerArea { 0, 1e5 }; // kg/m^2
constexpr NumberRange massGram { 0, 1e9 };
constexpr NumberRange frequencyHz { 1e-3, 1e8 };
constexpr NumberRange voltage { 1e-3, 1e5 };
constexpr NumberRange slewVoltsPerMicrosecond { 1e-6, 1e6 };
constexpr NumberRange currentMilliampere { 1e-6, 1e6 };
constexpr NumberRange capacitanceNanofarad { 1e-6, 1e9 };
constexpr NumberRange lossFactor { 0, 1 };
constexpr NumberRange timeMillisecond { 1e-3, 60000 };
constexpr NumberRange dampingRatio { 0, 1, true, true };
constexpr NumberRange qualityFactor { 0.5, 1e9, true };
constexpr NumberRange frequencySpreadPercent { 0, 10 };
constexpr NumberRange spreadPercent { 0, 50 };
} // namespace ranges
} // namespace antinode
