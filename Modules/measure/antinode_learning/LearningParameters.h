#pragma once

#include "LearnModes.h"
#include "PlayedRecording.h"
#include "PlayedVoltages.h"

#include <antinode_identification/ModalProducts.h>

#include <memory>

namespace antinode
{
/** What one parameter changes. */
enum class ParameterKind
{
    frequency,
    damping,
    participation, ///< Of one mode, of all ceramics together in a fixed ratio.
    sensor         ///< What one sensor hears of one mode.
};

/** One unknown of one mode, in units of its own standard deviation before anything was heard. */
struct LearningParameter
{
    ParameterKind kind = ParameterKind::frequency;
    Eigen::Index mode = 0;
    Eigen::Index sensor = 0;  ///< Of a sensor's parameter.
    Eigen::VectorXd ceramics; ///< N_b, of participation: how much it changes that of each ceramic, relative to it;
                              ///< orthonormal to the others of its mode.
    double information = 0;   ///< Of the recordings, divided by that of the prior, where nothing else is unknown.
};

/** What many participations, or all that a sensor hears, have in common, in units of its standard deviation. */
struct SharedParameter
{
    enum class Kind
    {
        gain,        ///< Of all ceramics.
        ceramicGain, ///< Of one.
        sensorGain,
        sensorX, ///< A sensor's place.
        sensorY,
        mixture ///< Of a mode and the next one.
    };

    Kind kind = Kind::gain;
    Eigen::Index index = 0; ///< Of the ceramic, the sensor or the mode.
};

/** All unknowns: those of modes, what these share, then the common drift, the delay of each recording and of the
    responses, the distortion of each ceramic. */
struct LearningParameters
{
    std::vector<LearningParameter> modal;
    std::vector<SharedParameter> shared = {};
    Eigen::Index delays = 0;
    std::vector<Eigen::Index> distorting = {}; ///< The ceramics whose distortion is unknown.

    Eigen::Index ofModes() const { return std::ssize (modal); }
    Eigen::Index drift() const { return std::ssize (modal) + std::ssize (shared); }
    Eigen::Index delay (Eigen::Index i) const { return drift() + 1 + i; }
    Eigen::Index distortion (Eigen::Index place) const { return drift() + 1 + delays + place; }
    Eigen::Index size() const { return distortion (std::ssize (distorting)); }
};

/** A device, its sensors and delays, as values of the parameters say. */
struct LearningState
{
    ModalModel model;            ///< Without the surface and its shapes.
    Eigen::MatrixXd sensors;     ///< N x N_m
    Eigen::VectorXd delays;      ///< s, of each recording, then of the responses.
    Eigen::VectorXd distortions; ///< N_b, 1/V^2: as of LearntModes.
    Eigen::VectorXd mixtures;    ///< N_m: how much of the next mode each one has, and the next one of it the opposite.
};

/** Frequency responses of the sensors to each ceramic's voltage, as data. */
struct HeardResponses
{
    PreparedResponses& data; ///< Its points are the sensors, its references the ceramics.
    double delay = 0;        ///< s, as far as it is known.
    LineMoments moments {};  ///< Of the data, near to the delay that was asked for last.
    double variance = 1;     ///< What is believed of each value's noise, times its weight.
};

/** What is known before, and the data: recordings, responses or both. One thread at a time. */
struct LearningPrior
{
    const ModalModel& model;
    const std::vector<Sensor>& sensors;
    const ModeSpread& deviations;
    const std::vector<PlayedRecording>& recordings;
    ModalModel modes;     ///< The model without the surface and its shapes, which every state would copy.
    ModalModel deviating; ///< The same, with the standard deviation of each participation in place of it.
    Eigen::VectorXd distortionDeviations; ///< N_b, 1/V^2: 0 where a ceramic is linear or plays nothing.
    std::vector<Eigen::VectorXd> noise;   ///< Of each recording, N: what is believed of it, at least what it says.
    std::vector<PlayedVoltages> voltages; ///< Of each recording.
    std::vector<std::unique_ptr<ShiftedSignals>> signals {}; ///< The same.
    HeardResponses* responses = nullptr;                     ///< None, or the caller's.

    /** How far the delay of each set of data is known: s. [any] */
    Eigen::VectorXd delays() const;
};

/** @throws InputError  where sizes do not agree or a number is not usable [any] */
void requireUsable (const ModalModel&, const std::vector<Sensor>&, const ModeSpread&,
                    const std::vector<PlayedRecording>&);

/** What is kept by reference has to stay. @throws InputError  as requireUsable [worker] */
LearningPrior makePrior (const ModalModel&, const std::vector<Sensor>&, const ModeSpread&,
                         const std::vector<PlayedRecording>&, HeardResponses* = nullptr);

/** @param values  of the parameters, in standard deviations [any] */
LearningState stateAt (const LearningPrior&, const LearningParameters&, const Eigen::VectorXd& values);

/** What shared parameters change, as values of those of modes: of modes x shared. [any] */
Eigen::MatrixXd effectsOfShared (const LearningPrior&, const LearningParameters&);

/** Values without what they say of a sensor. [any] */
Eigen::VectorXd withoutSensor (Eigen::VectorXd values, const LearningParameters&, Eigen::Index sensor);

/** The values of parameters that come nearest to a device that was learnt before. [any] */
Eigen::VectorXd valuesOf (const LearningPrior&, const LearningParameters&, const LearntModes& before);
} // namespace antinode
