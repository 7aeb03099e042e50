#include "StructureExamples.h"

#include <catch2/catch.hpp>

using namespace antinode;
using namespace antinode::examples;

namespace
{
/** The first roots beta L of Euler and Bernoulli's characteristic equations, solved to double precision; to fewer
   digits in R.D. Blevins, Formulas for Natural Frequency and Mode Shape (1979), table 8-1. */
struct BeamRoots
{
    EdgeCondition left, right;
    int rigidBodyModes;
    std::array<double, 12> roots;
};

constexpr auto clamped = EdgeCondition::clamped;
constexpr auto pinned = EdgeCondition::simplySupported;
constexpr auto loose = EdgeCondition::free;
constexpr auto guided = EdgeCondition::guided;

constexpr std::array<double, 12> clampedClamped { 4.730040744862704,  7.853204624095838,  10.995607838001671,
                                                  14.137165491257464, 17.278759657399483, 20.42035224562606,
                                                  23.561944902040455, 26.703537555508188, 29.84513020910326,
                                                  32.98672286269282,  36.12831551628263,  39.269908169872416 };
constexpr std::array<double, 12> clampedPinned { 3.9266023120479185, 7.068582745628732, 10.21017612281303,
                                                 13.351768777754094, 16.49336143134641, 19.634954084936208,
                                                 22.776546738526,    25.91813939211579, 29.059732045705587,
                                                 32.20132469929538,  35.34291735288517, 38.48451000647498 };
constexpr std::array<double, 12> clampedFree { 1.8751040687119611, 4.694091132974175,  7.854757438237611,
                                               10.995540734875467, 14.13716839104647,  17.27875953208824,
                                               20.42035225104125,  23.561944901806445, 26.7035375555183,
                                               29.845130209102823, 32.98672286269284,  36.128315516282626 };
constexpr std::array<double, 12> clampedGuided { 2.3650203724313528, 5.497803919000836,  8.639379828699742,
                                                 11.780972451020226, 14.922565104551627, 18.064157758141313,
                                                 21.205750411731103, 24.3473430653209,   27.488935718910692,
                                                 30.630528372500486, 33.77212102609028,  36.91371367968007 };
constexpr std::array<double, 12> pinnedPinned { 3.141592653589793,  6.283185307179586,  9.42477796076938,
                                                12.566370614359172, 15.707963267948966, 18.84955592153876,
                                                21.991148575128552, 25.132741228718345, 28.274333882308138,
                                                31.41592653589793,  34.55751918948772,  37.69911184307752 };
constexpr std::array<double, 12> pinnedGuided { 1.5707963267948966, 4.71238898038469,   7.853981633974483,
                                                10.995574287564276, 14.137166941154069, 17.27875959474386,
                                                20.420352248333657, 23.561944901923447, 26.703537555513243,
                                                29.845130209103033, 32.98672286269283,  36.12831551628262 };

// Exchanging clamped with free, and pinned with guided, changes shapes into their second derivatives and leaves the
// roots.
const std::array<BeamRoots, 10> cases { {
    { clamped, loose, 0, clampedFree },
    { clamped, clamped, 0, clampedClamped },
    { loose, loose, 2, clampedClamped },
    { clamped, pinned, 0, clampedPinned },
    { loose, pinned, 1, clampedPinned },
    { pinned, pinned, 0, pinnedPinned },
    { guided, guided, 1, pinnedPinned },
    { clamped, guided, 0, clampedGuided },
    { loose, guided, 1, clampedGuided },
    { pinned, guided, 0, pinnedGuided },
} };
} // namespace

TEST_CASE ("a uniform beam has the frequencies of its ends' characteristic equation", "[structure]")
{
    for (const auto& known : cases)
    {
        for (const auto reversed : { false, true })
        {
            const auto beam = reversed ? uniformBeam (known.right, known.left) : uniformBeam (known.left, known.right);
            const auto model = solved (beam, 12);
            const auto scale = stiffnessToMass (beam.common) / (beam.length * beam.length);
            REQUIRE (model.modes() == 12);
            CHECK (model.rigidBodyModes == known.rigidBodyModes);

            for (Eigen::Index k = 0; k < 12; ++k)
            {
                const auto root = known.roots[static_cast<std::size_t> (k)];
                const auto exact = root * root * scale;
                const auto error = std::abs (model.angularFrequencies[k] / exact - 1);
                CAPTURE (static_cast<int> (known.left), static_cast<int> (known.right), reversed, k, error);
                CHECK (error < 1e-8);
                CHECK (error <= model.frequencyErrors[k]);
                CHECK (model.frequencyErrors[k] < 1e-6);
            }
        }
    }
}

TEST_CASE ("forty modes of a pinned beam are right within their estimated errors", "[structure]")
{
    const auto beam = uniformBeam (pinned, pinned);
    const auto model = solved (beam);
    const auto scale = stiffnessToMass (beam.common) / (beam.length * beam.length);
    REQUIRE (model.modes() == 40);

    for (Eigen::Index k = 0; k < 40; ++k)
    {
        const auto root = std::numbers::pi * static_cast<double> (k + 1);
        const auto error = std::abs (model.angularFrequencies[k] / (root * root * scale) - 1);
        CAPTURE (k, error);
        CHECK (error < 1e-8);
        CHECK (error <= model.frequencyErrors[k]);
        CHECK (model.frequencyErrors[k] < 1e-6);
    }
}

TEST_CASE ("a thick beam has the frequencies of Timoshenko's equations", "[structure]")
{
    // Roots of the determinant of the transfer matrix of w, psi, M, Q, by matrix exponentials of 40 digits: aluminium,
    // 200 x 10 x 4 mm. Hz.
    struct KnownBeam
    {
        EdgeCondition left, right;
        std::array<double, 12> frequencies;
    };

    const std::array<KnownBeam, 3> known { {
        { clamped,
          clamped,
          { 521.91279766079, 1433.3798626091, 2796.2048503544, 4593.740757146, 6811.7241396454, 9433.1626502847,
            12439.248667767, 15809.849248837, 19523.998955828, 23560.346892161, 27897.546557898, 32514.581774546 } },
        { loose,
          loose,
          { 522.61925438756, 1436.6427300989, 2805.0359105861, 4612.193192618, 6844.7245825434, 9486.3363438888,
            12518.73107578, 15922.097977537, 19675.614372163, 23757.908122036, 28147.467257316, 32822.988001923 } },
        { clamped,
          loose,
          { 82.225482638504, 514.30232114535, 1435.5956002729, 2800.5742931095, 4602.9463458878, 6828.1750135978,
            9459.6577385072, 12478.835316278, 15865.732715249, 19599.453432228, 23658.634576683, 28021.846674216 } },
    } };

    for (const auto& beamKnown : known)
    {
        auto beam = uniformBeam (beamKnown.left, beamKnown.right);
        beam.common.thickness = 4e-3;
        beam.common.theory = BendingTheory::thick;
        const auto model = solved (beam, 12);
        REQUIRE (model.modes() == 12);

        for (Eigen::Index k = 0; k < 12; ++k)
        {
            const auto error =
                std::abs (model.frequencyHz (k) / beamKnown.frequencies[static_cast<std::size_t> (k)] - 1);
            CAPTURE (static_cast<int> (beamKnown.right), k, error);
            CHECK (error < 1e-4); // What rotary inertia adds to the shear is left out.
            CHECK (model.frequencyErrors[k] < 1e-6);
        }
    }
}

TEST_CASE ("a beam of another size has frequencies inverse to its length, and shapes by its mass", "[structure]")
{
    auto beam = uniformBeam (clamped, loose);
    beam.common.ceramics = { ceramicPair (-0.04, 0.03, 0.008, 0.5e-3) };
    const auto model = solved (beam, 8);

    constexpr double factor = 3;
    auto larger = beam;
    larger.length *= factor;
    larger.width *= factor;
    larger.common.thickness *= factor;
    larger.common.ceramics = { ceramicPair (-0.04 * factor, 0.03 * factor, 0.008 * factor, 0.5e-3 * factor) };
    const auto largerModel = solved (larger, 8);

    CHECK ((largerModel.angularFrequencies * factor - model.angularFrequencies).norm()
           < 1e-9 * model.angularFrequencies.norm());
    CHECK ((largerModel.shapes * std::pow (factor, 1.5) - model.shapes).norm() < 1e-8 * model.shapes.norm());

    // kappa grows with the square, slopes fall with the power 5/2.
    CHECK ((largerModel.participation * std::sqrt (factor) - model.participation).norm()
           < 1e-8 * model.participation.norm());
}

TEST_CASE ("four times the density halves frequencies and shapes", "[structure]")
{
    auto beam = uniformBeam (clamped, pinned);
    const auto model = solved (beam, 8);
    beam.common.material.density *= 4;
    const auto heavier = solved (beam, 8);

    CHECK ((2 * heavier.angularFrequencies - model.angularFrequencies).norm()
           < 1e-10 * model.angularFrequencies.norm());
    CHECK ((2 * heavier.shapes - model.shapes).norm() < 1e-8 * model.shapes.norm());
}

TEST_CASE (
    "the number of modes comes from the argument, else the description's count, else its frequency, else it is 40",
    "[structure]")
{
    auto beam = uniformBeam (clamped, loose);
    CHECK (solved (beam).modes() == 40);

    // The second root is 4.694, the third 7.855: a frequency between theirs lets two modes in.
    beam.common.maximumFrequency =
        36 * stiffnessToMass (beam.common) / (beam.length * beam.length) / (2 * std::numbers::pi);
    CHECK (solved (beam).modes() == 2);
    beam.common.modeCount = 5;
    CHECK (solved (beam).modes() == 5);
    CHECK (solved (beam, 7).modes() == 7);
}
