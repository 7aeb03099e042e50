#include <antinode_structure/Materials.h>

#include <catch2/catch.hpp>

using namespace antinode;

TEST_CASE ("every built-in material is found by its name, and no other", "[structure]")
{
    CHECK (elasticMaterialNames() == std::vector<std::string> { "aluminium", "steel", "glass" });
    CHECK (piezoelectricMaterialNames() == std::vector<std::string> { "NCE51" });

    for (const auto& name : elasticMaterialNames())
        CHECK (findElasticMaterial (name));

    CHECK_FALSE (findElasticMaterial ("NCE51"));
    CHECK_FALSE (findElasticMaterial (""));
    CHECK_FALSE (findPiezoelectricMaterial ("aluminium"));
}

TEST_CASE ("built-in substrates are isotropic", "[structure]")
{
    const auto steel = findElasticMaterial ("steel").value();
    CHECK (steel.youngsModulus1 == 200e9);
    CHECK (steel.youngsModulus2 == steel.youngsModulus1);
    CHECK (steel.shearModulus == Approx (200e9 / 2.6));
    CHECK (steel.poissonRatio12 == 0.3);
    CHECK (steel.density == 7800);
}

TEST_CASE ("NCE51 has the compliances of its data sheet", "[structure]")
{
    const auto ceramic = findPiezoelectricMaterial ("NCE51").value();
    CHECK (1 / ceramic.youngsModulus == Approx (16e-12));
    CHECK (ceramic.poissonRatio == Approx (5.0 / 16.0).epsilon (0.01));
    CHECK (ceramic.d31 == -195e-12);

    // Plane-stress constant d31 / (s11 + s12) = -17.7 C/m^2.
    CHECK (ceramic.d31 * ceramic.youngsModulus / (1 - ceramic.poissonRatio) == Approx (-17.7).epsilon (0.01));
}
