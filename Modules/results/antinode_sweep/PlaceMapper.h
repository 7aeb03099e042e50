#pragma once

#include "FocusMap.h"

#include <antinode_focus/PlacedDesigns.h>

#include <optional>
#include <vector>

namespace antinode
{
/** Designs one focus at many places of a surface, with what the places share computed once. */
class PlaceMapper
{
public:
    /** @throws InputError  where the focus cannot be designed for the device
        [worker] */
    PlaceMapper (const WideModel&, const FocusDescription&, const MapOptions&);

    /** The designs at places, x and y in m, one per row; where there is none, its error says why.
        @throws Cancelled  as checkWatch()
        [worker], several at once. */
    std::vector<MapPlace> mapped (const Eigen::MatrixX2d& places) const;

private:
    /** Projections of fields on all modes: by masses, as designs take them, and by areas, as scores do. */
    struct Projections
    {
        Eigen::MatrixXd fields;         ///< N_p x places, m/s
        Eigen::MatrixXd byMass, byArea; ///< N_m x places
    };

    Projections projected (const std::vector<FocusDescription>&) const;
    void compute (MapPlace&, const FocusDescription& moved, const Projections&, Eigen::Index) const;
    void computeAlone (MapPlace&, const FocusDescription& moved) const;
    void score (MapPlace&, const Eigen::VectorXd& velocities, const Projections&, Eigen::Index) const;
    void feel (MapPlace&, const FocusDesign&, const FocusDescription& moved) const;

    const WideModel& wide;
    const FocusDescription& focus;
    const MapOptions& options;
    ModalModel known, felt;
    Eigen::VectorXd areas; ///< Shares of the whole surface.
    Eigen::VectorXd means; ///< Of each shape over the surface.
    std::optional<PlacedDesigns> shared;
};
} // namespace antinode
