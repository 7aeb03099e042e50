#include "ScoreTools.h"

namespace antinode::scores
{
OutlineScore levyPlates (int cases, unsigned seed)
{
    Random random (seed);
    OutlineScore score { "rectangles, two sides supported, two on springs, 20 modes" };

    for (int i = 0; i < cases; ++i)
    {
        const auto b = random.between (0.4, 1), ratio = random.between (0.1, 0.4);
        const EdgeSupport low { false, false, random.byDecades (1, 3e3), random.byDecades (0.05, 20) };
        const EdgeSupport high { false, false, random.byDecades (1, 3e3), random.byDecades (0.05, 20) };
        const auto problem = unitPlate (ratio, { rectanglePath ({ 0.5, b / 2 }, { 1, b }, 0, { 0, 0, 0, 0 }, 0) },
                                        { low, supportedEdge, high, supportedEdge });
        const auto found = frequencies (timed (score, problem, 20, resolutionFor (problem, 20, ModeAccuracy::usual)));
        std::vector<double> exact;

        // w = sin (m pi x) f (y): f of cos, sin, cosh, sinh, the last two by exponentials of the sides.
        for (int m = 1; m < 12; ++m)
        {
            const auto mu = m * pi;
            const auto determinant = [&] (double omega)
            {
                const auto p = std::sqrt (omega + mu * mu), q2 = omega - mu * mu, q = std::sqrt (std::abs (q2));
                Eigen::Matrix4d rows;

                for (int column = 0; column < 4; ++column)
                {
                    const auto values = [&] (double y) -> Eigen::Vector4d // f, f', f'', f'''
                    {
                        if (column < 2)
                        {
                            const auto s = column == 0 ? -1.0 : 1.0, e = std::exp (column == 0 ? -p * y : p * (y - b));
                            return { e, s * p * e, p * p * e, s * p * p * p * e };
                        }

                        const auto wave = column == 2;

                        if (q2 >= 0)
                        {
                            const auto c = std::cos (q * y), s = std::sin (q * y);
                            return wave ? Eigen::Vector4d (c, -q * s, -q * q * c, q * q * q * s)
                                        : Eigen::Vector4d (s, q * c, -q * q * s, -q * q * q * c);
                        }

                        const auto c = std::cosh (q * y), s = std::sinh (q * y);
                        return wave ? Eigen::Vector4d (c, q * s, q * q * c, q * q * q * s)
                                    : Eigen::Vector4d (s, q * c, q * q * s, q * q * q * c);
                    };
                    const auto side = [&] (double y, double sign, const EdgeSupport& support, int row)
                    {
                        const auto f = values (y);
                        rows (row, column) = f[2] - ratio * mu * mu * f[0] + sign * support.rotation * f[1];
                        rows (row + 1, column) =
                            f[3] - (2 - ratio) * mu * mu * f[1] - sign * support.translation * f[0];
                    };
                    side (0, -1, low, 0);
                    side (b, 1, high, 2);
                }

                for (int row = 0; row < 4; ++row)
                    rows.row (row).normalize();

                return rows.determinant();
            };

            for (const auto root : rootsOf (determinant, 0.5, 1.1 * found[19], 4000))
                if (std::abs (root - mu * mu) > 1e-6 * root) // there both waves are lines
                    exact.push_back (root);
        }

        std::sort (exact.begin(), exact.end());
        exact.resize (20);
        note (score.frequencyError, deviationFrom (found, exact));
    }

    return score;
}

OutlineScore attachedPoints (int cases, unsigned seed)
{
    Random random (seed);
    OutlineScore score { "a mass or a spring at a point of a supported rectangle, 20 modes" };

    for (int i = 0; i < cases; ++i)
    {
        const auto b = random.between (0.5, 1);
        const PointAttachment point { { random.between (0.1, 0.9), random.between (0.1, b - 0.1) },
                                      i % 2 == 0 ? 0 : random.between (20, 500),
                                      i % 2 == 0 ? random.between (0.01, 0.1) : 0 };
        auto problem =
            unitPlate (0.3, { rectanglePath ({ 0.5, b / 2 }, { 1, b }, 0, { 0, 0, 0, 0 }, 0) }, { 4, supportedEdge });
        problem.points = { point };
        const auto found = frequencies (timed (score, problem, 20, resolutionFor (problem, 20, ModeAccuracy::usual)));
        constexpr int waves = 1000;
        Eigen::ArrayXXd squares (waves, waves), eigenvalues (waves, waves);

        for (int n = 0; n < waves; ++n)
            for (int m = 0; m < waves; ++m)
            {
                const auto kx = (m + 1) * pi, ky = (n + 1) * pi / b;
                squares (m, n) =
                    std::pow (2 / std::sqrt (b) * std::sin (kx * point.place.x()) * std::sin (ky * point.place.y()), 2);
                eigenvalues (m, n) = std::pow (kx * kx + ky * ky, 2);
            }

        // 1 + (k - M omega^2) sum phi^2 / (omega_mn^2 - omega^2) at a frequency that is right, in units of its slope.
        for (Eigen::Index k = 0; k < 20; ++k)
        {
            const auto lambda = found[k] * found[k];
            const auto distance = (eigenvalues - lambda).eval();

            if (distance.abs().minCoeff() < 1e-5 * lambda)
                continue; // It does not move there, or hardly.

            const auto strength = point.stiffness - point.mass * lambda;
            const auto receptance = (squares / distance).sum();
            const auto slope = strength * (squares / distance.square()).sum() - point.mass * receptance;
            note (score.frequencyError, std::abs ((1 + strength * receptance) / slope / lambda / 2));
        }
    }

    return score;
}
} // namespace antinode::scores
