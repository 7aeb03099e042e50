#include "Sensors.h"

#include "DeviceChecks.h"

#include <antinode_base/InputError.h>
#include <antinode_learning/LearningPasses.h>
#include <antinode_learning/LowerRate.h>
#include <antinode_model/IdleCeramics.h>
#include <antinode_model/ShapesAtPlaces.h>
#include <antinode_numerics/RandomNumbers.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace antinode
{
namespace
{
/** The candidates: cells whose centres lie on the surface. */
SensorPlaces candidatesOn (const Surface& surface, int about)
{
    SensorPlaces places;
    places.cells = squareCells (surface, about);

    for (Eigen::Index c = 0; c < places.cells.centres.rows(); ++c)
        if (liesOn (surface, places.cells.centres (c, 0), places.cells.centres (c, 1)))
            places.cell.push_back (c);

    return places;
}

/** Rows of shapes as (shape over noise)^2. The noise is that which an average row has by its ratio. */
Eigen::MatrixXd overNoise (const Eigen::MatrixXd& shapes, const Eigen::MatrixXd& velocityGram, double signalToNoise)
{
    const auto meanSquare = (shapes * velocityGram).cwiseProduct (shapes).sum()
                            / static_cast<double> (std::max<Eigen::Index> (1, shapes.rows()));

    if (shapes.rows() > 0 && ! (meanSquare > 0))
        throw InputError ("focus", "moves no candidate; sensors would record nothing");

    constexpr double decibelsPerBel = 10;
    return shapes.cwiseAbs2() / (meanSquare * std::pow (10.0, -signalToNoise / decibelsPerBel));
}

/** candidates x N_m: places, then idle ceramics, whose currents are their participations by reciprocity. */
Eigen::MatrixXd audibilitiesOf (const ModalModel& model, const SensorPlaces& places, const PlayedVoltages& voltages,
                                double signalToNoise)
{
    const Eigen::MatrixX2d at = places.cells.centres (places.cell, Eigen::all);
    const auto velocities = modeVelocities (model, voltages, voltages.samples());
    const Eigen::MatrixXd gram = velocities.transpose() * velocities / static_cast<double> (voltages.samples());
    Eigen::MatrixXd currents (std::ssize (places.idle), model.modes());

    for (Eigen::Index i = 0; i < currents.rows(); ++i)
        currents.row (i) = model.participation.col (places.idle[static_cast<std::size_t> (i)] - 1).transpose();

    Eigen::MatrixXd result (at.rows() + currents.rows(), model.modes());
    result << overNoise (shapesAtPlaces (model, at), gram, signalToNoise), overNoise (currents, gram, signalToNoise);
    return result;
}

/** The median of what as many sensors at random candidates tell. */
double bitsAtRandom (const PlayedInformation& information, const Eigen::MatrixXd& audibilities, int count)
{
    constexpr int draws = 101;
    RandomNumbers random (1);
    std::vector<double> bits;
    bits.reserve (draws);

    for (int i = 0; i < draws; ++i)
    {
        Eigen::VectorXd sum = Eigen::VectorXd::Zero (audibilities.cols());

        for (int m = 0; m < count; ++m)
            sum += audibilities
                       .row (static_cast<Eigen::Index> (random.uniform() * static_cast<double> (audibilities.rows())))
                       .transpose();

        bits.push_back (informationBits (information, sum));
    }

    std::nth_element (bits.begin(), bits.begin() + draws / 2, bits.end());
    return bits[draws / 2];
}

void checkCount (int count, const SensorPlaces& places)
{
    const auto candidates = places.cell.size() + places.idle.size();

    if (count < 1 || static_cast<std::size_t> (count) > candidates)
        throw InputError ("--count", "is " + std::to_string (count) + "; allowed: 1 to " + std::to_string (candidates)
                                         + ", as many as there are candidates");
}
} // namespace

std::vector<Field> fields (SensorRequest& request)
{
    constexpr double percent = 100, milliseconds = 1000;
    const auto deviation = [&] (const char* option, double& value, const char* of)
    { return Field (option, &value, std::string ("Standard deviation of each ") + of).in (percent).within (0, 50); };
    return {
        focusField (request.focus),
        deviceOfFocusField (request.device),
        Field ("--count", &request.count, "How many sensors").within (1, 100),
        Field ("--idle-ceramic", &request.idleCeramics,
               "Ceramic that is not driven and may be one of the sensors, counted from 1 (repeatable)")
            .as ("idle_ceramics")
            .within (1, 4096),
        Field ("--candidates", &request.candidates, "Approximate number of compared places, in square cells")
            .within (1, 100000),
        deviation ("--frequency-percent", request.frequency, "frequency from the device, %"),
        deviation ("--damping-percent", request.damping, "damping ratio, %"),
        deviation ("--participation-percent", request.participation, "participation, %"),
        Field ("--snr-db", &request.signalToNoise, "Signal-to-noise ratio at an average place, dB")
            .as ("snr_dB")
            .within (-20, 300),
        sampleRateField (request.sampleRate),
        Field ("--duration-ms", &request.duration, "Length of the play, ms").in (milliseconds).within (1, 10000),
        cacheField (request.usesCache),
    };
}

SensorsOnDevice sensors (const SensorRequest& request, const ShowProgress& progress)
{
    const auto& focus = request.focus;
    const auto show = [&] (const char* what, double share)
    {
        if (progress)
            progress (what, share);
    };
    show ("Modes of the device", 0);
    const auto setup = setUp (request.device, { Reconstruction::bandLimited, request.sampleRate }, request.usesCache);
    auto known = setup.known;
    checkKindOfPlaces (known, focus);
    checkIdleCeramics (request.idleCeramics, known);
    auto places = candidatesOn (known.surface, request.candidates);
    places.device = known.name;
    places.focus = focus.name;
    places.idle = request.idleCeramics;
    checkCount (request.count, places);

    const auto& wide = setup.wide;
    auto driven = wide;
    driven.model = withoutDrive (wide.model, request.idleCeramics);
    const auto design = designWithin (driven, focus, setup.playback, DesignExtent::playable);
    const LearningSettings play { request.sampleRate, request.duration, 0 };
    const PlayedVoltages voltages (playedVoltages (known, design, play), request.sampleRate);
    const auto heard = modesWithin (wide.model, request.sampleRate);
    show ("What the play tells", 0.3);
    const auto information = playedInformation (
        heard, sameSpread (heard.modes(), request.frequency, request.damping, request.participation), voltages);
    show ("Choosing places", 0.9);
    const auto audibilities = audibilitiesOf (heard, places, voltages, request.signalToNoise);
    places.bits.resize (audibilities.rows());

    for (Eigen::Index c = 0; c < audibilities.rows(); ++c)
        places.bits[c] = informationBits (information, audibilities.row (c).transpose());

    places.choice = chooseSensors (information, audibilities, request.count);
    places.randomBits = bitsAtRandom (information, audibilities, request.count);
    return { std::move (known), std::move (places) };
}
} // namespace antinode
