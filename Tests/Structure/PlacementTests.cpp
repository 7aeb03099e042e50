#include "PlateExamples.h"

#include <antinode_base/InputError.h>
#include <antinode_documents/Inputs.h>
#include <antinode_outline/PathBuilder.h>
#include <antinode_structure/Placing.h>

#include <random>

using namespace antinode;
using namespace antinode::examples;

namespace
{
DeviceDescription makeDevice (const PlateDescription& plate)
{
    return { "plate", "", plate };
}

PlacingOptions optionsFor (Eigen::Index count, int modes, double step)
{
    PlacingOptions options;
    options.count = count;
    options.grid.step = step;
    options.grid.modes = modes;
    return options;
}

Eigen::MatrixXd randomMatrix (Eigen::Index rows, Eigen::Index columns)
{
    std::mt19937 random (5);
    return Eigen::MatrixXd::NullaryExpr (rows, columns,
                                         [&] { return static_cast<double> (random()) / 2147483648.0 - 1; });
}
} // namespace

TEST_CASE ("The kernel of terminal velocities against quadrature", "[structure][placement]")
{
    const Eigen::Vector3d omega (1000, 1010, 4000), damping (0.01, 0.02, 0.005);
    const auto duration = 0.02;
    const auto kernel = velocityKernel (omega, damping, duration);
    constexpr int steps = 200000;
    Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();

    for (int i = 0; i < steps; ++i)
    {
        const auto t = (i + 0.5) * duration / steps;
        Eigen::Vector3d h;

        for (int k = 0; k < 3; ++k)
        {
            const auto a = damping[k] * omega[k], b = omega[k] * std::sqrt (1 - damping[k] * damping[k]);
            h[k] = std::exp (-a * t) * (std::cos (b * t) - a / b * std::sin (b * t));
        }

        sum += h * h.transpose() * duration / steps;
    }

    CHECK ((kernel - sum).norm() < 1e-8 * sum.norm());
}

TEST_CASE ("One ceramic for the lowest mode of a supported plate goes to its middle", "[structure][placement]")
{
    const auto placed = placeCeramics (makeDevice (barePlate ("SSSS", 0.2, 0.12)), plateCeramic (0, 0, 0.02, 0.02),
                                       optionsFor (1, 1, 0.01));
    REQUIRE (placed.ceramics.size() == 1);
    CHECK (placed.ceramics[0].x == Approx (0.09));
    CHECK (placed.ceramics[0].y == Approx (0.05));
    CHECK (placed.ceramics[0].name == "C1");
    CHECK (placed.resolved.value() > 0);
}

TEST_CASE ("Ceramics keep a margin from free edges, not from held ones", "[structure][placement]")
{
    auto options = optionsFor (1, 3, 0.01);
    options.grid.freeEdgeMargin = 0.002;
    const auto plate = barePlate ("CFFS", 0.2, 0.12); // left, bottom, right, top
    const auto candidates = placementCandidates (makeDevice (plate), plateCeramic (0, 0, 0.02, 0.02), options.grid);
    const auto range = [&] (auto member)
    {
        const auto [low, high] =
            std::minmax_element (candidates.ceramics.begin(), candidates.ceramics.end(),
                                 [&] (const auto& a, const auto& b) { return a.*member < b.*member; });
        return std::pair { *low.*member, *high.*member };
    };
    const auto [left, right] = range (&CeramicDescription::x);
    const auto [bottom, top] = range (&CeramicDescription::y);
    const auto expect = [] (double value, EdgeCondition edge, double flush, double inside)
    { CHECK (value == Approx (edge == EdgeCondition::free ? inside : flush).margin (1e-12)); };
    expect (left, plate.left, 0, 0.002);
    expect (right, plate.right, 0.18, 0.178);
    expect (bottom, plate.bottom, 0, 0.002);
    expect (top, plate.top, 0.1, 0.098);
    REQUIRE (plate.right == EdgeCondition::free);

    // Without room for the margin it shrinks: one position, in the middle of what is left.
    const auto tight = placementCandidates (makeDevice (plate), plateCeramic (0, 0, 0.199, 0.02), options.grid);
    CHECK (tight.ceramics.front().x + 0.199 <= 0.2 + 1e-12);
}

TEST_CASE ("One ceramic for the lowest mode of a cantilever goes to its clamp", "[structure][placement]")
{
    auto beam = uniformBeam (EdgeCondition::clamped, EdgeCondition::free);
    auto options = optionsFor (1, 1, 0.005);
    options.isResolved = false;
    const auto placed = placeCeramics ({ "beam", "", beam }, ceramicPair (0, 0.02, 0.01, 0.5e-3), options);
    CHECK (placed.ceramics[0].x == Approx (-0.1));
    CHECK_FALSE (placed.resolved.has_value());
}

TEST_CASE ("Exchange reaches at least 95 % of the best of all choices", "[structure][placement]")
{
    const Eigen::MatrixXd participation = randomMatrix (6, 18);
    PlacementProblem problem;
    problem.kernel = Eigen::MatrixXd::Identity (6, 6);
    problem.kernel.diagonal (1).setConstant (0.3);
    problem.kernel.diagonal (-1).setConstant (0.3);
    problem.participation = participation;
    problem.count = 3;
    problem.exclude = [] (Eigen::Index, Eigen::Index) { return false; };
    double best = 0;

    for (Eigen::Index a = 0; a < 18; ++a)
        for (Eigen::Index b = 0; b < a; ++b)
            for (Eigen::Index c = 0; c < b; ++c)
            {
                const std::vector<Eigen::Index> chosen { a, b, c };
                best = std::max (best, worstControllability (problem.kernel, participation (Eigen::all, chosen)));
            }

    const auto placement = searchPlacement (problem);
    CHECK (placement.controllability >= 0.95 * best);
    CHECK (placement.controllability
           == Approx (worstControllability (problem.kernel, participation (Eigen::all, placement.chosen))));
    CHECK (searchPlacement (problem).chosen == placement.chosen);
}

TEST_CASE ("Placed ceramics do not overlap and stay within the rim", "[structure][placement]")
{
    auto options = optionsFor (12, 20, 0.006);
    options.grid.edgeDistance = 0.01;
    double share = 0;
    const auto plate = barePlate ("FFFF", 0.15, 0.08);
    const auto placed = placeCeramics (makeDevice (plate), plateCeramic (0, 0, 0.012, 0.01), options,
                                       [&] (double now)
                                       {
                                           CHECK (now >= share);
                                           share = now;
                                       });
    REQUIRE (placed.ceramics.size() == 12);
    auto carrying = plate;
    carrying.common.ceramics = placed.ceramics;
    CHECK_NOTHROW (solved (carrying, 5));

    for (const auto& ceramic : placed.ceramics)
        CHECK (std::min ({ ceramic.x, ceramic.y, 0.15 - ceramic.x - 0.012, 0.08 - ceramic.y - 0.01 }) <= 0.01 + 1e-9);
}

TEST_CASE ("Better places than an ordinary layout", "[structure][placement]")
{
    // Plate A's own eight places against those that were searched for.
    const auto plate = patchedPlate();
    auto options = optionsFor (8, 30, 0.0125);
    options.isResolved = false;
    const auto placed = placeCeramics (makeDevice (plate), plate.common.ceramics[0], options);
    options.grid.step = 0.005; // All of its own places lie on this grid.
    const auto candidates = placementCandidates (makeDevice (plate), plate.common.ceramics[0], options.grid);
    const auto kernel = velocityKernel (candidates.angularFrequencies, candidates.dampingRatios, options.duration);
    std::vector<Eigen::Index> own;

    for (const auto& ceramic : plate.common.ceramics)
        for (std::size_t i = 0; i < candidates.ceramics.size(); ++i)
            if (std::hypot (candidates.ceramics[i].x - ceramic.x, candidates.ceramics[i].y - ceramic.y) < 1e-6)
                own.push_back (static_cast<Eigen::Index> (i));

    REQUIRE (own.size() == 8);
    const Eigen::VectorXd scale = candidates.participation.rowwise().norm() / std::sqrt (candidates.ceramics.size());
    const Eigen::VectorXd root = (8 * kernel.diagonal()).cwiseSqrt().cwiseProduct (scale).cwiseInverse();
    const auto before = worstControllability (root.asDiagonal() * kernel * root.asDiagonal(),
                                              candidates.participation (Eigen::all, own));
    CHECK (placed.controllability > 1.5 * before);
}

TEST_CASE ("Impossible placements are refused with the field", "[structure][placement]")
{
    const auto plate = makeDevice (barePlate ("SSSS", 0.1, 0.1));
    CHECK_THROWS_WITH (placeCeramics (plate, plateCeramic (0, 0, 0.2, 0.01), optionsFor (1, 1, 0.01)),
                       Catch::Contains ("placement: ceramic size: "));
    CHECK_THROWS_WITH (placeCeramics (plate, plateCeramic (0, 0, 0.06, 0.06), optionsFor (2, 1, 0.01)),
                       Catch::Contains ("placement: number of ceramics: is 2; ")
                           && Catch::Contains ("no room for another"));
    CHECK_THROWS_WITH (placeCeramics (plate, plateCeramic (0, 0, 0.01, 0.01), optionsFor (1, 1, 1e-5)),
                       Catch::Contains ("placement: step: "));
    CHECK_THROWS_WITH (placeCeramics (plate, plateCeramic (0, 0, 0.1, 0.1), optionsFor (1, 2, 0.01)),
                       Catch::Contains ("placement: number of modes: ") && Catch::Contains ("mode 2"));
}

TEST_CASE ("Candidates on a laminate on tape have its frequencies, losses and participations",
           "[structure][placement][outlined]")
{
    // A disc so thin that the plate does not feel it: solved with it, the plate says what the candidate should.
    OutlinedPlate plate;
    plate.common = plainCommon (1.25e-3);
    plate.common.dampingRatios.clear();
    const auto glass = findElasticMaterial ("glass").value();
    plate.common.layers = { { 0.7e-3, glass },
                            { 0.15e-3, findViscoelasticMaterial ("OCA").value() },
                            { 0.4e-3, glass } };
    plate.common.material = glass;
    plate.outline.paths = { rectanglePath ({ 0.05, 0.03 }, { 0.1, 0.06 }, 0, { 0.01, 0.01, 0.01, 0.01 }, 0),
                            circlePath ({ 0.08, 0.045 }, 0.006, 4) };
    plate.edges.assign (5, { EdgeCondition::free, 1e6, 0.3, 0.3 });
    plate.points = { { 0.02, 0.015, 1e4, 0, 0, 0 } };
    auto disc = plateCeramic (0, 0, 0.012, 0.012, 1e-6);
    disc.shape = CeramicShape::disc;
    disc.mounting = CeramicMounting::oneSide;
    const auto candidates = placementCandidates ({ "pane", "", plate }, disc, { 0.006, {}, 0.002, 12 });
    REQUIRE (candidates.ceramics.size() > 20);

    for (const auto& each : candidates.ceramics)
    {
        const auto centre = each.centre();
        CHECK (std::hypot (centre.x() - 0.08, centre.y() - 0.045) >= 0.006 + 0.006 - 1e-9);
        CHECK (distanceToBoundary (plate.outline, centre.x(), centre.y()) >= 0.006 - 1e-9);
        CHECK (std::hypot (centre.x() - 0.02, centre.y() - 0.015) >= 0.006 - 1e-9);
    }

    const auto chosen = candidates.ceramics.size() / 3;
    const auto model = solveStructure (withCeramics ({ "pane", "", plate }, { candidates.ceramics[chosen] }), 12);
    const auto participation = candidates.participation.col (static_cast<Eigen::Index> (chosen));
    const auto largest = participation.cwiseAbs().maxCoeff();

    for (Eigen::Index k = 0; k < 12; ++k)
    {
        CHECK (candidates.angularFrequencies[k] == Approx (model.angularFrequencies[k]).epsilon (2e-3));
        CHECK (candidates.dampingRatios[k] == Approx (model.dampingRatios[k]).epsilon (0.02));
        CHECK (std::abs (participation[k])
               == Approx (std::abs (model.participation (k, 0))).epsilon (0.02).margin (0.01 * largest));
    }
}

TEST_CASE ("Every embedded device has places for its ceramics by every option of positions", "[structure][placement]")
{
    constexpr double step = 0.01, rim = 0.02, margin = 0.003;

    for (const auto& name : factoryNames (LibraryKind::device))
    {
        INFO (name);
        const auto device = loadDevice (name, {});
        const auto ceramics = std::visit (
            [] (const auto& body)
            {
                if constexpr (requires { body.common; })
                    return body.common.ceramics;
                else
                    return std::vector<CeramicDescription> {};
            },
            device.body);

        for (const auto edgeDistance : { std::optional<double>(), std::optional (rim) })
        {
            auto like = ceramics.empty() ? plateCeramic (0, 0, 0.01, 0.01) : ceramics.front();
            const auto found = placementCandidates (device, like, { step, edgeDistance, margin, 6 });
            CHECK_FALSE (found.ceramics.empty());
            CHECK (found.participation.allFinite());
        }
    }
}
