#pragma once

#include "PlayControls.h"

#include <Eigen/Core>
#include <antinode_model/ModalModel.h>
#include <antinode_tracks/FilterDesign.h>
#include <antinode_tracks/FingerFilters.h>
#include <antinode_tracks/Waveforms.h>

#include <array>
#include <chrono>
#include <memory>
#include <vector>

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

/** Where fingers were seen lately, and where those that move will be. One thread at a time.
    Docs/Design/fingers.md */
class FingerMovement
{
public:
    using Clock = std::chrono::steady_clock;

    /** What the parameters say at a time, not before those that were noted. [session's thread] */
    void note (const TouchSettings&, Clock::time_point);

    /** Whether any finger is on its way. It is seen to have stopped when its next place stays out. [session's thread]
     */
    bool isAnyMoving (Clock::time_point now) const;

    /** What was noted last, with the fingers that move where they will be after a time, on the surface. A finger that
        leaps stays where it is. [session's thread] */
    TouchSettings expected (Clock::time_point now, Clock::duration ahead) const;

    /** What was noted when the fingers came to rest: they have stayed within a two-hundredth of the surface since then.
        [session's thread] */
    const TouchSettings& rest() const { return resting; }

    /** For how long they have rested. [session's thread] */
    Clock::duration restedFor (Clock::time_point now) const { return now - restsSince; }

private:
    struct Seen
    {
        Clock::time_point time;
        double x = 0, y = 0; // % of the surface
    };

    using Way = std::vector<Seen>; // places that differ from the one before, the oldest first

    static void noteFinger (Way&, const FingerSettings&, Clock::time_point);
    static bool isMoving (const Way&, Clock::time_point now);

    TouchSettings newest, resting;
    Clock::time_point restsSince {};
    std::array<Way, mostFingers> ways;
};
} // namespace antinode
