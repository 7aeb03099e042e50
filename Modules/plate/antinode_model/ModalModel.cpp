#include "ModalModel.h"

#include "ShapeInterpolation.h"
#include "Surface.h"

#include <antinode_base/InputError.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <utility>

namespace antinode
{
namespace
{
void require (bool fulfilled, const ModalModel& model, const std::string& wrong)
{
    if (! fulfilled)
        throw InputError ("device '" + model.name + "'", wrong);
}

void validateModes (const ModalModel& model)
{
    double previous = 0;

    for (Eigen::Index k = 0; k < model.modes(); ++k)
    {
        const auto which = "mode " + std::to_string (k + 1);
        const auto frequency = model.angularFrequencies[k];
        const auto damping = model.dampingRatios[k];
        require (std::isfinite (frequency) && frequency > 0, model, which + " has no positive frequency");
        require (frequency >= previous, model,
                 which + " is lower than the previous mode; modes must ascend in frequency");
        require (damping > 0 && damping < 1, model, which + " has a damping ratio outside 0 to 1");
        previous = frequency;
    }
}

std::string millimetres (double metres)
{
    std::array<char, 32> text {};
    std::snprintf (text.data(), text.size(), "%.6g mm", metres * 1000);
    return text.data();
}
} // namespace

double ModalModel::frequencyHz (Eigen::Index mode) const
{
    return angularFrequencies[mode] / (2 * std::numbers::pi);
}

double voltageLimit (const ModalModel& model, std::size_t ceramic)
{
    const auto& one = model.ceramics[ceramic];
    return std::min (one.voltageLimit, one.amplifierVoltage > 0 ? one.amplifierVoltage : model.fullScaleVoltage);
}

Eigen::VectorXd voltageLimits (const ModalModel& model)
{
    return Eigen::VectorXd::NullaryExpr (model.actuators(), [&] (Eigen::Index i)
                                         { return voltageLimit (model, static_cast<std::size_t> (i)); });
}

Eigen::VectorXd slewLimits (const ModalModel& model)
{
    return Eigen::VectorXd::NullaryExpr (model.actuators(), [&] (Eigen::Index i)
                                         { return model.ceramics[static_cast<std::size_t> (i)].slewLimit; });
}

Eigen::VectorXd decayRates (const ModalModel& model)
{
    return model.dampingRatios.cwiseProduct (model.angularFrequencies);
}

Eigen::VectorXd dampedFrequencies (const ModalModel& model)
{
    return (model.angularFrequencies.array() * (1 - model.dampingRatios.array().square()).sqrt()).matrix();
}

Eigen::RowVectorXd shapesAt (const ModalModel& model, double x, double y)
{
    const auto& surface = model.surface;
    const auto isLine = surface.kind == SurfaceKind::line;
    const auto margin = 1e-9 + 1e-9 * (surface.xMaximum - surface.xMinimum);
    const auto inside = x >= surface.xMinimum - margin && x <= surface.xMaximum + margin
                        && (isLine || (y >= surface.yMinimum - margin && y <= surface.yMaximum + margin));

    if (! inside)
    {
        auto allowed = "x from " + millimetres (surface.xMinimum) + " to " + millimetres (surface.xMaximum);

        if (! isLine)
            allowed += ", y from " + millimetres (surface.yMinimum) + " to " + millimetres (surface.yMaximum);

        throw InputError ("point (" + millimetres (x) + ", " + millimetres (y) + ")",
                          "is outside the surface of '" + model.name + "'; allowed: " + allowed);
    }

    requireWithinBoundary (surface, x, y, "point");
    requireOnLine (surface, y, "point (" + millimetres (x) + ", " + millimetres (y) + ") y");

    if (isLine)
        return interpolateOnLine (surface.points.col (0), model.shapes, model.slopes, x);

    return surface.grid ? interpolateOnGrid (*surface.grid, model.shapes, x, y)
                        : interpolateInPlane (surface.points, model.shapes, x, y);
}

ModalModel withSplineSlopes (ModalModel model)
{
    const Eigen::VectorXd x = model.surface.points.col (0);

    for (Eigen::Index i = 1; i < x.size(); ++i)
        require (x[i] > x[i - 1], model, "the points of a line must ascend strictly in x");

    model.slopes = naturalSplineSlopes (x, model.shapes);
    return model;
}

Eigen::VectorXd phaseCollinearities (const ModalModel& model)
{
    Eigen::VectorXd values = Eigen::VectorXd::Ones (model.modes());

    if (! model.hasComplexModes())
        return values;

    for (Eigen::Index k = 0; k < values.size(); ++k)
    {
        const auto real = model.shapes.col (k), imaginary = model.shapes.col (model.modes() + k);
        const auto sum = real.squaredNorm() + imaginary.squaredNorm();
        const auto difference = real.squaredNorm() - imaginary.squaredNorm(), mixed = 2 * real.dot (imaginary);
        values[k] = sum > 0 ? (difference * difference + mixed * mixed) / (sum * sum) : 1.0;
    }

    return values;
}

void requireRealModes (const ModalModel& model, const std::string& what)
{
    require (! model.hasComplexModes(), model,
             "has complex modes, but " + what
                 + " take real modes only; use a device with real modes, "
                   "and no fingers that the design knows");
}

void requireKnownScale (const ModalModel& model, const std::string& what)
{
    require (model.origin.scaleIsKnown, model,
             "has shapes whose size is a convention, but " + what
                 + " need the true one; identify it again with 'antinode identify --mass-kg', or with a driving point");
}

double pointsPerHalfWave (const Eigen::MatrixX2d& points, Eigen::Index mode)
{
    const auto spread = [&] (Eigen::Index axis) { return points.col (axis).maxCoeff() - points.col (axis).minCoeff(); };
    const auto share = static_cast<double> (points.rows()) / static_cast<double> (mode);
    return spread (0) > 0 && spread (1) > 0 ? std::sqrt (share) : share;
}

Eigen::Index resolvedModes (const ModalModel& model)
{
    if (model.origin.source != ModeSource::measured || model.points() < 2)
        return model.modes();

    Eigen::Index count = 0;

    while (count < model.modes() && pointsPerHalfWave (model.surface.points, count + 1) >= enoughPointsPerHalfWave)
        ++count;

    return count;
}

ModalModel onPoints (ModalModel model, const std::vector<Eigen::Index>& points)
{
    auto& surface = model.surface;
    const auto rows = [&points] (Eigen::MatrixXd& matrix)
    {
        if (matrix.rows() > 0)
            matrix = Eigen::MatrixXd (matrix (points, Eigen::all));
    };
    surface.points = Eigen::MatrixX2d (surface.points (points, Eigen::all));
    surface.masses = Eigen::VectorXd (surface.masses (points));
    surface.areas = Eigen::VectorXd (surface.areas (points));
    surface.grid.reset();
    rows (model.shapes);
    rows (model.slopes);
    rows (model.staticShare);
    return model;
}

void validate (const ModalModel& model)
{
    const auto modes = model.modes();
    const auto& surface = model.surface;
    const auto points = surface.points.rows();
    require (modes > 0, model, "has no modes");
    require (points > 0, model, "has no points");
    require (model.dampingRatios.size() == modes, model, "needs one damping ratio per mode");
    const auto coordinates = model.coordinates();
    require (model.shapes.rows() == points && model.shapes.cols() == coordinates, model,
             "needs one shape value for each point and mode, real or complex as its participations");
    require (surface.masses.size() == points && surface.areas.size() == points, model,
             "needs one weight for each point");
    require (model.participation.rows() == coordinates, model, "needs the participation of every mode");
    require (model.participation.cols() == static_cast<Eigen::Index> (model.ceramics.size()), model,
             "needs one column of participation per ceramic");
    require (surface.points.allFinite() && model.shapes.allFinite() && model.participation.allFinite(), model,
             "has a number that is not finite");
    require (surface.masses.allFinite() && surface.areas.allFinite() && surface.masses.minCoeff() >= 0
                 && surface.areas.minCoeff() >= 0 && surface.masses.sum() > 0 && surface.areas.sum() > 0,
             model, "has weights that are negative, not finite or all zero");

    require (model.staticShare.size() == 0
                 || (model.staticShare.rows() == points && model.staticShare.cols() == model.actuators()
                     && model.staticShare.allFinite() && ! model.hasComplexModes()),
             model, "needs one static share for each point and ceramic, of real modes");
    require (model.slopes.size() == 0 || model.slopes.cols() == coordinates, model,
             "needs one slope for each point and mode, real or complex as its shapes");
    require (! (model.hasComplexModes() && model.coversWholeBody), model,
             "has complex modes, whose shapes are not orthogonal: 'covers_whole_body' must be false");

    if (surface.grid)
        require (surface.boundary ? surface.grid->x.places.size() * surface.grid->y.places.size() <= points
                                  : surface.grid->x.places.size() * surface.grid->y.places.size() == points,
                 model, "has a grid whose size differs from the number of points");

    validateModes (model);
}

ModalModel withoutDrive (ModalModel model, const std::vector<int>& idle)
{
    for (const auto ceramic : idle)
        model.participation.col (ceramic - 1).setZero();

    return model;
}

Eigen::MatrixXd shapesAtPlaces (const ModalModel& model, const Eigen::MatrixX2d& places)
{
    Eigen::MatrixXd shapes (places.rows(), model.modes());

    for (Eigen::Index p = 0; p < places.rows(); ++p)
        shapes.row (p) = shapesAt (model, places (p, 0), places (p, 1));

    return shapes;
}
} // namespace antinode
