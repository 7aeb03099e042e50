#pragma once

#include <antinode_engine/OfflineRender.h>
#include <antinode_fingers/Sensation.h>
#include <antinode_focus/FocusDescription.h>
#include <antinode_model/ModalModel.h>

#include <nlohmann/json_fwd.hpp>

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace antinode
{
/** How strongly one place of the surface is felt over a whole event. */
struct FeltPlace
{
    double x = 0, y = 0; ///< m
    double level = 0;    ///< dB over threshold.
};

/** What skin feels of a whole event. Docs/Theory.md, section 5.1. */
struct FeltOutcome
{
    std::string threshold;              ///< Its source.
    std::vector<FeltPlace> targets;     ///< At the wanted places.
    std::optional<FeltPlace> elsewhere; ///< The largest farther than feltNeighbourhood from all targets; none where the
                                        ///< surface ends before.
    std::vector<FeltPlace> bystanders;  ///< At fingers, and at places where a focus asks for less.
    double feltShare = 0;               ///< Of the places looked at, those over the threshold.
    std::vector<FeltPlace> places; ///< Even places, row by row from below, or the points where they lie on no grid.
    Eigen::Index columns = 0;      ///< Of even places: how many a row has; 0 on no grid.

    /** The weakest target over the strongest other place, dB; none without both. */
    std::optional<double> contrast() const;

    /** The same over a level, dB; none without targets. */
    std::optional<double> contrastTo (double level) const;
};

/** What skin feels of a rendered event, at the targets, at bystanders and everywhere else.
    @param bystanders  x, y, m
    @throws Cancelled  when a watch of this thread says no
    [worker] */
FeltOutcome feltOutcome (const ModalModel&, const Render&, const std::vector<Target>&, const SkinThreshold&,
                         const std::vector<std::pair<double, double>>& bystanders = {});

/** Levels and contrast in one sentence. [any] */
std::string feltInWords (const Surface&, const FeltOutcome&);

/** As summary.json has it. [any] Docs/FileFormats.md. */
nlohmann::ordered_json feltToJson (const FeltOutcome&);
} // namespace antinode
