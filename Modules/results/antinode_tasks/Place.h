#pragma once

#include "Field.h"
#include "TracksAt.h"

#include <antinode_base/Progress.h>
#include <antinode_focus/FocusDescription.h>
#include <antinode_structure/DeviceDescription.h>
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
    std::vector<FocusDescription> focuses;         ///< Whose voltage counts; empty: controllability does.
    std::optional<WaveformsDescription> waveforms; ///< Which count in place of focuses, where and how strongly:
    TracksAt at;
    std::string least = "volts"; ///< What these are to need least of, or "energy".
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
} // namespace antinode
