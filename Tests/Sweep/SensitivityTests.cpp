#include <antinode_sweep/Sensitivity.h>
#include <antinode_sweep/SweepCases.h>

#include <catch2/catch.hpp>

#include <array>
#include <cmath>
#include <limits>
#include <numbers>

using namespace antinode;

namespace
{
constexpr double ishigamiA = 7, ishigamiB = 0.1;

double ishigami (const std::vector<nlohmann::json>& x)
{
    const auto at = [&] (std::size_t i) { return x[i].get<double>(); };
    return std::sin (at (0)) + ishigamiA * std::pow (std::sin (at (1)), 2)
           + ishigamiB * std::pow (at (2), 4) * std::sin (at (0));
}

SweepPlan ishigamiPlan()
{
    constexpr auto base = 4096, inputs = 3;
    SweepPlan plan;
    plan.scheme = SweepScheme::saltelli;
    plan.cases = base * (inputs + 2);
    const Distribution circle { DistributionKind::uniform, -std::numbers::pi, std::numbers::pi };

    for (int i = 0; i < inputs; ++i)
        plan.vary.push_back ({ { "device.x" + std::to_string (i) }, {}, circle, { 1 }, { 0 } });

    return plan;
}

Eigen::VectorXd ishigamiResults (const SweepPlan& plan)
{
    Eigen::VectorXd results (plan.cases);

    for (Eigen::Index i = 0; i < results.size(); ++i)
        results[i] = ishigami (caseValues (plan, static_cast<std::uint64_t> (i)));

    return results;
}
} // namespace

TEST_CASE ("Sobol's indices of Ishigami's function are those of its closed form", "[sweep]")
{
    // Ishigami and Homma 1990: variances of the parts.
    const auto pi4 = std::pow (std::numbers::pi, 4), pi8 = pi4 * pi4;
    const auto first = 0.5 * std::pow (1 + ishigamiB * pi4 / 5, 2), second = ishigamiA * ishigamiA / 8;
    const auto both = ishigamiB * ishigamiB * pi8 * (1.0 / 18 - 1.0 / 50);
    const auto all = first + second + both;
    const auto plan = ishigamiPlan();
    const auto indices = sobolIndices (ishigamiResults (plan), 3, 1);
    REQUIRE (indices.size() == 3);
    const std::array expected { std::pair { first / all, (first + both) / all },
                                std::pair { second / all, second / all }, std::pair { 0.0, both / all } };

    for (std::size_t i = 0; i < expected.size(); ++i)
    {
        // A low-discrepancy sequence of 4096 points: errors well below those of random ones, 1/sqrt (4096) = 0.016.
        CHECK (indices[i].first.value == Approx (expected[i].first).margin (0.01));
        CHECK (indices[i].total.value == Approx (expected[i].second).margin (0.01));
        CHECK (indices[i].first.lower <= expected[i].first);
        CHECK (indices[i].first.upper >= expected[i].first);
        CHECK (indices[i].total.lower <= expected[i].second);
        CHECK (indices[i].total.upper >= expected[i].second);
        CHECK (indices[i].first.upper - indices[i].first.lower < 0.15);
    }
}

TEST_CASE ("Sobol's indices leave out base cases of which a case failed", "[sweep]")
{
    const auto plan = ishigamiPlan();
    auto results = ishigamiResults (plan);
    const auto whole = sobolIndices (results, 3, 1);

    for (Eigen::Index i = 3; i < results.size(); i += 400)
        results[i] = std::numeric_limits<double>::quiet_NaN();

    const auto some = sobolIndices (results, 3, 1);
    REQUIRE (some.size() == 3);
    CHECK (some[1].total.value == Approx (whole[1].total.value).margin (0.02));
    CHECK (sobolIndices (Eigen::VectorXd::Constant (100, 2), 3, 1).empty());
}

TEST_CASE ("Rank correlation is 1 for what rises together, however bent, and counts ties half", "[sweep]")
{
    const Eigen::VectorXd x = Eigen::VectorXd::LinSpaced (20, 0, 5);
    CHECK (rankCorrelation (x, x.array().exp()) == Approx (1));
    CHECK (rankCorrelation (x, -x.array().cube()) == Approx (-1));
    CHECK (rankCorrelation (x, Eigen::VectorXd::Ones (20)) == 0);
    // Kendall, Rank correlation methods: ranks 1 2.5 2.5 4 against 1 2 3 4: sqrt (0.9).
    CHECK (rankCorrelation (Eigen::Vector4d (1, 2, 2, 3), Eigen::Vector4d (1, 2, 3, 4))
           == Approx (4.5 / std::sqrt (4.5 * 5)));
}
