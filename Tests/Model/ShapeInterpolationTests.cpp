#include <antinode_base/InputError.h>
#include <antinode_model/ModalModel.h>
#include <antinode_model/ShapeInterpolation.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>

using namespace antinode;

namespace
{
/** One cubic mode on a line of uneven points: phi = x^3 - 2 x. */
ModalModel cubicLine()
{
    ModalModel model;
    model.name = "cubic";
    model.surface.xMinimum = -1;
    model.surface.xMaximum = 2;
    model.surface.points.resize (4, 2);
    model.surface.points << -1, 0, 0.3, 0, 0.9, 0, 2, 0;
    model.surface.masses = Eigen::Vector4d::Ones();
    model.surface.areas = Eigen::Vector4d::Ones();
    const Eigen::ArrayXd x = model.surface.points.col (0);
    model.shapes = (x.cube() - 2 * x).matrix();
    model.slopes = (3 * x.square() - 2).matrix();
    model.angularFrequencies = Eigen::VectorXd::Constant (1, 100.0);
    model.dampingRatios = Eigen::VectorXd::Constant (1, 0.01);
    model.participation = Eigen::MatrixXd::Zero (1, 0);
    return model;
}
} // namespace

TEST_CASE ("Hermite interpolation on a line is exact for a cubic", "[model]")
{
    const auto model = cubicLine();

    for (const auto x : { -1.0, -0.4, 0.3, 0.77, 1.5, 2.0 })
        CHECK (shapesAt (model, x, 0)[0] == Approx (x * x * x - 2 * x).margin (1e-14));
}

TEST_CASE ("A position outside the surface is an error that names the extent", "[model]")
{
    CHECK_THROWS_WITH (shapesAt (cubicLine(), 2.1, 0),
                       Catch::Contains ("outside the surface of")
                           && Catch::Contains ("; allowed: x from -1000 mm to 2000 mm"));
}

TEST_CASE ("Natural spline slopes approach the derivative of a sine to fourth order", "[model]")
{
    const auto worst = [] (int n)
    {
        const Eigen::VectorXd x = Eigen::VectorXd::LinSpaced (n, 0, 2 * std::numbers::pi);
        const Eigen::MatrixXd slopes = naturalSplineSlopes (x, x.array().sin().matrix());
        return (slopes.col (0).array() - x.array().cos()).abs().maxCoeff();
    };
    CHECK (worst (41) < 2e-5);
    // sin'' is zero at both ends, so the natural ends cost no order.
    CHECK (worst (81) < worst (41) / 7);
}

TEST_CASE ("The thin-plate spline is exact at its points and for planes", "[model]")
{
    Eigen::MatrixX2d points (30, 2);
    Eigen::MatrixXd values (30, 2);

    for (int i = 0; i < 30; ++i)
    {
        const auto x = std::fmod (0.618034 * i, 1.0);
        const auto y = i / 30.0;
        points.row (i) << x, y;
        values.row (i) << 1 + 2 * x - 3 * y, std::sin (3 * x) * std::cos (2 * y);
    }

    CHECK (interpolateInPlane (points, values, 0.41, 0.52)[0] == Approx (1 + 2 * 0.41 - 3 * 0.52).margin (1e-10));
    CHECK (interpolateInPlane (points, values, points (7, 0), points (7, 1))[1]
           == Approx (values (7, 1)).margin (1e-10));
    CHECK (interpolateInPlane (points, values, 0.5, 0.5)[1] == Approx (std::sin (1.5) * std::cos (1.0)).margin (0.02));
}

TEST_CASE ("Collinear points of a plane still interpolate", "[model]")
{
    Eigen::MatrixX2d points (3, 2);
    points << 0, 0, 0.5, 0, 1, 0;
    CHECK (interpolateInPlane (points, Eigen::Vector3d (0, 1, 2), 0.25, 0)[0] == Approx (0.5).margin (1e-9));
}

TEST_CASE ("A model is checked for what it must fulfil", "[model]")
{
    auto model = cubicLine();
    CHECK_NOTHROW (validate (model));
    model.dampingRatios[0] = 1;
    CHECK_THROWS_WITH (validate (model), Catch::Contains ("damping ratio"));
    model = cubicLine();
    model.shapes (1, 0) = std::numeric_limits<double>::quiet_NaN();
    CHECK_THROWS_AS (validate (model), InputError);
    model = cubicLine();
    model.surface.points (1, 0) = -1;
    CHECK_THROWS_WITH (withSplineSlopes (model), Catch::Contains ("ascend"));
}
