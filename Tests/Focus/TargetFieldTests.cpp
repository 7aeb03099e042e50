#include "Support/SinePlate.h"

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
    const auto half = scoreField (surface, scaled, wanted);
    CHECK (half.vScore == Approx (1).epsilon (1e-14));
    CHECK (half.fieldError == Approx (0.5));
    CHECK (scoreField (surface, -wanted, wanted).vScore == Approx (-1).epsilon (1e-14));
    CHECK (scoreField (surface, Eigen::VectorXd::Zero (101), wanted).vScore == 0);
}

TEST_CASE ("Contrast compares the peak with what moves outside the spot", "[focus]")
{
    auto surface = lineSurface (101, 0.1);
    Eigen::VectorXd field = Eigen::VectorXd::Constant (101, 0.1);
    field[50] = 2;
    CHECK (fieldContrast (surface, field, { sincAt (0, 0.01, 1) }, 2) == Approx (20));
    CHECK (fieldContrast (surface, field, { sincAt (0, 0.2, 1) }, 2) == 0);
}

TEST_CASE ("A separable target is the product of its profiles in x and y, each with a width of its own", "[focus]")
{
    const auto surface = test::SinePlate().surface();
    const Target target { TargetShape::sinc, 0.09, 0.06, 0.03, 0.04, -1, TargetProfile::separable, 0.02 };
    const auto field = targetField (surface, { target }, {});
    const Eigen::ArrayXd x = (surface.points.col (0).array() - 0.09) * 3.790988534 / 0.03;
    const Eigen::ArrayXd y = (surface.points.col (1).array() - 0.06) * 3.790988534 / 0.02;
    CHECK ((field.array() + 0.04 * (x.sin() / x) * (y.sin() / y)).abs().maxCoeff() < 1e-10);

    auto square = target;
    square.widthY.reset();
    CHECK (targetField (surface, { square }, {})[0]
           == Approx (-0.04 * std::sin (x[0]) / x[0] * std::sin (y[0] * 2 / 3) / (y[0] * 2 / 3)));
}

TEST_CASE ("A separable gaussian of one width is the radial one", "[focus]")
{
    const auto surface = test::SinePlate().surface();
    Target target { TargetShape::gaussian, 0.09, 0.06, 0.03, 0.04, 1 };
    const auto radial = targetField (surface, { target }, {});
    target.profile = TargetProfile::separable;
    CHECK ((targetField (surface, { target }, {}) - radial).cwiseAbs().maxCoeff() < 1e-16);
}

TEST_CASE ("On a line a separable target is a radial one", "[focus]")
{
    const auto surface = lineSurface (301, 0.15);
    auto target = sincAt (0.02, 0.01, 0.04);
    const auto radial = targetField (surface, { target }, {});
    target.profile = TargetProfile::separable;
    target.y = 0.1;
    CHECK ((targetField (surface, { target }, {}) - radial).cwiseAbs().maxCoeff() == 0);
}

TEST_CASE ("Several foci on a plate add up with their phases", "[focus]")
{
    const auto surface = test::SinePlate().surface();
    const Target one { TargetShape::sinc, 0.05, 0.05, 0.03, 0.04, 1 };
    const Target other { TargetShape::bump, 0.15, 0.1, 0.04, 0.02, -1, TargetProfile::separable, 0.03 };
    const Eigen::VectorXd sum = targetField (surface, { one }, {}) + targetField (surface, { other }, {});
    CHECK ((targetField (surface, { one, other }, {}) - sum).cwiseAbs().maxCoeff() < 1e-16);
}

TEST_CASE ("The window tapers at held edges only", "[focus]")
{
    auto surface = test::SinePlate().surface();
    surface.held = { true, false, false, true };
    const std::vector<Target> targets { { TargetShape::sinc, 0.09, 0.06, 0.03, 0.04, 1 } };
    const auto plain = targetField (surface, targets, {});
    const auto windowed = targetField (surface, targets, 0.5);

    for (Eigen::Index i = 0; i < plain.size(); ++i)
    {
        // Tapers of 50 mm at the left and of 37.5 mm at the top; in the middle of each the cosine is 1/2.
        const auto x = surface.points (i, 0), fromTop = 0.15 - surface.points (i, 1);
        const auto taper = [] (double distance, double length)
        { return distance >= length ? 1.0 : std::pow (std::sin (0.5 * 3.141592653589793 * distance / length), 2); };
        CHECK (windowed[i] == Approx (plain[i] * taper (x, 0.05) * taper (fromTop, 0.0375)).margin (1e-16));
    }

    auto line = lineSurface (301, 0.15);
    line.held = { false, true, false, false };
    const auto onLine = targetField (line, { sincAt (0.01, 0.05, 0.04) }, 0.4);
    CHECK (onLine[0] == targetField (line, { sincAt (0.01, 0.05, 0.04) }, {})[0]);
    CHECK (onLine[300] == Approx (0).margin (1e-17));
}

TEST_CASE ("Contrast on a plate weights by area and leaves out a spot as wide as the target in each direction",
           "[focus]")
{
    // 1 on the left half outside the spot, 0 elsewhere, peak 3: the mean square is the share of the area, whatever the
    // points.
    const test::SinePlate plate { .segments = 20, .placesPerSegment = 6 };
    const auto surface = plate.surface();
    Eigen::VectorXd field = (surface.points.col (0).array() < 0.1).cast<double>();
    const Target target { TargetShape::sinc, 0.15, 0.075, 0.02, 1, 1, TargetProfile::separable, 0.04 };
    const auto spot = [&] (Eigen::Index i, double scale)
    {
        const auto dx = (surface.points (i, 0) - 0.15) / 0.02, dy = (surface.points (i, 1) - 0.075) / 0.04;
        return dx * dx + dy * dy < scale * scale;
    };

    for (Eigen::Index i = 0; i < field.size(); ++i)
        if (spot (i, 0.99))
            field[i] = 3;

    // Outside of the ellipse, half of the plate moves. The ellipse's edge crosses cells of some 2 mm: 1 % of its area.
    const auto whole = 0.2 * 0.15, ellipse = 3.141592653589793 * 0.02 * 0.04;
    CHECK (fieldContrast (surface, field, { target }, -3)
           == Approx (3 / std::sqrt (0.5 * whole / (whole - ellipse))).epsilon (0.01));
}
