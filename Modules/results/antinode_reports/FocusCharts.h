#pragma once

#include "Chart.h"

#include <Eigen/Core>
#include <antinode_engine/OfflineRender.h>
#include <antinode_focus/FocusDesign.h>
#include <antinode_model/ModalModel.h>

#include <string>

namespace antinode
{
/** Velocities along a line at one instant.
    @param places      N, m
    @param velocities  N x 3: wanted, truncated to the controlled modes, reached, m/s
    [any] */
LineChart profileChart (const Eigen::VectorXd& places, const Eigen::MatrixX3d& velocities);

/** The velocity on a line at the focus: wanted, truncated to the controlled modes, reached, with the ceramics beneath.
    @param wanted, truncated, reached  N_p values, m/s
    [any] */
LineChart fieldChart (const ModalModel&, const Eigen::VectorXd& wanted, const Eigen::VectorXd& truncated,
                      const Eigen::VectorXd& reached);

/** Modal velocities at the focus, a group of bars a mode: wanted of the controlled ones, reached of all up to a little
   above them.
    @param reached  N_m, m/s kg^1/2
    [any] */
BarChart spectrumChart (const ModalModel&, const FocusDesign&, const Eigen::VectorXd& reached);

/** The voltages of all ceramics with their limits and the focus marked. [any] */
StackedTraces voltagesChart (const ModalModel&, const VoltageProgram&, const Render&);

/** The velocity at one probe over time, the focus marked.
    @param probe  row of Render::probeVelocities
    [any] */
LineChart probeChart (const Render&, Eigen::Index probe, const std::string& name);

/** The transients of the strongest controlled modes: what each adds at most to the surface's velocity, over time.
    @param count  how many modes at most
    [any] */
StackedTraces transientsChart (const ModalModel&, const FocusDesign&, const Render&, int count);

/** The spectrogram of the velocity at one probe, dB re its largest value.
    @param maximumFrequency  Hz, the highest shown
    [worker] */
HeatMap spectrogramChart (const Render&, Eigen::Index probe, double maximumFrequency);

/** The velocity around the focus as a map over place and time: on a line all of it, on a plate along x through the
   first focus.
    @param span  s before and after the focus
    [worker] */
HeatMap fieldOverTimeChart (const ModalModel&, const FocusDesign&, const Render&, double span);

/** The settings of a spectrogram. */
struct SpectrogramSettings
{
    double windowDuration = 4e-3; ///< s, of the Hann window: two tones 2 / windowDuration Hz apart are distinguished.
    int columns = 400;            ///< Instants, evenly over the signal: its first sample to its last, 1 or more.
    double maximumFrequency = 0;  ///< Hz; 0 for half of the sample rate.
    double reference = 0;         ///< Amplitude of 0 dB in the unit of the signal; 0 for the largest one found.
    double floorDecibels = -80;   ///< Nothing lies below; less than 0.
};

/** The level of a signal over time and frequency. */
struct Spectrogram
{
    Eigen::MatrixXd decibels;    ///< A row for each frequency from 0 up, a column for each instant; dB.
    Eigen::VectorXd times;       ///< s from the first sample: where the window's middle stands.
    Eigen::VectorXd frequencies; ///< Hz
};

/** The short-time Fourier transform of a signal as an amplitude spectrum: a sine of amplitude A reads A on its line, at
   most 0.4 dB less where the line lies between two frequencies. Before and after the signal there is silence.
    @param signal      any unit; samples that are not finite count as 0
    @param sampleRate  Hz, more than 0
    @throws InputError  where a setting is not usable
    [worker] Docs/Theory.md, section 5; paper, Fig. 15. */
Spectrogram spectrogram (const Eigen::Ref<const Eigen::VectorXd>& signal, double sampleRate,
                         const SpectrogramSettings& = {});
} // namespace antinode
