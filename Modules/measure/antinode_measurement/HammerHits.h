#pragma once

#include <Eigen/Core>

#include <optional>
#include <string>
#include <vector>

namespace antinode
{
/** A recording of the force of a hammer and of the motion that it causes: one hit or several. N_s samples. */
struct HammerRecording
{
    std::string source;        ///< For messages.
    double sampleRate = 0;     ///< Hz
    Eigen::VectorXd force;     ///< N_s: N
    Eigen::MatrixXd responses; ///< N x N_s: any unit.
    /** N + 1: where the force's channel and those of the responses end, in their units; 0: unknown. */
    Eigen::VectorXd fullScales;
};

/** How hits are found and cut out. */
struct HammerSettings
{
    double trigger = 0.1;              ///< Share of the largest force of a recording.
    std::optional<double> block;       ///< s, of a hit; none: up to the next one.
    std::optional<double> windowDecay; ///< 1/s, of the exponential window; none: chosen.
};

/** One hit. */
struct HammerHit
{
    Eigen::Index trigger = 0; ///< Sample at which the force passes the trigger.
    double peak = 0;          ///< N
    std::string fault;        ///< Why it is not used, as the end of a sentence; empty: it is used.
};

/** All hits of a test, and what they share. */
struct HammerTest
{
    Eigen::Index block = 0;                   ///< Samples of a hit.
    Eigen::Index lead = 0;                    ///< Samples of these before the trigger.
    double windowDecay = 0;                   ///< 1/s: e^{-at} over force and responses from the start of a block.
    double motionBefore = 0;                  ///< Largest effective value before a used hit, over that of its motion.
    std::vector<std::vector<HammerHit>> hits; ///< Of each recording.

    /** Samples from the start of a block in which nothing happens yet: their mean is the offset of a channel. [any] */
    Eigen::Index quiet() const { return lead / 2; }

    /** Of all recordings. [any] */
    Eigen::Index usedHits() const;
};

/** The block of a hit of a channel, without the offset that it has before the hit: 0 before the recording begins, as
   with the short lead of a triggered analyser, and after it ends. [worker] */
Eigen::ArrayXd hitBlock (const Eigen::VectorXd& channel, const HammerTest&, const HammerHit&);

/** Finds the hits and refuses those that must not be averaged: incomplete ones (the recording begins within the hit, or
   ends before its motion has decayed), double hits (the force rises again by a
    tenth of its peak) and overloads (samples at full scale, or at least three at the channel's extreme with steps
    beside them that are no quantisation). The exponential window is chosen so that of the motion at most a thousandth
    is left at the end of a block.
    @throws InputError  where a recording has no hit, sample rates differ, a setting is not usable, or no hit is left
    [worker] Docs/Theory.md, section 8.11. */
HammerTest examineHits (const std::vector<HammerRecording>&, const HammerSettings&);
} // namespace antinode
