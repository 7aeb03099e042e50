#include "SolidPlate.h"

#include <antinode_documents/DeviceFile.h>
#include <antinode_documents/Library.h>
#include <antinode_engine/OfflineRender.h>
#include <antinode_focus/ModeWeighing.h>
#include <antinode_learning/LearningPasses.h>
#include <antinode_learning/ModeSpread.h>
#include <antinode_learning/Retuning.h>
#include <antinode_model/ModalModel.h>
#include <antinode_numerics/Statistics.h>
#include <antinode_structure/DeviceDescription.h>

#include <nlohmann/json.hpp>

#include <cmath>
#include <cstdio>
#include <numbers>
#include <string>

// Learning from plays on a plate of solid elements, whose shapes are nobody's model: Docs/Theory.md, section 7.6.
// Six sensors at their places, or up to 3.5 mm beside them, 50 dB; a bump of 30 mm at 62, 42 mm after 25 ms.
// Usage: antinode_solid_scores
using namespace antinode;

namespace
{
constexpr double rate = 96000, focusTime = 0.025, duration = 0.25;
constexpr int plays = 3;

Eigen::MatrixX2d statedPlaces()
{
    Eigen::MatrixX2d places (6, 2);
    places << 20, 20, 100, 30, 60, 65, 15, 70, 110, 75, 75, 10;
    return places / 1000;
}

/** Places that are .7 to 3.5 mm beside others. */
Eigen::MatrixX2d beside (Eigen::MatrixX2d places, std::uint64_t seed)
{
    RandomNumbers random (seed);

    for (Eigen::Index m = 0; m < places.rows(); ++m)
    {
        const auto angle = 2 * std::numbers::pi * random.uniform(), distance = 0.0007 + 0.0028 * random.uniform();
        places.row (m) += distance * Eigen::RowVector2d (std::cos (angle), std::sin (angle));
    }

    return places;
}

FocusDescription bump (double highest)
{
    FocusDescription focus;
    Target target;
    target.shape = TargetShape::bump;
    target.x = 0.062;
    target.y = 0.042;
    target.width = 0.03;
    target.peakVelocity = 0.02;
    focus.targets = { target };
    focus.focusTime = focusTime;
    focus.modes.maximumFrequency = highest;
    focus.allocation.method = AllocationMethod::exact;
    return focus;
}

/** What is known of the plate before it is played, with the modes beyond. */
WideModel drawnWide (const ModalModel& drawn, const DeviceDescription& drawing)
{
    return solveWide (drawing, drawn, 1.3 * drawn.frequencyHz (drawn.modes() - 1), true);
}

/** 1 for points within the extent of others, where a model knows its field; else 0. */
Eigen::VectorXd within (const Eigen::MatrixX2d& extent, const Eigen::MatrixX2d& points)
{
    const Eigen::RowVector2d low = extent.colwise().minCoeff().array() - 1e-9,
                             high = extent.colwise().maxCoeff().array() + 1e-9;
    return ((points.rowwise() - low).rowwise().minCoeff().array() > 0
            && (points.rowwise() - high).rowwise().maxCoeff().array() < 0)
        .cast<double>();
}

struct Start
{
    const char* name;
    WideModel model;
    double warmth;  ///< By how much all frequencies of the plate are lower, relative.
    double highest; ///< Hz, of the focus.
};

std::vector<double> errorsOf (const Start& start, const Eigen::MatrixX2d& stated, const Eigen::MatrixX2d& places)
{
    const auto truth = solidPlate (start.warmth);
    const auto shapes = shapesAtPlaces (truth.model, places);
    std::vector<Sensor> sensors;

    for (Eigen::Index m = 0; m < stated.rows(); ++m)
        sensors.push_back (sensorAt (start.model.model, stated (m, 0), stated (m, 1), 0.002));

    const auto focus = bump (start.highest);
    const auto wanted =
        designWithin (start.model, focus, { Reconstruction::bandLimited, rate }, DesignExtent::compared);
    const auto field = atPoints (start.model.model, wanted.truncatedField, truth.model.surface.points);
    const auto inside = within (start.model.model.surface.points, truth.model.surface.points);
    std::vector<double> errors;
    const auto play = [&] (const Eigen::MatrixXd& voltages, int pass)
    {
        const auto played = playOnSolid (truth, voltages, rate, shapes, focusTime);
        errors.push_back (100 * inside.cwiseProduct (played.field - field).norm() / inside.cwiseProduct (field).norm());
        PlayedRecording recording { rate, voltages, played.signals, {}, 0, 0 };
        recording.noise = played.signals.rowwise().norm() / std::sqrt (static_cast<double> (voltages.cols())) / 316;
        RandomNumbers random (static_cast<std::uint64_t> (pass + 1));

        for (Eigen::Index m = 0; m < shapes.rows(); ++m)
            recording.signals.row (m) += recording.noise[m] * random.normal (voltages.cols()).transpose();

        return recording;
    };
    LearningSettings settings { rate, duration, plays, 0 };
    const auto learnt = learnFocus (start.model, focus, sensors, usualDeviations (start.model.model), play, settings);

    if (! learnt.refusal.empty())
        std::printf ("  (%s)\n", learnt.refusal.c_str());

    return errors;
}
} // namespace

int main()
{
    const auto drawing = readDevice (nlohmann::json::parse (drawingOfSolid()), "solid");
    const auto drawn = solveDevice (drawing, 72, true);
    const auto six = statedPlaces();
    auto retuned = drawnWide (drawn, drawing);
    retuned.model = retune (retuned.model, responsesOfSolid (six, 9500), {}).model;
    const std::vector<Start> starts { { "drawn", drawnWide (drawn, drawing), 0, 8000 },
                                      { "retuned at six points", retuned, 0, 8000 },
                                      { "measured at 96 points, warm since", measuredSolid (9000), 0.007, 7980 } };
    std::printf ("field error of each play, %%, of what the controlled modes represent\n");

    for (const auto& start : starts)
        for (const auto isBeside : { false, true })
        {
            std::printf ("%-36s %-8s", start.name, isBeside ? "beside" : "at");

            for (const auto error : errorsOf (start, six, isBeside ? beside (six, 1) : six))
                std::printf (" %6.2f", error);

            std::printf ("\n");
            std::fflush (stdout);
        }
}
