#pragma once

#include "Chart.h"

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
} // namespace antinode
