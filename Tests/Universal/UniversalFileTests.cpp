#include "Support/ErrorText.h"
#include "Support/RunProgram.h"

#include <antinode_responses/UniversalFile.h>

#include <nlohmann/json.hpp>

#include <catch2/catch.hpp>

#include <algorithm>
#include <complex>

using namespace antinode;
using namespace antinode::test;

namespace
{
const std::string folder = ANTINODE_TEST_DATA "/UniversalFiles/";

int setNumber (const UniversalSet& set)
{
    constexpr int numbers[] = { 58, 55, 15, 82, 151, 164, 2412, 2414 };

    if (const auto* const unknown = std::get_if<UnknownUniversalSet> (&set))
        return unknown->number;

    const auto* const nodes = std::get_if<UniversalNodes> (&set);
    return nodes != nullptr && nodes->isDouble ? 2411 : numbers[set.index()];
}

double lastAbscissa (const UniversalFunction& function)
{
    const auto last = function.values.size() - 1;
    return function.isEven ? function.first + static_cast<double> (last) * function.step : function.abscissae[last];
}

/** Text with every character that its reader could not tell, U+FFFD, taken as any one character. */
bool isSameText (const std::string& text, const std::string& expected)
{
    const std::string unknown = "\xef\xbf\xbd";
    const auto at = expected.find (unknown);

    if (at == std::string::npos)
        return text == expected;

    const auto behind = expected.substr (at + unknown.size());
    return text.starts_with (expected.substr (0, at)) && text.ends_with (behind)
           && text.size() == at + behind.size() + 2; // Latin-1 beyond ASCII has two bytes in UTF-8.
}

void checkFunction (const UniversalFunction& function, const nlohmann::json& expected)
{
    constexpr double rounding = 1e-12; // A sum of 8e4 terms in another order.
    const auto& values = function.values;
    const auto number = [] (const nlohmann::json& pair)
    { return std::complex<double> (pair[0].get<double>(), pair[1].get<double>()); };
    CHECK (function.functionType == expected["func_type"]);
    CHECK (function.statedCount == expected["n"]);
    CHECK ((function.encoding != UniversalEncoding::text) == (expected["binary"] == 1));
    CHECK (function.ordinateType == expected["ord_data_type"]);
    CHECK (function.isEven == (expected["abscissa_spacing"] == 1));
    CHECK ((function.isEven ? function.first : function.abscissae[0]) == expected["x0"].get<double>());
    CHECK (lastAbscissa (function) == Approx (expected["x_end"].get<double>()).epsilon (rounding));
    CHECK (values[0] == number (expected["y0"]));
    CHECK (values[values.size() - 1] == number (expected["y_end"]));
    CHECK (values.cwiseAbs().sum() == Approx (expected["sum_abs"].get<double>()).epsilon (rounding));
    CHECK (function.response.node == expected["rsp_node"]);
    CHECK (function.reference.node == expected["ref_node"]);
    CHECK (isSameText (function.ordinate.unit, expected["unit"]));
}

void checkShape (const UniversalShape& shape, const nlohmann::json& expected)
{
    CHECK (shape.analysisType == expected["analysis_type"]);
    CHECK (shape.nodes.size() == expected["n_nodes"]);
    CHECK (shape.values.allFinite());

    if (expected["freq"].is_number())
        CHECK (shape.reals.at (0) == expected["freq"]);
    else
        CHECK (shape.reals == std::vector<double> { -0.1111111, 41.11111, 4111.111, -3111.111, -111111.0, -211111.0 });
}

/** Five values in numbers that single precision and six digits hold exactly. */
UniversalFunction exampleFunction (int type, bool isEven, UniversalEncoding encoding)
{
    UniversalFunction function;
    function.encoding = encoding;
    function.functionType = 4;
    function.ordinateType = type;
    function.isEven = isEven;
    function.step = 0.25;
    function.response = { "SHELL", -7, -3 };
    function.ordinate = { 12, { 1, 0, 0 }, "Acceleration", "m/s\xc2\xb2" };
    function.values.resize (5);
    function.values << 1.5, -0.25, 1e5, 0, std::complex<double> (-3, function.isComplex() ? 2.5 : 0);

    if (! isEven)
        function.abscissae = Eigen::VectorXd::LinSpaced (5, 1, 3);

    return function;
}

std::string rewritten (const std::string& bytes)
{
    return encodeUniversalFile (readUniversalFile (bytes, "file"));
}
} // namespace

TEST_CASE ("Files of instruments and programs are read as others read them", "[files][universal]")
{
    const auto files = nlohmann::json::parse (readContent (folder + "expected.json"));
    CHECK (files.size() == 13);

    for (const auto& [name, expected] : files.items())
    {
        INFO (name);
        const auto sets = readUniversalFile (readContent (folder + name), name);
        REQUIRE (sets.size() == expected["sets"].size());

        for (std::size_t i = 0; i < sets.size(); ++i)
        {
            const auto& wanted = expected["sets"][i];
            CHECK (setNumber (sets[i]) == wanted["type"]);

            if (const auto* const function = std::get_if<UniversalFunction> (&sets[i]))
                checkFunction (*function, wanted);
            else if (const auto* const shape = std::get_if<UniversalShape> (&sets[i]))
                checkShape (*shape, wanted);
            else if (const auto* const nodes = std::get_if<UniversalNodes> (&sets[i]))
                CHECK (nodes->labels.size() == wanted["n_nodes"]);
        }
    }
}

TEST_CASE ("A universal file that was read and written is the same when that is done again", "[files][universal]")
{
    const auto files = nlohmann::json::parse (readContent (folder + "expected.json"));

    for (const auto& [name, expected] : files.items())
    {
        INFO (name);
        const auto once = rewritten (readContent (folder + name));
        CHECK (rewritten (once) == once);
    }
}

TEST_CASE ("Functions of every kind come back as they were written", "[files][universal]")
{
    for (const auto type : { 2, 4, 5, 6 })
        for (const auto isEven : { true, false })
            for (const auto encoding :
                 { UniversalEncoding::text, UniversalEncoding::littleEndian, UniversalEncoding::bigEndian })
            {
                const auto function = exampleFunction (type, isEven, encoding);
                const auto text = encodeUniversalFile ({ function });
                const auto read = std::get<UniversalFunction> (readUniversalFile (text, "file").at (0));
                INFO (type << isEven << static_cast<int> (encoding));
                // Numbers of the example have few digits, so that every form holds them exactly.
                CHECK (read.values == function.values);
                CHECK (read.abscissae == function.abscissae);
                CHECK (read.encoding == encoding);
                CHECK (read.step == function.step);
                CHECK (read.response.node == -7);
                CHECK (read.response.direction == -3);
                CHECK (read.ordinate.unit == "m/s^2");
                CHECK (encodeUniversalFile ({ read }) == text);
            }
}

TEST_CASE ("Numbers are told apart without blanks, with D, without exponent letter, on half-full lines",
           "[files][universal]")
{
    const auto readValues = [] (const std::string& data)
    {
        const auto text = std::string ("    -1\n    58\nNONE\nNONE\nNONE\nNONE\nNONE\n")
                          + "    1         0    0         0 NONE               1   3 NONE               0   0\n"
                          + "         4         4         1  0.00000E+00  1.00000D-03  0.00000E+00\n"
                          + "        17    0    0    0 NONE                 s\n        12    0    0    0 NONE"
                          + "                 a unit that is much longer than its field\n"
                          + "         0    0    0    0 NONE                 NONE\n         0    0    0    0 NONE\n"
                          + data + "    -1\n";
        const auto function = std::get<UniversalFunction> (readUniversalFile (text, "file").at (0));
        CHECK (function.step == 1e-3);
        CHECK (function.ordinate.unit == "a unit that is much longer than its field");
        return Eigen::VectorXd (function.values.real());
    };
    const Eigen::Vector4d numbers (-1.25e3, 2.5e-110, -1, 4);
    CHECK (readValues ("-1.25E+032.5-110-1.D04.0\n") == numbers);
    CHECK (readValues ("  -1.250000000000E+03   2.500000000000-110\n -1\n      4\n") == numbers);
    CHECK (readValues ("-1.250000000000D+03 2.50000000000D-110-1.000000000000E+00 4.000000000000E+00 \r\n") == numbers);
}

TEST_CASE ("Columns of E13.5 hold up to eleven digits where six are not exact, and are read again",
           "[files][universal]")
{
    UniversalShape shape;
    shape.reals = { 1234.567890123,  -0.0012345678912, 200, 1.5, 123456789.12, 0, 1e-120,
                    -1.23456789e-20, 9.99999999999e20 };
    shape.nodes = { 7 };
    shape.values = Eigen::MatrixXcd::Constant (1, 1, { -4.4444444444e-5, 0 });
    const auto text = encodeUniversalFile ({ shape });
    CHECK (text.find (" 1234.5678901 -0.001234568  2.00000E+02  1.50000E+00 123456789.12  0.00000E+00\n") != text.npos);
    const auto read = std::get<UniversalShape> (readUniversalFile (text, "file").at (0));

    for (std::size_t i = 0; i < shape.reals.size(); ++i)
        CHECK (std::abs (read.reals[i] - shape.reals[i]) <= 5e-6 * std::abs (shape.reals[i]) + 1e-99);

    CHECK (std::abs (read.reals[0] - shape.reals[0]) < 1e-7);

    CHECK (std::abs (read.values (0, 0) + 4.4444444444e-5) < 5e-12);
    CHECK (encodeUniversalFile ({ read }) == text);
}

TEST_CASE ("A line of -1 closes a set, a -1 among coordinates does not", "[files][universal]")
{
    const auto sets = readUniversalFile ("    -1   \r\n  2411\r\n        -1         0         0        11\r\n"
                                         "    -1.00000000D+00    -1    -1\r\n    -1\r\n",
                                         "file");
    const auto& nodes = std::get<UniversalNodes> (sets.at (0));
    CHECK (nodes.labels == std::vector<UniversalLabel> { -1 });
    CHECK (nodes.places == Eigen::RowVector3d (-1, -1, -1));
}

TEST_CASE ("The end of binary data is found however wrong the header counts", "[files][universal]")
{
    auto function = exampleFunction (5, true, UniversalEncoding::bigEndian);
    const auto right = encodeUniversalFile ({ function });
    const auto bytes = "          40";
    REQUIRE (right.find (bytes) != std::string::npos);

    for (const std::string said : { "          20", "          41", "           0", "      999999" })
        for (const std::string_view closing : { "    -1\n", "\n    -1\n", "\r\n    -1" })
        {
            auto file = right.substr (0, right.size() - std::string_view ("\n    -1\n").size()) + std::string (closing);
            file.replace (file.find (bytes), said.size(), said);
            const auto read = std::get<UniversalFunction> (readUniversalFile (file, "file").at (0));
            CHECK (read.values == function.values);
        }
}

TEST_CASE ("What is not a universal file is refused with place and reason", "[files][universal]")
{
    const auto refusal = [] (const std::string& text)
    { return errorText ([&] { readUniversalFile (text, "a.uff"); }); };
    CHECK (refusal ("frequency,real\n1,2\n")
           == "a.uff: is not a universal file: it has no data set between lines of -1");
    CHECK (refusal ("    -1\n    15\n         1         0\n    -1\n")
           == "a.uff: line 3: has 2 numbers for a node; allowed: 7 (number, two systems, colour, three coordinates)");
    CHECK (refusal ("    -1\n    15\n")
           == "a.uff: line 2: data set 15 is not closed by a line of -1: the file ends too early");
    CHECK (refusal ("    -1\n    82\n         1 999999999         1\nText\n         1\n    -1\n")
           == "a.uff: line 4: has 999999999 nodes, more than the file contains");
    CHECK (refusal ("    -1\n   164\n         1SI\n nonsense\n    -1\n")
           == "a.uff: line 4: has ' nonsense'; allowed here: numbers");
}
