#include "SolidPlate.h"

#include <antinode_model/ModalModel.h>
#include <antinode_numerics/KaiserSinc.h>
#include <antinode_numerics/Statistics.h>

#include <nlohmann/json.hpp>

#include <cmath>
#include <complex>
#include <fstream>
#include <numbers>
#include <vector>

namespace antinode
{
namespace
{
using Json = nlohmann::json;

constexpr double length = 0.12, width = 0.08; // m

const Json& data()
{
    static const auto plate = Json::parse (std::ifstream (ANTINODE_SOLID_PLATE));
    return plate;
}

Eigen::VectorXd vectorOf (const Json& numbers)
{
    const auto values = numbers.get<std::vector<double>>();
    return Eigen::Map<const Eigen::VectorXd> (values.data(), std::ssize (values));
}

Eigen::MatrixXd rowsOf (const Json& rows)
{
    Eigen::MatrixXd matrix (std::ssize (rows), std::ssize (rows[0]));

    for (Eigen::Index i = 0; i < matrix.rows(); ++i)
        matrix.row (i) = vectorOf (rows[static_cast<std::size_t> (i)]).transpose();

    return matrix;
}

/** The area that each of a grid's points stands for, but for a factor: half on an edge. */
Eigen::VectorXd areasOf (const Eigen::MatrixX2d& points)
{
    Eigen::VectorXd areas = Eigen::VectorXd::Ones (points.rows());

    for (Eigen::Index i = 0; i < points.rows(); ++i)
        for (const auto& [at, end] : { std::pair { points (i, 0), length }, std::pair { points (i, 1), width } })
            if (at < 1e-9 || at > end - 1e-9)
                areas[i] /= 2;

    return areas;
}

/** A plate of such points. */
Surface surfaceOf (const Eigen::MatrixX2d& points)
{
    Surface surface;
    surface.kind = SurfaceKind::plate;
    surface.xMaximum = length;
    surface.yMaximum = width;
    surface.points = points;
    surface.areas = areasOf (points);
    surface.masses = surface.areas * (0.0299 / surface.areas.sum());
    return surface;
}
} // namespace

SolidPlate solidPlate (double warmth)
{
    const Eigen::MatrixX2d points = rowsOf (data()["points_mm"]) / 1000;
    SolidPlate plate { {}, rowsOf (data()["residual"]) };
    auto& model = plate.model;
    model.name = "solid";
    model.surface = surfaceOf (points);
    model.shapes = rowsOf (data()["shape"]).transpose();
    model.angularFrequencies = 2 * std::numbers::pi * vectorOf (data()["frequency_Hz"]);
    model.dampingRatios = vectorOf (data()["damping_ratio"]);
    model.participation = rowsOf (data()["participation"]);
    RandomNumbers random (7);

    for (auto& frequency : model.angularFrequencies)
        frequency *= 1 - warmth * (1 + (2 * random.uniform() - 1) / 7);

    for (const auto& corner : data()["lower_left_mm"])
    {
        Ceramic ceramic;
        ceramic.name = "C" + std::to_string (model.ceramics.size() + 1);
        ceramic.xMinimum = corner[0].get<double>() / 1000;
        ceramic.xMaximum = ceramic.xMinimum + 0.01;
        ceramic.yMinimum = corner[1].get<double>() / 1000;
        ceramic.yMaximum = ceramic.yMinimum + 0.01;
        ceramic.voltageLimit = 1000;
        model.ceramics.push_back (std::move (ceramic));
    }

    model.fullScaleVoltage = 1000;
    return plate;
}

std::string drawingOfSolid()
{
    Json device { { "schema", "antinode.device/1" },
                  { "name", "solid" },
                  { "kind", "plate" },
                  { "length_x_mm", 120 },
                  { "length_y_mm", 80 },
                  { "thickness_mm", 1 },
                  { "material",
                    { { "youngs_modulus_GPa", 70 }, { "poisson_ratio", 0.33 }, { "density_kg_m3", 2700 } } },
                  { "edges", { { "left", "free" }, { "right", "free" }, { "bottom", "free" }, { "top", "free" } } },
                  { "points", Json::array() },
                  { "damping_ratio", 0.0035 },
                  { "ceramics", Json::array() },
                  { "limits", { { "voltage_V", 1000 } } } };

    for (const auto x : { 10, 110 })
        for (const auto y : { 10, 70 })
            device["points"].push_back ({ { "x_mm", x }, { "y_mm", y }, { "stiffness_N_per_mm", 0.2 } });

    for (const auto& corner : data()["lower_left_mm"])
        device["ceramics"].push_back ({ { "x_mm", corner[0] },
                                        { "y_mm", corner[1] },
                                        { "size_x_mm", 10 },
                                        { "size_y_mm", 10 },
                                        { "thickness_mm", 0.5 },
                                        { "material", "PZT-5A" },
                                        { "mounting", "one_side" } });

    return device.dump();
}

FrequencyResponses responsesOfSolid (const Eigen::MatrixX2d& places, double highest)
{
    constexpr double lowest = 250, step = 2; // Hz
    const auto plate = solidPlate (0);
    const auto& model = plate.model;
    const auto shapes = shapesAtPlaces (model, places);
    const auto lines = static_cast<Eigen::Index> ((highest - lowest) / step);
    FrequencyResponses responses;
    responses.frequencies = Eigen::VectorXd::LinSpaced (lines, lowest, lowest + step * static_cast<double> (lines - 1));
    responses.points = places;
    RandomNumbers random (1);

    for (Eigen::Index i = 0; i < model.actuators(); ++i)
    {
        responses.references.push_back ({ model.ceramics[static_cast<std::size_t> (i)].name, {} });
        Eigen::MatrixXcd values (lines, shapes.rows());

        for (Eigen::Index line = 0; line < lines; ++line)
        {
            const std::complex<double> s (0, 2 * std::numbers::pi * responses.frequencies[line]);
            const Eigen::VectorXcd modal =
                model.participation.col (i).array() * s
                / (s * s + 2 * model.dampingRatios.array() * model.angularFrequencies.array() * s
                   + model.angularFrequencies.array().square());
            values.row (line) = (shapes * modal).transpose();
        }

        const auto noise = values.norm() / std::sqrt (2.0 * static_cast<double> (values.size())) / 316;
        values.real() += noise * random.normal (values.size()).reshaped (lines, shapes.rows());
        values.imag() += noise * random.normal (values.size()).reshaped (lines, shapes.rows());
        responses.values.push_back (std::move (values));
    }

    return responses;
}

WideModel measuredSolid (double highest)
{
    constexpr double lowest = 300; // Hz: the pads' modes are below
    const auto plate = solidPlate (0);
    std::vector<Eigen::Index> modes;

    for (Eigen::Index k = 0; k < plate.model.modes(); ++k)
        if (plate.model.frequencyHz (k) > lowest && plate.model.frequencyHz (k) < highest)
            modes.push_back (k);

    Eigen::MatrixX2d points (96, 2);

    for (Eigen::Index i = 0; i < points.rows(); ++i)
        points.row (i) << 0.005 + 0.01 * static_cast<double> (i / 8), 0.005 + 0.01 * static_cast<double> (i % 8);

    auto model = plate.model;
    model.shapes = shapesAtPlaces (plate.model, points) (Eigen::all, modes);
    model.surface = surfaceOf (points);
    model.angularFrequencies = plate.model.angularFrequencies (modes);
    model.dampingRatios = plate.model.dampingRatios (modes);
    model.participation = plate.model.participation (modes, Eigen::all);
    model.coversWholeBody = false;
    model.origin = { ModeSource::measured, 96, 0.002 };
    return { model, model.modes(), {} };
}

Eigen::VectorXd atPoints (const ModalModel& model, const Eigen::VectorXd& field, const Eigen::MatrixX2d& points)
{
    auto one = model;
    one.shapes = field;
    one.slopes.resize (0, 0);
    one.angularFrequencies = model.angularFrequencies.head (1);
    one.dampingRatios = model.dampingRatios.head (1);
    one.participation = model.participation.topRows (1);
    return shapesAtPlaces (one, points);
}

PlayedOnSolid playOnSolid (const SolidPlate& plate, const Eigen::MatrixXd& voltages, double rate,
                           const Eigen::MatrixXd& sensors, double focusTime)
{
    constexpr Eigen::Index finer = 8;
    const auto& model = plate.model;
    const auto h = 1 / (rate * finer);
    // From the first sample on.
    const Eigen::MatrixXd fine = interpolated (voltages.transpose(), finer)
                                     .transpose()
                                     .rightCols ((voltages.cols() - 1 + kaiserSincHalfWidth) * finer + 1);
    const Eigen::MatrixXd forces = model.participation * fine;
    const Eigen::ArrayXd omega = model.angularFrequencies.array(), damping = model.dampingRatios.array();
    Eigen::ArrayXcd pole (omega.size());
    pole.real() = -damping * omega;
    pole.imag() = omega * (1 - damping.square()).sqrt();
    const Eigen::ArrayXcd growth = (pole * h).exp(), slope = (growth - 1 - pole * h) / (pole.square() * h),
                          constant = (growth - 1) / pole - slope;
    Eigen::ArrayXcd state = Eigen::ArrayXcd::Zero (omega.size()); // q' - conj (pole) q
    const auto focus = static_cast<Eigen::Index> (std::llround (focusTime / h));
    PlayedOnSolid played { {}, Eigen::MatrixXd (sensors.rows(), voltages.cols()) };
    const auto velocities = [&]() -> Eigen::VectorXd
    { return (state + pole.conjugate() * (state.imag() / pole.imag())).real().matrix(); };

    for (Eigen::Index n = 0; n < voltages.cols() * finer; ++n)
    {
        if (n % finer == 0)
            played.signals.col (n / finer) = sensors * velocities();

        if (n == focus)
            played.field =
                model.shapes * velocities() + plate.residual * (fine.col (n + 1) - fine.col (n - 1)) / (2 * h);

        state = growth * state + forces.col (n).array() * constant + forces.col (n + 1).array() * slope;
    }

    return played;
}
} // namespace antinode
