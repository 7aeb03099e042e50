#include <antinode_structure/Materials.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <set>

using namespace antinode;

TEST_CASE ("Every built-in material is found by its names, whatever their case, hyphens and blanks", "[structure]")
{
    for (const auto& [notes, material] : elasticMaterials())
    {
        CAPTURE (notes.name);
        CHECK (findElasticMaterial (notes.name)->density == material.density);
        CHECK_FALSE (notes.scatter.empty());
        CHECK_FALSE (notes.source.empty());
    }

    for (const auto name : { "PZT-5A", "pzt5a", "PZT 5a", "Pzt-5A", "navy-ii" })
        CHECK (findPiezoelectricMaterial (name)->d31 == -171e-12);

    for (const auto name : { "acrylic", "pmma", "Plexiglas" })
        CHECK (findElasticMaterial (name)->density == 1190);

    CHECK (findElasticMaterial ("soda lime glass")->youngsModulus1 == 70e9);
    CHECK (findViscoelasticMaterial ("oca"));
}

TEST_CASE ("No name stands for two materials, and none for nothing", "[structure]")
{
    std::set<std::string> names;
    std::size_t count = 0;

    for (const auto& list : { elasticMaterialNames(), piezoelectricMaterialNames(), viscoelasticMaterialNames() })
        for (const auto& name : list)
        {
            names.insert (name);
            ++count;
            CHECK (findElasticMaterial (name).has_value() + findPiezoelectricMaterial (name).has_value()
                       + findViscoelasticMaterial (name).has_value()
                   == 1);
        }

    CHECK (names.size() == count);

    for (const auto name : { "", "-", " ", "PZT", "glasss" })
    {
        CHECK_FALSE (findElasticMaterial (name));
        CHECK_FALSE (findPiezoelectricMaterial (name));
        CHECK_FALSE (findViscoelasticMaterial (name));
    }
}

TEST_CASE ("Built-in materials store energy whatever they are strained", "[structure]")
{
    const auto isStable = [] (double e1, double e2, double shear, double ratio)
    { return e1 > 0 && e2 > 0 && shear > 0 && ratio * ratio < e1 / e2; };

    for (const auto& [notes, material] : elasticMaterials())
    {
        CAPTURE (notes.name);
        CHECK (isStable (material.youngsModulus1, material.youngsModulus2, material.shearModulus,
                         material.poissonRatio12));
    }

    // Of a ceramic the planar coupling factor kp^2 = 2 d31^2 / (eps33T (s11 + s12)) is below 1, too; of soft ones it is
    // 0.5 to 0.7.
    for (const auto& [notes, material] : piezoelectricMaterials())
        if (! material.fibres)
        {
            CAPTURE (notes.name);
            const auto coupling = 2 * material.d31 * material.d31 * material.youngsModulus
                                  / ((1 - material.poissonRatio) * material.permittivityRelative * 8.854e-12);
            CHECK (std::sqrt (coupling) < 0.75);
            CHECK ((notes.name == "PVDF" || std::sqrt (coupling) > 0.45));
        }
}

TEST_CASE ("Wood across is wood along, turned", "[structure]")
{
    const auto along = findElasticMaterial ("wood-along").value(), across = findElasticMaterial ("wood-across").value();
    CHECK (along.youngsModulus1 == across.youngsModulus2);
    CHECK (along.youngsModulus2 == across.youngsModulus1);
    CHECK (across.poissonRatio12 / across.youngsModulus1 == Approx (along.poissonRatio12 / along.youngsModulus1));
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

TEST_CASE ("PZT-5A and PZT-5H have the compliances of the literature", "[structure]")
{
    // Erturk and Inman, Piezoelectric Energy Harvesting (2011), table E.1: s11 and s12 in 1e-12 1/Pa.
    const auto soft = findPiezoelectricMaterial ("PZT-5A").value(),
               softer = findPiezoelectricMaterial ("PZT-5H").value();
    CHECK (1 / soft.youngsModulus == Approx (16.4e-12).epsilon (2e-3));
    CHECK (soft.poissonRatio == Approx (5.74 / 16.4).epsilon (3e-3));
    CHECK (1 / softer.youngsModulus == Approx (16.5e-12).epsilon (2e-3));
    CHECK (softer.poissonRatio == Approx (4.78 / 16.5).epsilon (3e-3));
}
