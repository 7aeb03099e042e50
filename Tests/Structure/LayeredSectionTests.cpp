#include "SectionReferences.h"

#include <antinode_outline/PathBuilder.h>
#include <antinode_structure/BendingModes.h>
#include <antinode_structure/BendingProblem.h>
#include <antinode_structure/DescribedCeramic.h>

#include <numbers>

using namespace antinode;
using namespace antinode::examples;

namespace
{
void requireSection (const LayeredSection& section, const nlohmann::json& expected)
{
    CHECK (section.stiffness (0, 0).real() == Approx (expected.at ("D11").get<double>()).epsilon (1e-12));
    CHECK (section.stiffness (0, 1).real() == Approx (expected.at ("D12").get<double>()).epsilon (1e-12));
    CHECK (section.stiffness (2, 2).real() == Approx (expected.at ("D66").get<double>()).epsilon (1e-12));
    CHECK (section.massPerArea == Approx (expected.at ("m").get<double>()).epsilon (1e-12));
    CHECK (section.stiffness.imag().norm() == 0);
}

StructureCommon glass()
{
    auto common = plainCommon (0.7e-3);
    common.material = findElasticMaterial ("glass").value();
    return common;
}

BendingSection bendingSection (const LayeredSection& section)
{
    return { section.stiffness.real(), section.massPerArea };
}
} // namespace

TEST_CASE ("A disc bender on glass: sections and moment to 1e-12", "[structure][section]")
{
    const auto& expected = sectionReferences()["buzzer"]["on_glass"];
    const auto bender = benderExample();
    requireSection (bareStack (glass()), expected["plate"]);
    requireSection (sectionWith (glass(), bender, 0, { false, true }), expected["outer"]);
    const auto inner = sectionWith (glass(), bender, 0);
    requireSection (inner, expected["inner"]);
    CHECK (inner.momentPerVolt[0].real() == Approx (expected["kappa"].get<double>()).epsilon (1e-12));
    CHECK (inner.momentPerVolt[1].real() == Approx (inner.momentPerVolt[0].real()).epsilon (1e-14));
}

TEST_CASE ("A bender has the capacitance of its electrode", "[structure][section]")
{
    CHECK (capacitance (benderExample())
           == Approx (sectionReferences()["buzzer"]["free"]["C_free"].get<double>())
                  .epsilon (1e-4)); // Digits of the constant of vacuum.
}

TEST_CASE ("Glue of 50 um moves a bender away from the plate", "[structure][section]")
{
    // 2 GPa; Poisson's ratio and density of it are not part of the reference.
    const auto& expected = sectionReferences()["buzzer"]["on_glass"]["with_50um_glue_E2GPa"];
    auto bender = benderExample();
    bender.glue = GlueLayer { 50e-6, isotropicMaterial (2e9, 0.35, 1150) };
    CHECK (sectionWith (glass(), bender, 0).momentPerVolt[0].real()
           == Approx (expected["kappa"].get<double>()).epsilon (1e-3));
    CHECK (sectionWith (glass(), bender, 0).stiffness (0, 0).real()
           == Approx (expected["D11_inner"].get<double>()).epsilon (2e-3));
    CHECK (sectionWith (glass(), bender, 0, { false, true }).stiffness (0, 0).real()
           == Approx (expected["D11_outer"].get<double>()).epsilon (2e-3));
}

TEST_CASE ("A ceramic on one side has the reduced section", "[structure][section]")
{
    const auto& expected = sectionReferences()["disc_1side_free"]["section"];
    CeramicDescription disc;
    disc.thickness = 0.3e-3;
    disc.material = findPiezoelectricMaterial ("NCE51").value();
    disc.material.d31 = -17.7 * (1 - disc.material.poissonRatio) / disc.material.youngsModulus;
    disc.mounting = CeramicMounting::oneSide;
    const auto section = ceramicSection (glass(), disc);
    CHECK (section.d11 == Approx (expected["D1"].get<double>()).epsilon (1e-12));
    CHECK (section.d12 / section.d11 == Approx (expected["nu1"].get<double>()).epsilon (1e-12));
    CHECK (section.momentX == Approx (expected["kappa"].get<double>()).epsilon (1e-12));
}

TEST_CASE ("A free bender rings as Bessel's functions say, to 1e-4", "[structure][section][immersed]")
{
    const auto& expected = sectionReferences()["buzzer"]["free"];
    const auto bender = benderExample();
    auto brass = plainCommon (bender.carrier->thickness);
    brass.material = bender.carrier->material;
    auto ceramic = bender;
    ceramic.carrier.reset();
    const auto inner = sectionWith (brass, ceramic, 0), outer = bareStack (brass);
    requireSection (inner, expected["inner"]);

    BendingProblem problem;
    problem.outline.paths = { circlePath ({ 0.001, 0.002 }, bender.sizeX / 2, 0) };
    problem.edges = { {} };
    problem.section = bendingSection (outer);
    auto patch = discPatch ({ 0.001, 0.002 }, bender.carrier->ceramicDiameter / 2);
    patch.added = { bendingSection (inner).stiffness - problem.section.stiffness,
                    inner.massPerArea - outer.massPerArea };
    problem.patches = { patch };
    const auto modes = bendingModes (problem, 9, resolutionFor (problem, 9, ModeAccuracy::usual));
    const Eigen::VectorXd hertz = modes.eigenvalues.cwiseSqrt() / (2 * std::numbers::pi);
    const auto of = [&] (const std::string& diameters)
    { return expected["modes_free_Hz"][diameters][0].get<double>(); };

    // Pairs with two nodal diameters, none (one mode), three, four, and one.
    CHECK (hertz[0] == Approx (of ("n2")).epsilon (1e-4));
    CHECK (hertz[1] == Approx (of ("n2")).epsilon (1e-4));
    CHECK (hertz[2] == Approx (of ("n0")).epsilon (1e-4));
    CHECK (hertz[3] == Approx (of ("n3")).epsilon (1e-4));
    CHECK (hertz[7] == Approx (of ("n1")).epsilon (1e-4));
}

TEST_CASE ("A macro-fibre composite pulls along its fibres", "[structure][section]")
{
    const auto& expected = sectionReferences()["mfc_P1"];
    const auto layer = piezoelectricLayer (findPiezoelectricMaterial ("MFC-P1").value(), 0.3e-3, 1, 0);
    CHECK (layer.stiffness (0, 0).real() == Approx (expected["Q11"].get<double>()).epsilon (1e-9));
    CHECK (layer.stiffness (1, 1).real() == Approx (expected["Q22"].get<double>()).epsilon (1e-9));
    CHECK (layer.stiffness (0, 1).real() == Approx (expected["Q12"].get<double>()).epsilon (1e-9));
    CHECK (layer.stressPerVolt[0] == Approx (expected["stress_per_volt_along"].get<double>()).epsilon (1e-9));
    CHECK (layer.stressPerVolt[1] == Approx (expected["stress_per_volt_across"].get<double>()).epsilon (1e-9));
    CHECK (layer.stressPerVolt[2] == 0);
}

TEST_CASE ("A turned composite has turned constants", "[structure][section]")
{
    const auto expected =
        sectionReferences()["mfc_P1"]["rotated_30deg_Q11_Q22_Q12_Q66_Q16_Q26"].get<std::vector<double>>();
    const auto material = findPiezoelectricMaterial ("MFC-P1").value();
    const auto angle = std::numbers::pi / 6;
    const auto layer = piezoelectricLayer (material, 0.3e-3, 1, angle);
    const Eigen::Matrix3d turned = layer.stiffness.real();
    const std::vector<double> found { turned (0, 0), turned (1, 1), turned (0, 1),
                                      turned (2, 2), turned (0, 2), turned (1, 2) };

    for (std::size_t i = 0; i < found.size(); ++i)
        CHECK (found[i] == Approx (expected[i]).epsilon (1e-9));

    // Stress is a tensor: its trace stays, and along the fibres it is what it was.
    const auto straight = piezoelectricLayer (material, 0.3e-3, 1, 0).stressPerVolt;
    const auto& stress = layer.stressPerVolt;
    const Eigen::Vector2d along (std::cos (angle), std::sin (angle));
    Eigen::Matrix2d tensor;
    tensor << stress[0], stress[2], stress[2], stress[1];
    CHECK (stress[0] + stress[1] == Approx (straight[0] + straight[1]));
    CHECK (along.dot (tensor * along) == Approx (straight[0]));
}

TEST_CASE ("A stack has the same stiffness upside down, and the opposite moment", "[structure][section]")
{
    const auto glassLayer = elasticLayer (findElasticMaterial ("glass").value(), 0.7e-3);
    const auto ceramic = piezoelectricLayer (findPiezoelectricMaterial ("PZT-5A").value(), 0.2e-3, 1, 0);
    const auto core = softLayer (findViscoelasticMaterial ("OCA").value(), 0.1e-3, 1000);
    const auto wood = elasticLayer (findElasticMaterial ("wood-along").value(), 1e-3);
    const std::vector<SectionLayer> layers { wood, core, glassLayer, ceramic };
    const std::vector<SectionLayer> reversed (layers.rbegin(), layers.rend());
    const auto one = layeredSection (layers, 80), other = layeredSection (reversed, 80);
    CHECK ((one.stiffness - other.stiffness).norm() < 1e-12 * one.stiffness.norm());
    CHECK ((one.momentPerVolt + other.momentPerVolt).norm() < 1e-12 * one.momentPerVolt.norm());
}
