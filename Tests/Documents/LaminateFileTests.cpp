#include "Support/ErrorText.h"

#include <antinode_documents/DeviceFile.h>
#include <antinode_structure/PlateWaves.h>

#include <nlohmann/json.hpp>

#include <catch2/catch.hpp>

using namespace antinode;

namespace
{
nlohmann::json laminated()
{
    return nlohmann::json::parse (R"({ "schema": "antinode.device/1", "name": "display", "kind": "plate",
        "length_x_mm": 150, "length_y_mm": 70,
        "layers": [ { "material": "aluminosilicate", "thickness_mm": 0.7 },
                    { "material": { "shear_modulus_MPa": 0.1, "loss_factor": 0.5, "density_kg_m3": 1000 }, "thickness_mm": 0.2 },
                    { "material": "glass", "thickness_mm": 1 } ],
        "edges": { "left": "free", "right": "free", "bottom": "free", "top": "free" },
        "ceramics": [ { "x_mm": 10, "y_mm": 10, "size_x_mm": 10, "size_y_mm": 10, "thickness_mm": 0.2, "material": "pzt 5a",
                        "glue": { "thickness_mm": 0.05, "youngs_modulus_GPa": 2 } } ],
        "limits": { "voltage_V": 60 } })");
}

PlateDescription readPlate (const nlohmann::json& json)
{
    return std::get<PlateDescription> (readDevice (json, "my.json").body);
}

/** The error of a file with a value at a pointer. */
std::string errorOfLaminate (const std::string& pointer, const nlohmann::json& value)
{
    auto json = laminated();
    json[nlohmann::json::json_pointer (pointer)] = value;
    return errorText ([&] { readDevice (json, "my.json"); });
}
} // namespace

TEST_CASE ("A laminate is read with its layers, and needs no damping", "[files]")
{
    const auto common = readPlate (laminated()).common;
    REQUIRE (common.layers.size() == 3);
    CHECK (common.thickness == Approx (1.9e-3));
    CHECK (common.material.density == 2420);
    CHECK (hasSoftLayers (common));
    CHECK (std::get<ViscoelasticMaterial> (common.layers[1].material).table[0].shearModulus == Approx (1e5));
    CHECK (common.dampingRatios.empty());
}

TEST_CASE ("A ceramic lies on one side, glued as its file says", "[files]")
{
    const auto ceramic = readPlate (laminated()).common.ceramics.front();
    CHECK (ceramic.mounting == CeramicMounting::oneSide);
    CHECK (ceramic.wiring == CeramicWiring::parallel);
    CHECK (ceramic.material.d31 == -171e-12);
    REQUIRE (ceramic.glue);
    CHECK (ceramic.glue->thickness == Approx (50e-6));
    CHECK (ceramic.glue->material.youngsModulus1 == Approx (2e9));
}

TEST_CASE ("Moduli by table and by Prony's series", "[files]")
{
    auto json = laminated();
    json["layers"][1]["material"] = { { "density_kg_m3", 1000 },
                                      { "prony",
                                        { { "slow_shear_modulus_MPa", 0.1 },
                                          { "terms", { { { "shear_modulus_MPa", 2 }, { "time_s", 0.001 } } } } } } };
    const auto prony = std::get<ViscoelasticMaterial> (readPlate (json).common.layers[1].material);
    CHECK (prony.slowShearModulus == Approx (1e5));
    CHECK (prony.relaxation.at (0).time == 0.001);
    json["layers"][1]["material"] = "oca";
    CHECK (std::get<ViscoelasticMaterial> (readPlate (json).common.layers[1].material).table.size() == 5);
}

TEST_CASE ("Mistakes in layers say where and what is allowed", "[files]")
{
    CHECK (errorOfLaminate ("/thickness_mm", 1) == "my.json: /thickness_mm: is given with 'layers', which define it");
    CHECK (errorOfLaminate ("/theory", "mindlin").find ("my.json: /theory: is 'mindlin', but a laminate") == 0);
    CHECK (errorOfLaminate ("/theory", "mindlinn").find ("did you mean 'mindlin'?") != std::string::npos);
    CHECK (errorOfLaminate ("/layers/0/material", "OCAA")
               .find ("my.json: /layers/0/material: is the text 'OCAA' (did you mean 'OCA'?)")
           == 0);
    CHECK (errorOfLaminate ("/layers/0/thickness_mm", 0).find ("my.json: /layers/0/thickness_mm: is 0") == 0);
    CHECK (errorOfLaminate ("/layers", nlohmann::json::array()).find ("my.json: /layers: ") == 0);
    CHECK (
        errorOfLaminate ("/layers/1/material/loss_factor", -1).find ("my.json: /layers/1/material/loss_factor: is -1")
        == 0);
    CHECK (errorOfLaminate ("/layers/1/material/table", nlohmann::json::array())
               .find ("my.json: /layers/1/material: needs one of 'shear_modulus_MPa'")
           == 0);

    auto json = laminated();
    json["layers"] = { { { "material", "OCA" }, { "thickness_mm", 1 } } };
    CHECK (errorText ([&] { readDevice (json, "my.json"); })
           == "my.json: /layers: has soft layers only; allowed: at least one layer of an elastic material");

    json["layers"] = { { { "material", "glass" }, { "thickness_mm", 1 } } };
    CHECK (errorText ([&] { readDevice (json, "my.json"); }).find ("damping_ratio") != std::string::npos);
}

TEST_CASE ("An unknown ceramic gets the list", "[files]")
{
    const auto error = errorOfLaminate ("/ceramics/0/material", "PZT-5B");
    CHECK_THAT (error, Catch::Contains ("did you mean 'PZT-5A'?") && Catch::Contains ("'PIC255'"));
}
