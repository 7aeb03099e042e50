#include "PlateExamples.h"
#include "SectionReferences.h"

#include <antinode_structure/Materials.h>
#include <antinode_structure/PlateWaves.h>

#include <numbers>

using namespace antinode;
using namespace antinode::examples;

namespace
{
using std::numbers::pi;

/** The classic sandwich plate of the literature: 348 x 304.8 mm, two faces of aluminium of 0.762 mm. */
PlateDescription sandwichPlate()
{
    const auto face = isotropicMaterial (68.9e9, 0.3, 2740);
    auto plate = barePlate ("SSSS", 0.348, 0.3048);
    plate.common = laminate ({ { 0.762e-3, face }, constantCore (0.254e-3, 0.896e6, 0.5, 999), { 0.762e-3, face } });
    return plate;
}

/** A strip of a sandwich beam, which is free to contract across. */
StructureCommon sandwichBeam (const nlohmann::json& data)
{
    const auto of = [&] (const char* key) { return data.at (key).get<double>(); };
    return laminate ({ { of ("h1"), isotropicMaterial (of ("E1"), 0, of ("r1")) },
                       constantCore (of ("h2"), of ("G"), of ("eta"), of ("r2")),
                       { of ("h3"), isotropicMaterial (of ("E3"), 0, of ("r3")) } });
}
} // namespace

TEST_CASE ("Sandwich beams of Mead and Markus: frequency and loss factor to 1e-9", "[structure][laminate]")
{
    for (const auto& [name, beam] : sectionReferences()["sandwich_beam"].items())
    {
        CAPTURE (name);
        const auto common = sandwichBeam (beam["data"]);

        for (std::size_t n = 0; n < beam["f_Hz"].size(); ++n)
        {
            const auto wave =
                lossyFrequencyAt (common, static_cast<double> (n + 1) * pi / beam["data"]["L"].get<double>());
            CHECK (wave.angularFrequency / (2 * pi) == Approx (beam["f_Hz"][n].get<double>()).epsilon (1e-9));
            CHECK (wave.lossFactor == Approx (beam["loss"][n].get<double>()).epsilon (1e-9));
        }
    }
}

TEST_CASE ("A simply supported sandwich plate, solved: frequencies and loss factors to 1e-6",
           "[structure][laminate][plate]")
{
    const auto model = solveStructure ({ "sandwich", "", sandwichPlate() }, 12);

    for (const auto& row : sectionReferences()["sandwich_plate"]["values_m_n_f_loss"])
    {
        const auto frequency = row[2].get<double>();
        Eigen::Index nearest = 0;
        (model.angularFrequencies.array() - 2 * pi * frequency).abs().minCoeff (&nearest);
        CHECK (model.frequencyHz (nearest) == Approx (frequency).epsilon (1e-6));
        CHECK (2 * model.dampingRatios[nearest] == Approx (row[3].get<double>()).epsilon (1e-6));
    }
}

TEST_CASE ("Damping that is given adds to that of soft layers", "[structure][laminate][plate]")
{
    auto plate = sandwichPlate();
    const auto alone = solveStructure ({ "sandwich", "", plate }, 4);
    plate.common.dampingRatios = { 0.01 };
    const auto both = solveStructure ({ "sandwich", "", plate }, 4);
    CHECK (both.angularFrequencies == alone.angularFrequencies);
    CHECK ((both.dampingRatios - alone.dampingRatios).isApprox (Eigen::VectorXd::Constant (4, 0.01)));
}

TEST_CASE ("What a mode is does not depend on how many modes are solved with it", "[structure][laminate][plate]")
{
    // The reference lies at other wave numbers, where the faces are bonded more or less: the moment of a ceramic on one
    // of them differs by a third. What is left is that its part of the plate stiffens as the bare plate does.
    auto plate = sandwichPlate();
    auto ceramic = plateCeramic (0.05, 0.06, 0.03, 0.03, 0.2e-3);
    ceramic.mounting = CeramicMounting::oneSide;
    plate.common.ceramics = { ceramic };
    const auto few = solveStructure ({ "sandwich", "", plate }, 4),
               many = solveStructure ({ "sandwich", "", plate }, 80);

    for (Eigen::Index k = 0; k < 4; ++k)
    {
        CHECK (few.angularFrequencies[k] == Approx (many.angularFrequencies[k]).epsilon (5e-3));
        CHECK (few.dampingRatios[k] == Approx (many.dampingRatios[k]).epsilon (1e-2));
        CHECK (few.participation (k, 0) == Approx (many.participation (k, 0)).epsilon (5e-2));
    }
}

TEST_CASE ("A maximum frequency holds for the frequencies of the laminate", "[structure][laminate][plate]")
{
    auto plate = sandwichPlate();
    const auto many = solveStructure ({ "sandwich", "", plate }, 30);
    plate.common.maximumFrequency = (many.frequencyHz (19) + many.frequencyHz (20)) / 2;
    const auto some = solveStructure ({ "sandwich", "", plate });
    CHECK (some.modes() == 20);
    CHECK ((some.angularFrequencies - many.angularFrequencies.head (20)).norm()
           < 1e-6 * some.angularFrequencies.norm());
}

TEST_CASE ("Between a hard and a soft core lie the bonded and the loose plate", "[structure][laminate]")
{
    const auto face = isotropicMaterial (70e9, 0.22, 2500);
    const auto stiffness = [&] (double shearModulus, double waveNumber)
    {
        return stiffnessAt (laminate ({ { 1e-3, face }, constantCore (0.1e-3, shearModulus, 0, 1000), { 2e-3, face } }),
                            waveNumber, 1)
            .real();
    };
    const auto plate = 70e9 / (1 - 0.22 * 0.22);
    const auto loose = plate * (1e-9 + 8e-9) / 12;
    const auto bonded = loose + plate * 1e-3 * 2e-3 / 3e-3 * std::pow (1.6e-3, 2);
    CHECK (stiffness (1, 100) == Approx (loose).epsilon (1e-6));
    CHECK (stiffness (1e15, 100) == Approx (bonded).epsilon (1e-6));
    CHECK (stiffness (1e6, 20) > stiffness (1e6, 100));
}

TEST_CASE ("Two soft layers that touch shear as one of both", "[structure][laminate]")
{
    const auto face = isotropicMaterial (70e9, 0.22, 2500);
    const auto two = laminate ({ { 1e-3, face },
                                 constantCore (0.1e-3, 1e6, 0.4, 1000),
                                 constantCore (0.2e-3, 1e6, 0.4, 1000),
                                 { 2e-3, face } });
    const auto one = laminate ({ { 1e-3, face }, constantCore (0.3e-3, 1e6, 0.4, 1000), { 2e-3, face } });
    CHECK (std::abs (stiffnessAt (two, 90, 1) / stiffnessAt (one, 90, 1) - 1.0) < 1e-10);
}

TEST_CASE ("A free layer damps as Oberst's formula says", "[structure][laminate]")
{
    // Bars: EI / E1 I1 = 1 + e h^3 + 3 (1 + h)^2 e h / (1 + e h), e and h the ratios of moduli and thicknesses.
    const auto common = laminate ({ { 1e-3, isotropicMaterial (70e9, 0, 2700) }, constantCore (3e-3, 1e9, 0.8, 1500) });
    auto soft = common;
    std::get<ViscoelasticMaterial> (soft.layers[1].material).poissonRatio = 0;
    const std::complex<double> e = 2e9 / 70e9 * std::complex<double> (1, 0.8);
    const auto h = 3.0;
    const auto expected = 70e9 * 1e-9 / 12 * (1.0 + e * h * h * h + 3 * (1 + h) * (1 + h) * e * h / (1.0 + e * h));
    CHECK (std::abs (stiffnessAt (soft, 50, 1) / expected - 1.0) < 1e-10);
}

TEST_CASE ("Prony's series of one term is the standard linear solid", "[structure][laminate]")
{
    ViscoelasticMaterial material;
    material.slowShearModulus = 1e5;
    material.relaxation = { { 9e5, 1e-3 } };
    const auto slow = shearModulusAt (material, 1e-3), middle = shearModulusAt (material, 1e3),
               fast = shearModulusAt (material, 1e9);
    CHECK (slow.real() == Approx (1e5).epsilon (1e-6));
    CHECK (middle.real() == Approx (5.5e5));
    CHECK (middle.imag() == Approx (4.5e5));
    CHECK (fast.real() == Approx (1e6).epsilon (1e-6));
}

TEST_CASE ("A table of moduli is met at its rows and followed as a power between them", "[structure][laminate]")
{
    ViscoelasticMaterial material;
    material.table = { { 10, 1e5, 0.2 }, { 1000, 1e7, 1.0 } };
    CHECK (shearModulusAt (material, 20 * pi).real() == Approx (1e5));
    const auto between = shearModulusAt (material, 200 * pi);
    CHECK (between.real() == Approx (1e6));
    CHECK (between.imag() / between.real() == Approx (0.6));
    CHECK (shearModulusAt (material, 1).real() == Approx (1e5));
    CHECK (shearModulusAt (material, 1e6).real() == Approx (1e7));
}

TEST_CASE ("Stiffening with frequency is found at the mode's own frequency", "[structure][laminate]")
{
    const auto face = isotropicMaterial (70e9, 0.22, 2500);
    auto common = laminate ({ { 0.7e-3, face }, { 0.2e-3, findViscoelasticMaterial ("OCA").value() }, { 1e-3, face } });
    const auto wave = lossyFrequencyAt (common, 40);
    const auto again = stiffnessAt (common, 40, wave.angularFrequency);
    const auto mass = 0.7e-3 * 2500 + 0.2e-3 * 1000 + 1e-3 * 2500;
    CHECK (std::pow (wave.angularFrequency, 2) == Approx (std::pow (40.0, 4) * again.real() / mass).epsilon (1e-11));
    CHECK (wave.lossFactor == Approx (again.imag() / again.real()));
}
