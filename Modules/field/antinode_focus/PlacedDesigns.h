#pragma once

#include "SpillOver.h"

#include <optional>

namespace antinode
{
/** A design at one place, and what it brings all modes to. */
struct PlacedDesign
{
    FocusDesign design;         ///< With program, certificate and spill-over; without fields on points.
    Eigen::VectorXd velocities; ///< Of all modes of the wide model at the focus, m/s kg^1/2.
};

/** Designs of one focus at many places by the least norm within exact rows. What does not depend on the place is
   computed once: the drive of each mode, its samples, the overlaps of drives, and the responses of all modes to them.
   A place then costs two small factorisations. The same choice of modes, guards and modes at rest as designWithin.
    Docs/Design/sweeps.md. */
class PlacedDesigns
{
public:
    /** Whether places of a focus can share so much: real modes over the whole body, one moment, exact rows at the least
        norm, nothing else that a design may be asked for. [any] */
    static bool suits (const WideModel&, const FocusDescription&);

    /** @param focus  one that suits
        @throws InputError  as focusMoments [worker] */
    PlacedDesigns (const WideModel&, const FocusDescription& focus, Playback);

    /** A design for a target that lies elsewhere.
        @param target  with its velocities of the device's own modes and its energy; its field is not looked at
        @return        none where limits are met or drives are so alike that only the whole solver can say
        @throws InputError  when modes cannot be chosen [worker, several at once] */
    std::optional<PlacedDesign> design (const ProjectedTarget& target) const;

    /** The overlaps of all modes on the surface: shapes' areas shapes. [any] */
    const Eigen::MatrixXd& areaGram() const { return shapeOverlaps; }

private:
    struct Trial;

    FocusDesign chosen (const ProjectedTarget&, const ModeChoice&) const;
    Trial allocated (FocusDesign, Eigen::Index designed) const;
    Trial weighed (const ProjectedTarget&, Eigen::Index designed) const;
    double shareBeyond (const Eigen::VectorXd& velocities) const;
    double fieldError (const Trial&) const;
    Eigen::MatrixXd sharesOf (const FocusDesign&, Eigen::Index designed) const;

    FocusDescription description;
    Playback playback;
    Eigen::Index known;
    double time;                                  ///< Of the focus, s.
    ModalModel modes;                             ///< All, without shapes.
    ModalModel ownModes;                          ///< The device's own, without shapes.
    std::vector<std::vector<Oscillation>> drives; ///< Of each own mode; empty where it has none.
    Eigen::MatrixXd samples;                      ///< N_s x own modes: each drive has the length 1.
    Eigen::MatrixXd overlaps;                     ///< Own modes squared: of the drives' samples.
    Eigen::MatrixXd responses;                    ///< All modes x own modes: to drives of length 1.
    Eigen::MatrixXd participationGram;            ///< All modes squared.
    Eigen::MatrixXd shapeOverlaps;                ///< All modes squared.
    Eigen::VectorXd lengths;                      ///< Of the drives.
    Eigen::VectorXd limits;                       ///< N_b, V, on the grid.
    Eigen::VectorXd fullLimits;                   ///< N_b, V.
};
} // namespace antinode
