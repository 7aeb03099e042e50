#include "Commands.h"
#include "CommonOptions.h"
#include "FocusOnDevice.h"
#include "IdleCeramics.h"
#include "Progress.h"
#include "SensorsFiles.h"

#include <antinode_base/InputError.h>
#include <antinode_base/Prefixes.h>
#include <antinode_learning/LearningPasses.h>
#include <antinode_learning/LowerRate.h>
#include <antinode_library/Inputs.h>
#include <antinode_model/ShapesAtPlaces.h>
#include <antinode_numerics/RandomNumbers.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <numeric>
#include <string>

namespace antinode
{
namespace
{
struct SensorsOptions
{
    std::string focus = "demonstrator", device, folder = "antinode-sensors";
    std::vector<std::string> assignments;
    std::vector<int> idleCeramics; // counted from 1
    int count = 2, candidates = 1000;
    double rate = 96000, duration = 250, signalToNoise = 40; // Hz, ms, dB
    double frequency = 0.5, damping = 10, participation = 5; // %
    bool usesCache = true, isQuiet = false;
};

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
        throw InputError ("focus", "moves no candidate; sensors would hear nothing");

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

void print (const SensorsOptions& options, const ModalModel& model, const SensorPlaces& places)
{
    std::printf ("%s on %s\n  %6s %10s %10s %16s\n", places.focus.c_str(), places.device.c_str(), "sensor", "x (mm)",
                 "y (mm)", "together (bits)");

    for (std::size_t i = 0; i < places.choice.chosen.size(); ++i)
    {
        const Eigen::Vector2d place = milli * sensorPlace (model, places, i);
        const auto ceramic = chosenCeramic (places, i);
        std::printf ("  %6zu %10.2f %10.2f %16.1f%s\n", i + 1, place.x(), place.y(), places.choice.bits[i],
                     ceramic > 0 ? ("  idle ceramic " + std::to_string (ceramic)).c_str() : "");
    }

    std::printf ("  at random places: %.1f bits (median)\nPlaces: %s/sensors.csv; report: %s/report.html\n",
                 places.randomBits, options.folder.c_str(), options.folder.c_str());
}

void chooseSensorPlaces (const SensorsOptions& options)
{
    constexpr double percent = 100;
    checkAssignments (options.assignments);
    checkSampleRate (options.rate);
    const auto device =
        loadDevice (deviceFor (LibraryKind::focus, { options.focus }, options.device, usualDevice, options.assignments),
                    options.assignments);
    const auto focus = loadFocus (options.focus, options.assignments);
    Progress progress (options.isQuiet);
    progress.show ("Modes of the device", 0);
    const auto known = solveDevice (device, {}, options.usesCache);
    checkKindOfPlaces (known, focus);
    checkIdleCeramics (options.idleCeramics, known);
    auto places = candidatesOn (known.surface, options.candidates);
    places.device = known.name;
    places.focus = focus.name;

    places.idle = options.idleCeramics;
    const auto candidates = places.cell.size() + places.idle.size();

    if (static_cast<std::size_t> (options.count) > candidates)
        throw InputError ("--count", "is " + std::to_string (options.count) + "; allowed: 1 to "
                                         + std::to_string (candidates) + ", as many as there are candidates");

    const Playback playback { Reconstruction::bandLimited, options.rate };
    const auto wide = wideOf (device, known, playback, options.usesCache);
    auto driven = wide;
    driven.model = withoutDrive (wide.model, options.idleCeramics);
    const auto design = designWithin (driven, focus, playback, DesignExtent::playable);
    const LearningSettings play { options.rate, options.duration / 1000, 0 };
    const PlayedVoltages voltages (playedVoltages (known, design, play), options.rate);
    const auto heard = modesWithin (wide.model, options.rate);
    progress.show ("What the play tells", 0.3);
    const auto information = playedInformation (heard,
                                                sameSpread (heard.modes(), options.frequency / percent,
                                                            options.damping / percent, options.participation / percent),
                                                voltages);
    progress.show ("Choosing places", 0.9);
    const auto audibilities = audibilitiesOf (heard, places, voltages, options.signalToNoise);
    places.bits.resize (audibilities.rows());

    for (Eigen::Index c = 0; c < audibilities.rows(); ++c)
        places.bits[c] = informationBits (information, audibilities.row (c).transpose());

    places.choice = chooseSensors (information, audibilities, options.count);
    places.randomBits = bitsAtRandom (information, audibilities, options.count);
    writeSensors (options.folder, known, places);

    if (! options.isQuiet)
        print (options, known, places);
}
} // namespace

void addSensorsCommand (CLI::App& app)
{
    auto* command = app.add_subcommand ("sensors", "Chooses where sensors tell most of the modes that a focus plays");
    auto options = std::make_shared<SensorsOptions>();
    command->add_option ("focus", options->focus, "Focus: an embedded name or a .json file")->capture_default_str();
    command->add_option ("--device", options->device,
                         "Device: an embedded name or a .json file (default: the one that the focus names, else "
                         "staple)");
    command->add_option ("--count", options->count, "How many sensors")
        ->check (CLI::Range (1, 100))
        ->capture_default_str();
    command
        ->add_option ("--idle-ceramic", options->idleCeramics,
                      "Ceramic that is not driven and may be one of the sensors, counted from 1 (repeatable)")
        ->allow_extra_args (false)
        ->check (CLI::Range (1, 4096));
    command->add_option ("--candidates", options->candidates, "About how many places are compared, in square cells")
        ->check (CLI::Range (1, 100000))
        ->capture_default_str();
    const auto add = [&] (const char* name, double& value, const char* text)
    { command->add_option (name, value, text)->check (CLI::Range (0.0, 50.0))->capture_default_str(); };
    add ("--frequency-percent", options->frequency, "Standard deviation of each frequency from the device, %");
    add ("--damping-percent", options->damping, "Standard deviation of each damping ratio, %");
    add ("--participation-percent", options->participation, "Standard deviation of each participation, %");
    command->add_option ("--snr-db", options->signalToNoise, "Signal-to-noise ratio at an average place, dB")
        ->check (CLI::Range (-20.0, 300.0))
        ->capture_default_str();
    command->add_option ("--rate", options->rate, "Sample rate, Hz")->type_name ("FLOAT")->capture_default_str();
    command->add_option ("--duration-ms", options->duration, "Length of the play, ms")
        ->check (CLI::Range (1.0, 10000.0))
        ->capture_default_str();
    command
        ->add_option ("--set", options->assignments,
                      "Overrides a key, for example focus.targets.0.x_mm=24 (repeatable)")
        ->allow_extra_args (false)
        ->type_name ("KEY=VALUE");
    command->add_option ("--out", options->folder, "Output folder")->capture_default_str();
    addCacheFlag (*command, options->usesCache);
    command->add_flag ("--quiet", options->isQuiet, "Prints only errors");
    command->callback ([options] { chooseSensorPlaces (*options); });
}
} // namespace antinode
