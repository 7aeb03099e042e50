#pragma once

#include "Field.h"

#include <antinode_base/Progress.h>
#include <antinode_focus/FocusDescription.h>
#include <antinode_model/ModalModel.h>
#include <antinode_structure/DeviceDescription.h>
#include <antinode_structure/PlacementSearch.h>
#include <antinode_structure/Placing.h>

#include <nlohmann/json_fwd.hpp>

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace antinode
{
inline constexpr TaskText placeText { "place", "Finds the best positions of ceramics on a device for its lowest modes",
                                      "Docs/Theory.md, section 1.9" };

/** How many ceramics of which size are placed where on a device. */
struct PlaceRequest
{
    DeviceDescription device;
    int count = 8;
    std::optional<std::pair<double, double>> size;      ///< m; none: as the device's first ceramic, or 10 mm.
    std::optional<double> step, edgeDistance, duration; ///< m, m, s
    double freeEdge = 2e-3;                             ///< m
    int modes = 40;
    std::vector<FocusDescription> focuses; ///< Whose voltage counts; empty: controllability does.
    std::vector<KeepOut> keepOut;
    bool isFrozen = false; ///< The device is not solved again with the placed ceramics.
};

/** [any] */
std::vector<Field> fields (PlaceRequest&);

/** The places that are found. @param better  hears of the best ones so far; may be empty
    @throws InputError  as placeCeramics, and on a device whose modes are given [worker, on all cores] */
PlacedCeramics placed (const PlaceRequest&, const PlacementNews& better, const ShowProgress&);

/** The device with ceramics at these places, named so, as a document. [any] */
nlohmann::json placedDevice (const PlaceRequest&, const std::vector<CeramicDescription>&);

/** A device with its ceramics at the best places. */
struct PlacedDevice
{
    std::string document; ///< JSON
    PlacedCeramics placed;
};

/** @throws InputError  as placed [worker, on all cores] */
PlacedDevice place (const PlaceRequest&, const ShowProgress&);

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
