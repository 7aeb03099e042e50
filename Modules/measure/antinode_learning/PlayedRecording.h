#pragma once

#include <Eigen/Core>
#include <antinode_model/ModalModel.h>
#include <antinode_numerics/Fourier.h>

#include <vector>

namespace antinode
{
/** What listens to the surface: a velocity sensor at a place, or an idle ceramic whose current is measured. */
struct Sensor
{
    Eigen::RowVectorXd shapes; ///< N_m: its signal per modal velocity; of a velocity sensor the mode shapes there.
    Eigen::RowVectorXd deviations = {}; ///< N_m: standard deviation of each of these; none: they are known.
    double gain = 0;                    ///< Relative standard deviation of a factor of all of them.
    Eigen::Matrix2Xd slopes = {}; ///< 2 x N_m: what a standard deviation of its place, along x and y, changes of them;
                                  ///< none: the place is exact.
};

/** Voltages that were played on a surface at rest, and what the sensors recorded meanwhile. */
struct PlayedRecording
{
    double sampleRate = 0;      ///< Hz
    Eigen::MatrixXd voltages;   ///< N_b x N_s, V.
    Eigen::MatrixXd signals;    ///< N x N_s, in the unit of the sensors' shapes times modal velocities.
    Eigen::VectorXd noise;      ///< N: standard deviation of each sensor's samples.
    double delay = 0;           ///< s, from the voltages to the signals, as far as it is known.
    double delaySpan = 0;       ///< s: by how much the delay may be longer; it is then looked for. 0: it is known.
    double bandShare = 1;       ///< Of the frequencies up to half the rate: where the noise lies, at its known density.
    Eigen::MatrixXd cubes = {}; ///< N_b x N_s, V^3: of the voltages, as cubedVoltages; none: ceramics are linear.
};

struct WideModel;

/** What of a recording lies below a frequency, voltages and signals alike, at the lowest rate that holds it: a linear
   device answers to the filtered voltages by the filtered signals, without what modes above add.
    @param highest  Hz, passed; above it all falls to 0 within a quarter of it
    @return         the same recording where its rate is at most twice that
    @throws InputError  where the frequency is not above 0
    [worker] Docs/Theory.md, section 7.7. */
PlayedRecording atLowerRate (const PlayedRecording&, double highest);

/** What of a recording lies where a model has modes: all that its known ones do and, as far as the lower rate holds it,
   what those beyond them do. Modes beyond the model, which every plate has, are not heard then; where it has none up to
   1.31 of the highest known frequency, they are heard up to there.
    @return  begins with silence, as much before voltages and signals, since filtered voltages begin to ring early; has
             at least 6400 samples where it had; the same recording where its rate is below 2.6 times the highest known
             frequency
    [worker] Docs/Theory.md, section 7.6. */
PlayedRecording withinModel (PlayedRecording, const WideModel&);

/** Up to which frequency a model has all modes, Hz: a little below its highest. [any] */
double highestModelled (const ModalModel&);

/** The modes that move at a sample rate: below 0.45 of it. Those above answer as springs, which is feedthrough.
    @throws InputError  where there are none [any] */
ModalModel modesWithin (const ModalModel&, double sampleRate);

/** About how much of each voltage's slope a sensor hears of modes beyond a model: the largest static share that the
   upper half of its own modes has, in the sensor's unit per V/s. [any] Docs/Theory.md, section 7.7. */
double usualFeedthrough (const ModalModel&, const std::vector<Sensor>&);

/** The signals of a recording, to be shifted by any part of a sample again and again. One thread at a time. */
class ShiftedSignals
{
public:
    /** [worker] */
    explicit ShiftedSignals (const PlayedRecording&);

    /** Earlier by a delay: samples x N, one column per sensor. Near the ends, 128 samples, the signals are rounded off
        where they are cut.
        @param delay    s, 0 or more
        @param samples  how many, of the first
        [worker] */
    const Eigen::MatrixXd& earlier (double delay, Eigen::Index samples);

    /** By how much `earlier` changes per second of the delay: samples x N. [worker] */
    Eigen::MatrixXd slopesEarlier (double delay, Eigen::Index samples);

private:
    /** The signals whose spectra are the kept ones, each line times a factor: samples x N. */
    Eigen::MatrixXd filtered (const Eigen::VectorXcd& factors, Eigen::Index samples);

    /** What a delay that is taken out does to each line. */
    Eigen::VectorXcd turnsOf (double delay) const;

    double rate, shiftedBy = -1; ///< The delay of `shifted`, s.
    Eigen::Index length;
    Eigen::MatrixXcd spectra; ///< Lines x N
    Eigen::MatrixXd shifted;
    FourierTables tables;
};

/** The same once. [worker] */
Eigen::MatrixXd signalsEarlier (const PlayedRecording&, double delay, Eigen::Index samples);

/** The slopes of band-limited rows, samples x rows, per s. [worker] */
Eigen::MatrixXd slopesOf (const Eigen::MatrixXd& rows, double sampleRate);

/** How many samples of a recording can be compared with a prediction: the last ones, of the length of its delay, answer
    to voltages before its end only. [any] */
Eigen::Index comparableSamples (const PlayedRecording&);
} // namespace antinode
