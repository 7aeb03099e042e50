#include <antinode_focus/FocusScore.h>
#include <antinode_focus/TargetField.h>

#include <catch2/catch.hpp>

#include <cmath>

using namespace antinode;

namespace
{
Surface lineSurface (int points, double length)
{
    Surface surface;
    surface.xMinimum = -length / 2;
    surface.xMaximum = length / 2;
    surface.points = Eigen::MatrixX2d::Zero (points, 2);
    surface.points.col (0) = Eigen::VectorXd::LinSpaced (points, surface.xMinimum, surface.xMaximum);
    surface.masses = Eigen::VectorXd::Constant (points, 0.1);
    surface.areas = Eigen::VectorXd::Constant (points, 1e-4);
    return surface;
}

Target sincAt (double x, double width, double velocity, int phase = 1)
{
    return { TargetShape::sinc, x, 0, width, velocity, phase };
}
} // namespace

TEST_CASE ("Every target shape is 1 at its centre and 1/2 at half its full width at half maximum", "[focus]")
{
    for (const auto shape : { TargetShape::sinc, TargetShape::bump, TargetShape::gaussian })
    {
        CHECK (targetProfile (shape, 0, 0.025) == Approx (1).epsilon (1e-14));
        CHECK (targetProfile (shape, 0.0125, 0.025) == Approx (0.5).epsilon (1e-12));
    }
}

TEST_CASE ("Sinc and bump have the widths of the paper: 3.790988 / a and 1.279662 a", "[focus]")
{
    // sinc (a r) first crosses zero at a r = pi; with FWHM = 3.790988 / a (half of sin x / x at x = 1.895494).
    const auto width = 0.018;
    const auto a = 3.790988534 / width;
    CHECK (targetProfile (TargetShape::sinc, 3.141592653589793 / a, width) == Approx (0).margin (1e-9));
    CHECK (targetProfile (TargetShape::sinc, 1 / a, width) == Approx (std::sin (1.0)).epsilon (1e-9));

    // The bump e exp (-1 / (1 - u^2)), paper (34), ends at |u| = 1 and is half of its peak at u^2 = ln 2 / (1 + ln 2).
    const auto end = width / 2 / std::sqrt (std::log (2.0) / (1 + std::log (2.0)));
    CHECK (targetProfile (TargetShape::bump, end * 1.0001, width) == 0);
    CHECK (targetProfile (TargetShape::bump, end * 0.5, width) == Approx (std::exp (1 - 1 / 0.75)).epsilon (1e-12));
    CHECK (width / end == Approx (1.2796622849).epsilon (1e-10));
}

TEST_CASE ("Targets add up with their phases", "[focus]")
{
    const auto surface = lineSurface (301, 0.15);
    const auto one = targetField (surface, { sincAt (0.02, 0.01, 0.04) }, {});
    const auto other = targetField (surface, { sincAt (-0.03, 0.02, 0.01, -1) }, {});
    const auto both = targetField (surface, { sincAt (0.02, 0.01, 0.04), sincAt (-0.03, 0.02, 0.01, -1) }, {});
    CHECK ((both - one - other).cwiseAbs().maxCoeff() < 1e-16);
    CHECK (one.maxCoeff() == Approx (0.04).epsilon (1e-12));
    CHECK (other.minCoeff() == Approx (-0.01).epsilon (1e-12));
}

TEST_CASE ("The Tukey window takes the field to zero at the ends and leaves its middle alone", "[focus]")
{
    const auto surface = lineSurface (301, 0.15);
    const auto plain = targetField (surface, { sincAt (0.01, 0.05, 0.04) }, {});
    const auto windowed = targetField (surface, { sincAt (0.01, 0.05, 0.04) }, 0.4);
    CHECK (windowed[0] == 0);
    CHECK (windowed[300] == Approx (0).margin (1e-17));
    CHECK (windowed[150] == plain[150]);
    // Half of the taper (0.4 * 0.15 m / 2 = 30 mm) from the end: half of the field.
    CHECK (windowed[30] == Approx (plain[30] / 2));
}

TEST_CASE ("A plate's targets are radial", "[focus]")
{
    Surface surface = lineSurface (3, 1);
    surface.kind = SurfaceKind::plate;
    surface.points << 0.1, 0.1, 0.1 + 0.003, 0.1 + 0.004, 0.1 - 0.005, 0.1;
    const auto field = targetField (surface, { { TargetShape::gaussian, 0.1, 0.1, 0.01, 1.0, 1 } }, {});
    CHECK (field[0] == Approx (1));
    CHECK (field[1] == Approx (0.5));
    CHECK (field[2] == Approx (0.5));
}

TEST_CASE ("The v-score is Pearson's correlation: blind to amplitude and offset, not to shape", "[focus]")
{
    const auto surface = lineSurface (101, 0.1);
    const auto wanted = targetField (surface, { sincAt (0, 0.02, 1) }, {});
    const Eigen::VectorXd scaled = 0.5 * wanted;
    const auto same = scoreField (surface, wanted, wanted);
    CHECK (same.vScore == Approx (1).epsilon (1e-14));
    CHECK (same.fieldError == 0);
    CHECK (same.peakRatio == 1);
    const auto half = scoreField (surface, scaled, wanted);
    CHECK (half.vScore == Approx (1).epsilon (1e-14));
    CHECK (half.fieldError == Approx (0.5));
    CHECK (half.peakRatio == Approx (0.5));
    CHECK (scoreField (surface, -wanted, wanted).vScore == Approx (-1).epsilon (1e-14));
    CHECK (scoreField (surface, Eigen::VectorXd::Zero (101), wanted).vScore == 0);
}

TEST_CASE ("Contrast compares the peak with what moves outside the spot", "[focus]")
{
    auto surface = lineSurface (101, 0.1);
    Eigen::VectorXd field = Eigen::VectorXd::Constant (101, 0.1);
    field[50] = 2;
    CHECK (fieldContrast (surface, field, { sincAt (0, 0.01, 1) }) == Approx (20));
    CHECK (fieldContrast (surface, field, { sincAt (0, 0.2, 1) }) == 0);
}
