#include <antinode_base/InputError.h>
#include <antinode_base/WholeFile.h>
#include <antinode_import/ImportedDevice.h>
#include <antinode_responses/UniversalFile.h>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <random>

using namespace antinode;

namespace
{
std::string dataFile (const std::string& name)
{
    return readWholeFile (std::string (ANTINODE_TEST_DATA "/FiniteElements/") + name, {});
}

ElementResults plate()
{
    return mergedResults ({ readElementResults (dataFile ("plate_patch.frd"), "plate_patch.frd"),
                            readElementResults (dataFile ("plate_patch.dat"), "plate_patch.dat") });
}

nlohmann::json reference()
{
    return nlohmann::json::parse (dataFile ("plate_patch.json"));
}

/** The same as a universal file: nodes, modes and reaction forces as sets 2411 and 55. */
std::string asUniversalFile (const ElementResults& results)
{
    UniversalNodes nodes;
    nodes.labels = results.labels;
    nodes.systems.resize (results.labels.size());
    nodes.places = results.places;
    std::vector<UniversalSet> sets { nodes };
    const auto shape = [&] (int analysis, int quantity, std::vector<UniversalLabel> integers, std::vector<double> reals,
                            const Eigen::MatrixX3cd& values)
    {
        UniversalShape set;
        set.analysisType = analysis;
        set.specificType = quantity;
        set.integers = std::move (integers);
        set.reals = std::move (reals);
        set.nodes = results.labels;
        set.values = values;
        sets.emplace_back (set);
    };

    for (std::size_t k = 0; k < results.modes.size(); ++k)
        // Of modal mass 4: shapes twice as large.
        shape (2, 8, { 1, static_cast<UniversalLabel> (k + 1) }, { results.modes[k].frequency, 4, 0.02, 0 },
               2 * results.modes[k].shape);

    shape (1, 9, { 1 }, { 0 }, results.blockedForces[0].cast<std::complex<double>>());
    return encodeUniversalFile (sets);
}
} // namespace

TEST_CASE ("CalculiX's plate has the frequencies and participations that another program read off it", "[import]")
{
    const auto results = plate();
    const auto truth = reference();
    REQUIRE (results.modes.size() == 6);
    CHECK (results.nodes() == truth["nodes"].get<Eigen::Index>());
    CHECK (results.totalMass == Approx (0.0174));
    const auto device = importDevice (results, {});
    REQUIRE (device.leftOut == 0);
    const auto largest = device.model.participation.cwiseAbs().maxCoeff();

    for (Eigen::Index k = 0; k < 6; ++k)
    {
        CAPTURE (k);
        CHECK (device.model.frequencyHz (k)
               == Approx (truth["f_Hz"][static_cast<std::size_t> (k)].get<double>()).epsilon (1e-8));
        CHECK (std::abs (device.model.participation (k, 0))
               == Approx (truth["alpha_abs_SI"][static_cast<std::size_t> (k)].get<double>())
                      .epsilon (1e-4)
                      .margin (1e-9 * largest));
    }
}

TEST_CASE ("The touched surface is the plate's top, also below its ceramic, and its modes give the static displacement",
           "[import]")
{
    const auto results = plate();
    const auto surface = findTouchedSurface (results, {});
    CHECK (surface.lower == 0);

    for (const auto node : surface.nodes)
        CHECK (results.places (node, 2) == Approx (0.0005));

    REQUIRE (surface.ceramics.size() == 1);
    CHECK (surface.ceramics[0].xMinimum == Approx (0.02));
    CHECK (surface.ceramics[0].xMaximum == Approx (0.04));
    CHECK (surface.ceramics[0].yMinimum == Approx (0.02));
    CHECK (surface.ceramics[0].yMaximum == Approx (0.04));
    const auto device = importDevice (results, {});
    CHECK (device.model.surface.points.col (0).maxCoeff() == Approx (0.1));
    CHECK (device.model.surface.points.col (1).maxCoeff() == Approx (0.06));
    CHECK (device.mass == Approx (0.0174).epsilon (0.15)); // The ceramic's 1.6 g and rotation are not the surface's.
    REQUIRE (device.staticErrors.size() == 1);
    CHECK (device.staticErrors[0] < 0.15); // Six modes have no dent under the ceramic.
    const Eigen::VectorXd amplitudes =
        device.model.participation.col (0).cwiseQuotient (device.model.angularFrequencies.cwiseAbs2());
    const auto tip = shapesAt (device.model, 0.1, 0.06).dot (amplitudes);
    CHECK (tip == Approx (reference()["u_static_tip_m_per_V"][2].get<double>()).epsilon (0.02));
}

TEST_CASE ("The other side of a body has its own nodes, and another axis another plane", "[import]")
{
    const auto results = plate();
    SideChoice bottom;
    bottom.isTop = false;

    for (const auto node : findTouchedSurface (results, bottom).nodes)
        CHECK (results.places (node, 2) == Approx (-0.0005));

    SideChoice tip;
    tip.axis = 0;
    const auto surface = findTouchedSurface (results, tip);

    for (const auto node : surface.nodes)
        CHECK (results.places (node, 0) == Approx (0.1));

    CHECK (surface.points.col (0).maxCoeff() == Approx (0.06)); // y
}

TEST_CASE ("What is written as a universal file is imported as the same device", "[import]")
{
    const auto results = plate();
    const auto direct = importDevice (results, {});
    const auto again = importDevice (mergedResults ({ readElementResults (asUniversalFile (results), "file") }), {});
    REQUIRE (again.model.modes() == 6);
    REQUIRE (again.model.dampingRatios[0] == Approx (0.02));

    for (Eigen::Index k = 0; k < 6; ++k)
    {
        // Without elements the ceramic's top is the highest plane: its nodes are compared at places that both have.
        CHECK (again.model.frequencyHz (k) == Approx (direct.model.frequencyHz (k)).epsilon (1e-6));
        CHECK (again.model.participation (k, 0)
               == Approx (direct.model.participation (k, 0))
                      .epsilon (1e-4)
                      .margin (1e-7 * direct.model.participation.cwiseAbs().maxCoeff()));
    }
}

TEST_CASE ("Results in mm, t and N are those in SI units", "[import]")
{
    auto results = plate();
    auto other = results;
    other.places *= 1e3;
    other.totalMass /= 1e3;
    other.staticDisplacements[0] *= 1e3;

    for (auto& mode : other.modes)
        mode.shape *= std::sqrt (1e3);

    const auto one = importDevice (results, {}), two = importDevice (fromMillimetres (other), {});
    CHECK (one.model.shapes.isApprox (two.model.shapes, 1e-12));
    CHECK (one.model.participation.isApprox (two.model.participation, 1e-12));
    CHECK (one.mass == Approx (two.mass));
    CHECK (importDevice (other, {}).warnings.size() > one.warnings.size());
}

TEST_CASE ("Nodes or results in another order than files have them are refused", "[import]")
{
    const auto whole = dataFile ("plate_patch.frd");
    const auto nodes = whole.find ("    2C"), elements = whole.find ("    3C"), results = whole.find ("    1PSTEP");
    const auto head = whole.substr (0, nodes), nodeBlock = whole.substr (nodes, elements - nodes);
    CHECK_THROWS_WITH (readElementResults (head + nodeBlock + nodeBlock, "file"),
                       Catch::Contains ("a second block of nodes"));
    CHECK_THROWS_WITH (readElementResults (head + whole.substr (results), "file"),
                       Catch::Contains ("results before the nodes"));
    const auto sets = readUniversalFile (asUniversalFile (plate()), "file");
    CHECK_THROWS_WITH (readElementResults (encodeUniversalFile ({ sets[0], sets[0] }), "file"),
                       Catch::Contains ("two sets of nodes"));
    CHECK_THROWS_WITH (readElementResults (encodeUniversalFile ({ sets[1], sets[0] }), "file"),
                       Catch::Contains ("results before its nodes"));
}

TEST_CASE ("Modes without a damping ratio get one, and how many is said", "[import]")
{
    auto results = plate();
    results.modes[2].dampingRatio = 0.03;
    const auto device = importDevice (results, {});
    CHECK (device.withoutDamping == 5);
    CHECK (device.model.dampingRatios[2] == 0.03);
    CHECK (device.model.dampingRatios[3] == 0.01);
}

TEST_CASE ("Nodes on one line are thinned, too", "[import]")
{
    auto results = plate();
    results.places.col (1).setZero();
    SideChoice side;
    side.maximumPoints = 10;
    const auto surface = findTouchedSurface (results, side);
    CHECK (surface.points.rows() >= 5);
    CHECK (surface.points.rows() <= 11);
}

TEST_CASE ("More nodes than wanted are thinned evenly", "[import]")
{
    SideChoice side;
    side.maximumPoints = 40;
    const auto surface = findTouchedSurface (plate(), side);
    CHECK (surface.points.rows() <= 60);
    CHECK (surface.points.rows() >= 30);
    CHECK (surface.meshNodes > 100);
}

TEST_CASE ("What finite-element results lack is said", "[import]")
{
    auto results = plate();
    CHECK_THROWS_WITH (mergedResults ({}), Catch::Contains ("contain no modes"));
    auto withoutForces = results;
    withoutForces.blockedForces.clear();
    CHECK_THROWS_WITH (mergedResults ({ withoutForces }), Catch::Contains ("no reaction forces of a ceramic"));
    auto still = results;
    still.blockedForces[0].setZero();
    CHECK_THROWS_WITH (importDevice (still, {}), Catch::Contains ("has no reaction forces"));
    auto another = results;
    another.labels[3] += 1000;
    CHECK_THROWS_WITH (mergedResults ({ results, another }), Catch::Contains ("different meshes"));
}

TEST_CASE ("Five hundred broken .frd files are read or refused in one sentence", "[import]")
{
    const auto whole = dataFile ("plate_patch.frd");
    std::mt19937 random (11);
    int refused = 0;

    for (int round = 0; round < 500; ++round)
    {
        auto broken = whole.substr (0, round % 3 == 0 ? random() % whole.size() : whole.size());

        for (int change = 0; change < 1 + round % 4 && ! broken.empty(); ++change)
        {
            constexpr std::string_view characters = "0123456789-+.E \nCx\xFF";
            const auto at = random() % broken.size();
            broken[at] = characters[random() % characters.size()];
        }

        try
        {
            importDevice (mergedResults ({ readElementResults (broken, "file.frd") }), {});
        }
        catch (const InputError& error)
        {
            ++refused;
            CHECK (std::string (error.what()).find ('\n') == std::string::npos);
        }
    }

    CHECK (refused > 150);
}
