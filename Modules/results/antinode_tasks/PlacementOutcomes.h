#pragma once

#include "Place.h"
#include "Render.h"

#include <antinode_focus/FocusDescription.h>
#include <antinode_model/ModalModel.h>
#include <antinode_structure/PlacementSearch.h>

#include <string>
#include <utility>
#include <vector>

namespace antinode
{
/** What a focus comes to on a device. */
struct PlacementOutcome
{
    std::string focus;
    double peakVoltage = 0; ///< V, of the voltages of least norm, whatever the limits.
    double limit = 0;       ///< V, of the ceramic that has the highest.
    double fieldError = 0;  ///< Against the wanted field.
    double contrast = 0;    ///< As in summary.json.
};

/** Designs and plays each focus without limits, so that devices compare by what they need. @throws InputError  as
    designFocus [worker] */
std::vector<PlacementOutcome> placementOutcomes (const ModalModel&, const std::vector<FocusDescription>&);

/** What some ceramics come to, by the keys of summary.json: the worst of all focuses, without limits; of waveforms all
    numbers of antinode perform, at their levels or at the share of them, level_share_dB, that the limits allow.
    @param device  with its ceramics
    @throws InputError  as placementOutcomes and performWithinLimits [worker] */
std::vector<std::pair<std::string, double>> placementNumbers (const PlaceRequest&, const DeviceDescription& device);

/** The highest peak voltage of all focuses on a device with the chosen ceramics, solved with their mass and stiffness.
    @param device  whose own ceramics do not count [worker] */
PlacementCostOf peakVoltageCost (const DeviceDescription& device, const std::vector<FocusDescription>&);

/** What the waveforms need of the chosen ceramics without limits, on the modes of the bare device: the peak of all
    voltages, V, or what heats the ceramics, in a unit of its own. [worker] Docs/Design/structure.md. */
PlacementCostOf waveformsCost (const PlaceRequest&);
} // namespace antinode
