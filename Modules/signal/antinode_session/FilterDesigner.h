#pragma once

#include "TouchSettings.h"

#include <antinode_model/ModalModel.h>
#include <antinode_tracks/FilterBank.h>
#include <antinode_tracks/QuickFilterDesigner.h>
#include <antinode_tracks/Waveforms.h>

#include <Eigen/Core>

#include <array>
#include <memory>

namespace antinode
{
/** Filters for one set of places and one latency. */
struct FilterDesign
{
    FilterBank bank;
    Eigen::MatrixXd noiseGains; ///< N_b x mostFingers, V/m: RMS for RMS of noise that fills the band.
    double error = 0;           ///< As FingerFilters has it.
};

/** What filters are made for: fingers with an input are tracks, others that rest are silent. @param inputs  how many
 * fingers have one [any] */
WaveformsDescription waveformsFor (const Surface&, const TouchSettings&, int inputs);

/** Designs filters for fingers on one surface at one rate, and keeps those of the present places. All decisions of how
    filters are made are here. */
class FilterDesigner
{
public:
    FilterDesigner (std::shared_ptr<const ModalModel>, double sampleRate, int inputs);

    /** Where fingers rest. Designs for other places are forgotten; whether a finger plays or is silent needs no other
        ones. [session's thread] */
    void setFingers (const TouchSettings&);

    /** The design for the present places and a latency, if there is one. [session's thread] */
    std::shared_ptr<const FilterDesign> design (std::size_t latency) const { return designs[latency]; }

    /** Makes it.
        @throws InputError  where there is none: which finger, what is allowed
        @throws Cancelled   when a watch of this thread says no
        [session's thread] */
    void makeDesign (std::size_t latency, const ShowProgress& progress);

    /** What plays until that is made: filters within milliseconds, behind the first that take longer. None where they
       would leave more than -20 dB at other fingers.
        @param expected  where the fingers will be: filters for places that differ from the present ones play for a
                         moment only, and are made to -34 dB
        @throws  as makeDesign, but does not refuse fingers that cannot be told apart
        [session's thread] */
    std::unique_ptr<const FilterBank> quickBank (std::size_t latency, const TouchSettings& expected);

    /** How filters are designed at a rate. [any] */
    static FilterSettings filterSettings (double sampleRate, std::size_t latency);

private:
    std::shared_ptr<const ModalModel> model;
    double rate;
    int inputs;
    TouchSettings places; ///< As if all that rest played, at the same latency.
    std::array<std::shared_ptr<const FilterDesign>, touchLatencies.size()> designs;
    std::array<std::unique_ptr<const QuickFilterDesigner>, touchLatencies.size()> quick;
};
} // namespace antinode
