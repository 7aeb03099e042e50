#include "PlateExamples.h"

#include <antinode_base/InputError.h>

#include <functional>
#include <limits>

using namespace antinode;
using namespace antinode::examples;

namespace
{
PlateDescription ordinaryPlate()
{
    auto plate = barePlate ("CFSF", 0.2, 0.12);
    plate.common.ceramics = { plateCeramic (0.02, 0.03, 0.03, 0.02), plateCeramic (0.05, 0.03, 0.03, 0.02) };
    return plate;
}

using Number = std::function<double&(PlateDescription&)>;

/** Every number of a plate's description. */
std::vector<std::pair<std::string, Number>> plateNumbers()
{
    const auto ceramic = [] (double CeramicDescription::*member) -> Number
    {
        return [member] (PlateDescription& p) -> double& { return p.common.ceramics[0].*member; };
    };
    const auto substrate = [] (double ElasticMaterial::*member) -> Number
    {
        return [member] (PlateDescription& p) -> double& { return p.common.material.*member; };
    };
    const auto layer = [] (double PiezoelectricMaterial::*member) -> Number
    {
        return [member] (PlateDescription& p) -> double& { return p.common.ceramics[0].material.*member; };
    };
    return { { "length x", [] (PlateDescription& p) -> double& { return p.lengthX; } },
             { "length y", [] (PlateDescription& p) -> double& { return p.lengthY; } },
             { "thickness", [] (PlateDescription& p) -> double& { return p.common.thickness; } },
             { "voltage limit", [] (PlateDescription& p) -> double& { return p.common.voltageLimit; } },
             { "full scale", [] (PlateDescription& p) -> double& { return p.common.fullScaleVoltage; } },
             { "damping", [] (PlateDescription& p) -> double& { return p.common.dampingRatios[0]; } },
             { "E1", substrate (&ElasticMaterial::youngsModulus1) },
             { "E2", substrate (&ElasticMaterial::youngsModulus2) },
             { "G12", substrate (&ElasticMaterial::shearModulus) },
             { "nu12", substrate (&ElasticMaterial::poissonRatio12) },
             { "density", substrate (&ElasticMaterial::density) },
             { "ceramic x", ceramic (&CeramicDescription::x) },
             { "ceramic y", ceramic (&CeramicDescription::y) },
             { "ceramic size x", ceramic (&CeramicDescription::sizeX) },
             { "ceramic size y", ceramic (&CeramicDescription::sizeY) },
             { "ceramic thickness", ceramic (&CeramicDescription::thickness) },
             { "ceramic E", layer (&PiezoelectricMaterial::youngsModulus) },
             { "ceramic nu", layer (&PiezoelectricMaterial::poissonRatio) },
             { "ceramic density", layer (&PiezoelectricMaterial::density) },
             { "ceramic d31", layer (&PiezoelectricMaterial::d31) } };
}

/** Either one sentence that says what is wrong, or a sound model: nothing in between. */
bool isSoundOrRefused (const PlateDescription& plate, int modes)
{
    try
    {
        const auto model = solved (plate, modes);
        const Eigen::MatrixXd deviation = gramMatrix (model) - Eigen::MatrixXd::Identity (modes, modes);
        CHECK (model.angularFrequencies.allFinite());
        CHECK (model.angularFrequencies[0] > 0);
        CHECK (model.participation.allFinite());
        CHECK (deviation.cwiseAbs().maxCoeff() < 5e-3); // of a plate of 2 km by 120 mm, too
        CHECK (model.frequencyErrors.maxCoeff() < 0.1);
        return true;
    }
    catch (const InputError& error)
    {
        const std::string text = error.what();
        CAPTURE (text);
        CHECK (text.find ('\n') == std::string::npos);
        CHECK_THAT (text, Catch::Contains ("allowed: ") || Catch::Contains ("choose ")
                              || Catch::Contains ("of such different size"));
        return true;
    }
}
} // namespace

TEST_CASE ("A plate with arbitrary numbers is solved accurately or refused with a reason", "[structure][plate]")
{
    constexpr auto infinity = std::numeric_limits<double>::infinity();
    const auto notANumber = std::numeric_limits<double>::quiet_NaN();
    int cases = 0;

    for (const auto& [name, number] : plateNumbers())
        for (const auto value :
             { notANumber, infinity, -infinity, 0.0, -1.0, 1e-300, 1e300, 1e-9, 1e9, 1e-3, 0.4999, 2.0 })
        {
            CAPTURE (name, value);
            auto plate = ordinaryPlate();
            number (plate) = value;
            CHECK (isSoundOrRefused (plate, 6));
            ++cases;
        }

    CHECK (cases >= 200);
}

TEST_CASE ("Every number of a plate times a power of ten", "[structure][plate]")
{
    for (const auto& [name, number] : plateNumbers())
        for (const auto factor : { 1e-4, 1e-2, 1e2, 1e4 })
        {
            CAPTURE (name, factor);
            auto plate = ordinaryPlate();
            number (plate) *= factor;
            CHECK (isSoundOrRefused (plate, 6));
        }
}

TEST_CASE ("Plates from a square to a strip a thousand times as long as wide", "[structure][plate]")
{
    for (const auto width : { 1.0, 0.1, 1e-2, 1e-3 })
    {
        CAPTURE (width);
        const auto plate = barePlate ("CFFF", 1, width, 0);
        CHECK (lambdas (plate, solved (plate, 1))[0] == Approx (3.516015269).epsilon (1e-5));
    }

    CHECK_THROWS_WITH (solved (barePlate ("CFFF", 1, 1e-9), 3), Catch::Contains ("of such different size"));
}

TEST_CASE ("Sixty-four ceramics that touch on all sides cover the plate like one", "[structure][plate]")
{
    auto tiled = barePlate ("SSSS", 0.2, 0.16), covered = tiled;
    covered.common.ceramics = { plateCeramic (0, 0, 0.2, 0.16) };

    for (int i = 0; i < 8; ++i)
        for (int j = 0; j < 8; ++j)
            tiled.common.ceramics.push_back (plateCeramic (i * 0.025, j * 0.02, 0.025, 0.02));

    const auto a = solved (tiled, 20), b = solved (covered, 20);
    CHECK ((a.angularFrequencies - b.angularFrequencies).norm() < 1e-5 * b.angularFrequencies.norm());
    CHECK (std::abs (a.participation.row (0).sum() - b.participation (0, 0))
           < 1e-5 * std::abs (b.participation (0, 0)));
}

TEST_CASE ("What cannot be a plate with ceramics is named", "[structure][plate]")
{
    auto outside = ordinaryPlate();
    outside.common.ceramics[1].x = 0.19;
    CHECK_THROWS_WITH (solved (outside), Catch::Contains ("ceramic 2: extends from x = 190 mm to 220 mm"));

    auto overlapping = ordinaryPlate();
    overlapping.common.ceramics[1].x = 0.045;
    CHECK_THROWS_WITH (solved (overlapping), Catch::Contains ("ceramic 2: overlaps ceramic 1 by 5 mm x 20 mm"));

    auto guided = ordinaryPlate();
    guided.top = EdgeCondition::guided;
    CHECK_THROWS_WITH (solved (guided), Catch::Contains ("guided edge"));

    auto thin = ordinaryPlate();
    thin.common.ceramics[0].sizeX = 1e-6;
    CHECK_THROWS_WITH (solved (thin),
                       Catch::Contains ("too narrow; allowed: at least 1/5000 of the plate's shorter side"));
}
