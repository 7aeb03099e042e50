#pragma once

#include "IdentifiedModes.h"

#include <Eigen/Core>
#include <antinode_model/ModalModel.h>

#include <optional>
#include <vector>

namespace antinode
{
/** Modal assurance criterion of every column of one with every column of the other: squared cosine of the angle between
   them.
    @param one, other  N_p x N, N_p x M; rows that are not finite in either do not count
    @param weights     N_p, at least 0; empty: all alike
    @return            N x M, 0 to 1
    [worker] Docs/Theory.md, section 8.7. */
Eigen::MatrixXd modalAssurance (const Eigen::MatrixXd& one, const Eigen::MatrixXd& other,
                                const Eigen::VectorXd& weights);

/** One mode of either of two models that are the same mode. */
struct ModePair
{
    Eigen::Index identified = 0, computed = 0;
    double assurance = 0;          ///< MAC
    double relativeDifference = 0; ///< of frequencies: identified / computed - 1.
};

/** A computed device compared with the identified one. N_i identified, N_c computed modes. */
struct ModeComparison
{
    Eigen::MatrixXd assurance;   ///< N_i x N_c: MAC at the identified points.
    std::vector<ModePair> pairs; ///< One to one, ascending in the identified mode.
};

/** Pairs of computed and identified modes: the one-to-one assignment with the largest sum of MAC less a penalty for
    frequencies that are apart. Pairs below a MAC of 0.5 are none.
    @throws InputError  when an identified point lies outside of the model's surface
    [worker] Docs/Theory.md, section 8.7. */
ModeComparison compareModes (const IdentifiedModes&, const ModalModel& computed);

/** A computed model with the frequencies and dampings of the identified modes paired with its own; modes without a
   partner move with their neighbours' relative difference. Shapes stay. Participations are those that were measured, of
   shapes as large as the computed ones, where as many references of voltage were measured as there are ceramics; those
   of modes without a partner are as much larger, ceramic by ceramic. Ascending again. [worker]
   Docs/Theory.md, section 8.7. */
ModalModel transferred (const ModalModel& computed, const IdentifiedModes&, const ModeComparison&);

/** The one-to-one assignment of rows to columns with the largest sum of scores, by the Hungarian method.
    @param scores  N x M, finite
    @return        for each row its column, -1 where there are fewer columns than rows and it has none
    [worker] Kuhn, Naval Research Logistics Quarterly 2 (1955) 83. */
std::vector<Eigen::Index> assign (const Eigen::MatrixXd& scores);

/** New frequencies and dampings of some of a model's modes. N_m modes. */
struct ModeUpdate
{
    Eigen::VectorXd angularFrequencies, dampingRatios; ///< N_m: where known.
    std::vector<bool> isKnown;                         ///< N_m
};

/** The model with what is known put in. The frequency of other modes moves by the mean relative change of a few known
    neighbours on either side, interpolated; their damping stays, and so does the order of modes.
    [worker] Docs/Theory.md, section 8.7. */
ModalModel updated (ModalModel, const ModeUpdate&);

/** By how much frequencies of a device usually differ from those that a solver computes, relative; none where they were
   measured. [any] */
std::optional<double> usualModelError (const ModalModel&);

/** Some modes of a model, in the order that is given. [worker] */
ModalModel withModes (ModalModel, const std::vector<Eigen::Index>& modes);

/** The model with its modes in ascending order of frequency. [worker] */
ModalModel ascending (ModalModel);
} // namespace antinode
