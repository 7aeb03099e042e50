#pragma once

#include <Eigen/Core>

#include <cstdint>
#include <vector>

namespace antinode
{
/** The excitation signal of a ceramic. Docs/Theory.md, section 8.8. */
enum class ExcitationSignal
{
    multisine, ///< Periodic: all lines of the band at once, no leakage.
    sweep,     ///< Exponential: separates harmonics from the linear response.
    noise      ///< White within the band.
};

/** The settings of an excitation. */
struct ExcitationSettings
{
    ExcitationSignal signal = ExcitationSignal::multisine;
    double sampleRate = 96000;                              ///< Hz
    double lowestFrequency = 100, highestFrequency = 20000; ///< Hz: the band of the responses.
    double resolution = 1;    ///< Hz: lines lie at most so far apart; a block lasts 1/resolution or a little longer.
    int periods = 4;          ///< Blocks that are measured; of a sweep, how often it is repeated.
    int settlingPeriods = 1;  ///< Blocks before them in which the surface settles; of multisine and noise.
    double sweepDuration = 4; ///< s
    bool hasOddGrid = false;  ///< A multisine of odd lines with gaps at random: shows even and odd distortion.
    std::uint64_t seed = 1;   ///< Of noise and gaps.
    Eigen::VectorXd levels;   ///< N_b: peak voltage of each ceramic, V, more than 0.
};

/** The run of one ceramic in a measurement: all ceramics play the same signal one after the other, each at its own
   level.

    A run starts with the signal and ends with silence, during which the surface comes to rest and delayed samples
   arrive. The sync channel plays the same signal at the same time: looped back to an input, it gives the latency of
   recordings.
*/
struct Excitation
{
    ExcitationSettings settings;
    Eigen::VectorXd signal;     ///< Of one run without its silence; the waveform between the samples has a peak of 1.
    Eigen::Index block = 0;     ///< Samples of a period, of a block of noise, of a sweep with the silence after it.
    Eigen::Index runLength = 0; ///< Samples of one run: from one ceramic's first sample to the next one's.
    std::vector<Eigen::Index> lines; ///< Of a block of `lineBlock` samples: those that are measured, ascending.
    Eigen::Index lineBlock = 0;      ///< Lines lie sampleRate / lineBlock apart.
    double crestFactor = 0;          ///< Peak over effective value while it plays.

    /** Hz, of line l of a block. */
    double lineFrequency (Eigen::Index line) const
    {
        return static_cast<double> (line) * settings.sampleRate / static_cast<double> (lineBlock);
    }

    Eigen::Index ceramics() const { return settings.levels.size(); }
};

/** The level at which the sync channel plays, of full scale. */
inline constexpr double syncLevel = 0.5;

/** An excitation as the settings ask for it.
    @param voltageLimits  N_b: what no sample, nor the waveform between samples, exceeds, V
    @throws InputError    naming the first setting that is not usable, and what is
    [worker] Docs/Theory.md, section 8.8. */
Excitation makeExcitation (const ExcitationSettings&, const Eigen::VectorXd& voltageLimits);

/** An excitation as it was made before, with the signal that was played.
    @throws InputError  as makeExcitation, and where the signal is not as long as the settings make it or its samples
   exceed 1 [worker] */
Excitation excitationWith (const ExcitationSettings&, const Eigen::VectorXd& voltageLimits,
                           const Eigen::VectorXd& signal);

/** The voltages played in a ceramic's run.
    @param fullScale  The voltage of a sample of 1, V
    @return           (N_b + 1) x runLength samples of full scale: ceramics, then the sync channel
    [worker] */
Eigen::MatrixXd playedRun (const Excitation&, Eigen::Index ceramic, double fullScale);

/** The frequencies of the lines, Hz. [any] */
Eigen::VectorXd measuredFrequencies (const Excitation&);

/** All lines from lowest to highest. [any] */
std::vector<Eigen::Index> everyLine (Eigen::Index lowest, Eigen::Index highest);

/** The odd lines from lowest to highest without one of each four in a row, chosen at random: what responds on even
   lines is even distortion, on the odd ones left out odd distortion. Pintelon and Schoukens, System Identification,
   2012, section 4.3.
    @throws InputError  when none is left [any] */
std::vector<Eigen::Index> oddRandomLines (Eigen::Index lowest, Eigen::Index highest, std::uint64_t seed);

/** One period of a sum of sines, equally strong on the given lines and nothing elsewhere; its largest sample is 1.

    Begins with Schroeder's phases -pi n (n - 1) / N (IEEE Trans. Inf. Theory 16, 1970), whose crest factor is 1.7, with
   the peaks between samples 1.9, and then clips the waveform and keeps the phases of what comes out, again and again
   (van der Ouderaa, Schoukens and Renneboog, IEEE Trans. Instrum. Meas. 37, 1988): 1.6 and less.
    @param length  samples, more than twice the highest line
    [worker] Docs/Theory.md, section 8.8. */
Eigen::VectorXd multisinePeriod (const std::vector<Eigen::Index>& lines, Eigen::Index length);

/** An exponential sweep whose harmonics start at phase 0 with it: sin (2 pi f_1 L exp (t/L)), f_1 L integral.

    It begins below the band and ends above it, and is faded in and out there. Novak, Lotton and Simon, J. Audio Eng.
   Soc. 63, 2015.
*/
struct Sweep
{
    double startFrequency = 0, endFrequency = 0; ///< Hz
    double rise = 0;                             ///< L, s: the time in which the frequency grows e times.
    Eigen::VectorXd samples;
};

/** A sweep through a band.
    @param duration  s, about: f_1 L is rounded
    @return          samples between -1 and 1
    [worker] Docs/Theory.md, section 8.8. */
Sweep makeSweep (double lowestFrequency, double highestFrequency, double duration, double sampleRate);
} // namespace antinode
