#pragma once

#include <antinode_focus/FocusDescription.h>
#include <antinode_model/ModalModel.h>
#include <antinode_structure/PlacementExchange.h>

#include <string>
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

/** The highest peak voltage of all focuses on a device with these ceramics, solved with their mass and stiffness.
    @param device  whose own ceramics do not count [worker] */
PlacementCost peakVoltageCost (const DeviceDescription& device, const std::vector<FocusDescription>&);
} // namespace antinode
