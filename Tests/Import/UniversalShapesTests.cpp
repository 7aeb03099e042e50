#include <antinode_base/WholeFile.h>
#include <antinode_documents/DeviceFile.h>
#include <antinode_documents/UniversalModes.h>
#include <antinode_import/ImportedDevice.h>
#include <antinode_responses/UniversalFile.h>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

using namespace antinode;

namespace
{
ModalModel importedPlate()
{
    const auto read = [] (const std::string& name)
    { return readElementResults (readWholeFile (ANTINODE_TEST_DATA "/FiniteElements/" + name, {}), name); };
    return importDevice (mergedResults ({ read ("plate_patch.frd"), read ("plate_patch.dat") }), {}).model;
}

ModalModel computedRing()
{
    const auto json = nlohmann::json::parse (
        R"({ "schema": "antinode.device/1", "name": "ring", "kind": "plate", "outline": { "shape": "ring", "diameter_mm": 120,
             "inner_diameter_mm": 40 }, "edges": { "inner": "clamped", "outer": "free" }, "thickness_mm": 1, "material": "glass",
             "quality_factor": 40, "limits": { "voltage_V": 100 }, "modes": { "count": 20 }, "ceramics": [] })");
    return solveStructure (readDevice (json, "ring.json"));
}

/** The modal assurance criterion of two shapes. Allemang, Brown, IMAC (1982). */
double assurance (const Eigen::VectorXd& a, const Eigen::VectorXd& b)
{
    return a.dot (b) * a.dot (b) / (a.squaredNorm() * b.squaredNorm());
}
} // namespace

TEST_CASE ("Shapes that are written as a universal file are read back with an assurance above 0.9999",
           "[import][files]")
{
    for (const auto& model : { importedPlate(), computedRing() })
    {
        CAPTURE (model.name);
        const auto sets = readUniversalFile (encodeUniversalFile (modeSets (model)), "file");
        Eigen::MatrixX3d places;
        std::vector<UniversalShape> shapes;

        for (const auto& set : sets)
            if (const auto* const nodes = std::get_if<UniversalNodes> (&set))
                places = nodes->places;
            else if (const auto* const shape = std::get_if<UniversalShape> (&set))
                shapes.push_back (*shape);

        REQUIRE (places.rows() > 20);
        REQUIRE (static_cast<Eigen::Index> (shapes.size()) == model.modes());
        Eigen::MatrixXd expected (places.rows(), model.modes());

        for (Eigen::Index p = 0; p < places.rows(); ++p)
            expected.row (p) = shapesAt (model, places (p, 0), places (p, 1));

        for (Eigen::Index k = 0; k < model.modes(); ++k)
            for (Eigen::Index l = 0; l < model.modes(); ++l)
            {
                const Eigen::VectorXd read = shapes[static_cast<std::size_t> (k)].values.col (2).real();
                const auto value = assurance (read, expected.col (l));
                CHECK ((k == l ? value > 0.9999 : value < 0.5));
            }
    }
}
