#include "ModeSpread.h"

#include <algorithm>
#include <cmath>

namespace antinode
{
namespace
{
// As drawings were off plates of solid elements. Docs/Theory.md, section 7.6.
constexpr double drawnShapes = 0.001;                       // of a mode's RMS shape at a place, times its number
constexpr double leastOfShapes = 0.005, mostOfShapes = 0.1; // of a mode's RMS shape
constexpr double betweenPoints = 0.02;                      // the same between places where shapes were measured
constexpr double drawnMixing = 0.0015;                      // that of a drawn frequency
constexpr double drawnGain = 0.05;                          // of a ceramic by its data sheet, and of all
constexpr double sensorGain = 0.005;                        // by its calibration
constexpr double measuredGain = 0.002;                      // since it was measured
constexpr double drawnDrift = 0.003, measuredDrift = 0.01;  // materials; temperature since then

bool hasDrawnShapes (const ModeOrigin& origin)
{
    return origin.source == ModeSource::drawn || origin.source == ModeSource::retuned;
}

/** Of its RMS shape, what a mode is off at a place. */
double shapeShare (const ModalModel& model, Eigen::Index mode, const Eigen::RowVector2d& place)
{
    constexpr double atPoint = 0.2e-3; // m

    if (hasDrawnShapes (model.origin))
        return std::clamp (drawnShapes * static_cast<double> (mode + 1), leastOfShapes, mostOfShapes);

    const auto& points = model.surface.points;
    const auto isAtPoint = points.rows() > 0 && (points.rowwise() - place).rowwise().norm().minCoeff() < atPoint;
    return isAtPoint ? std::clamp (model.origin.unexplained, leastOfShapes, mostOfShapes) : betweenPoints;
}

/** What modes change along a step, by places inside the surface: per step, and what a parabola adds. */
struct Steps
{
    Eigen::RowVectorXd slope, bend; ///< N_m
};

Steps stepsAt (const ModalModel& model, const Sensor& sensor, const Eigen::RowVector2d& place,
               const Eigen::RowVector2d& along)
{
    const auto inside = [&model] (const Eigen::RowVector2d& where)
    { return nearestOn (model.surface, where[0], where[1]); };
    const Eigen::Vector2d before = inside (place - along), after = inside (place + along);
    const auto distance = (after - before).norm();

    if (! (distance > 0))
        return { Eigen::RowVectorXd::Zero (model.modes()), Eigen::RowVectorXd::Zero (model.modes()) };

    const auto earlier = shapesAt (model, before[0], before[1]), later = shapesAt (model, after[0], after[1]);
    return { (later - earlier) * (along.norm() / distance), 0.5 * (later + earlier) - sensor.shapes };
}
} // namespace

ModeSpread usualDeviations (const ModalModel& model)
{
    const auto source = model.origin.source;
    const auto modes = model.modes();
    const auto isMeasured = source == ModeSource::retuned || source == ModeSource::measured;
    auto spread = source == ModeSource::retuned    ? sameSpread (modes, 0.003, 0.1, 0.01)
                  : source == ModeSource::measured ? sameSpread (modes, 0.001, 0.05, 0.003)
                                                   : sameSpread (modes, 0.005, 0.1, 0.05);

    if (source == ModeSource::given)
        return spread;

    spread.drift = isMeasured ? measuredDrift : drawnDrift;
    spread.gain = spread.ceramicGains = isMeasured ? measuredGain : drawnGain;
    spread.mixing = hasDrawnShapes (model.origin) ? drawnMixing : 0;
    spread.mixesForces = source == ModeSource::drawn;
    return spread;
}

Sensor sensorAt (const ModalModel& model, double x, double y, double placeDeviation)
{
    Sensor sensor { shapesAt (model, x, y), {}, 0, {} };

    if (model.origin.source == ModeSource::given)
        return sensor;

    const auto& areas = model.surface.areas;
    const Eigen::RowVectorXd meanSquares = areas.transpose() * model.shapes.cwiseAbs2() / areas.sum();
    const Eigen::RowVectorXd squares = sensor.shapes.cwiseAbs2();
    sensor.deviations.resize (model.modes());
    sensor.gain = sensorGain;

    for (Eigen::Index k = 0; k < model.modes(); ++k)
    {
        const auto far =
            hasDrawnShapes (model.origin)
                ? squares.dot (farMixturesOf (model.angularFrequencies, k, drawnMixing).cwiseAbs2().transpose())
                : 0.0;
        sensor.deviations[k] = std::sqrt (std::pow (shapeShare (model, k, { x, y }), 2) * meanSquares[k] + far);
    }

    if (placeDeviation > 0)
    {
        const auto x1 = stepsAt (model, sensor, { x, y }, { placeDeviation, 0 }),
                   y1 = stepsAt (model, sensor, { x, y }, { 0, placeDeviation });
        sensor.slopes.resize (2, model.modes());
        sensor.slopes << x1.slope, y1.slope;
        sensor.deviations = (sensor.deviations.cwiseAbs2() + x1.bend.cwiseAbs2() + y1.bend.cwiseAbs2()).cwiseSqrt();
    }

    return sensor;
}

Sensor idleCeramic (const ModalModel& model, Eigen::Index ceramic, double deviation)
{
    const Eigen::RowVectorXd shapes = model.participation.col (ceramic).transpose();
    return { shapes, deviation * shapes.cwiseAbs(), 0, {} };
}

Eigen::VectorXd mixturesOf (const Eigen::VectorXd& angularFrequencies, Eigen::Index mode, double mixing)
{
    constexpr double most = 0.5;
    const Eigen::ArrayXd squares = angularFrequencies.array().square();
    const auto own = squares[mode];
    Eigen::VectorXd shares = (mixing * (squares * own).sqrt() / (squares - own).abs().max (1e-12 * own)).min (most);
    shares[mode] = 0;
    return shares;
}

Eigen::VectorXd farMixturesOf (const Eigen::VectorXd& angularFrequencies, Eigen::Index mode, double mixing)
{
    auto shares = mixturesOf (angularFrequencies, mode, mixing);

    for (const auto next : { mode - 1, mode + 1 })
        if (next >= 0 && next < shares.size())
            shares[next] = 0;

    return shares;
}
} // namespace antinode
