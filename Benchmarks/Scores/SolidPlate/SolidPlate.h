#pragma once

#include <antinode_focus/SpillOver.h>
#include <antinode_identification/FrequencyResponses.h>
#include <antinode_model/ModalModel.h>

#include <string>

namespace antinode
{
/** A plate of solid elements: its modes at points 5 mm apart, and how far those above bend it. */
struct SolidPlate
{
    ModalModel model;         ///< To 39 kHz, the four pads' modes included.
    Eigen::MatrixXd residual; ///< N_p x N_b, m/V
};

/** @param warmth  by how much its frequencies are lower, relative; each within a seventh of it */
SolidPlate solidPlate (double warmth);

/** The device file of its drawing. */
std::string drawingOfSolid();

/** What a vibrometer reads of it at places, 50 dB. @param highest Hz */
FrequencyResponses responsesOfSolid (const Eigen::MatrixX2d& places, double highest);

/** As it was measured at 96 points: its modes from 300 Hz to a frequency. */
WideModel measuredSolid (double highest);

/** A field of a model at points of another one. */
Eigen::VectorXd atPoints (const ModalModel&, const Eigen::VectorXd& field, const Eigen::MatrixX2d& points);

struct PlayedOnSolid
{
    Eigen::VectorXd field;   ///< At the focus, m/s.
    Eigen::MatrixXd signals; ///< Sensors x N_s, m/s.
};

/** Each mode exactly, voltages straight from sample to sample at eight times the rate.
    @param sensors  shapes at sensors */
PlayedOnSolid playOnSolid (const SolidPlate&, const Eigen::MatrixXd& voltages, double rate,
                           const Eigen::MatrixXd& sensors, double focusTime);
} // namespace antinode
