#include "Support/ErrorText.h"
#include "Support/RunProgram.h"

#include <antinode_responses/MatlabFile.h>
#include <antinode_responses/MatlabResponses.h>

#include <matio.h>

#include <catch2/catch.hpp>

#include <array>
#include <cmath>
#include <complex>
#include <numeric>

using namespace antinode;
using namespace antinode::test;

namespace
{
struct Sizes
{
    std::vector<std::size_t> frequencies, responses;
};

/** A file as libmatio writes it: f, H counting 0, 1, 2 ... with its negative as imaginary part, unit. */
std::string writtenBy (mat_ft version, matio_compression compression, Sizes sizes, const char* abscissa = "f")
{
    const TemporaryFolder folder;
    const auto path = (folder.path() / "a.mat").string();
    auto* const file = Mat_CreateVer (path.c_str(), nullptr, version);
    const auto write = [&] (matvar_t* variable)
    {
        Mat_VarWrite (file, variable, compression);
        Mat_VarFree (variable);
    };
    std::vector<double> frequencies (sizes.frequencies[0] * sizes.frequencies[1]);
    std::iota (frequencies.begin(), frequencies.end(), 1);
    std::vector<double> real (
        std::accumulate (sizes.responses.begin(), sizes.responses.end(), std::size_t (1), std::multiplies<>())),
        imaginary;
    std::iota (real.begin(), real.end(), 0);

    for (const auto number : real)
        imaginary.push_back (-number);

    mat_complex_split_t parts { real.data(), imaginary.data() };
    std::string unit = "(mm/s)/V";
    std::array<std::size_t, 2> unitSizes { 1, unit.size() };
    write (Mat_VarCreate ("unit", MAT_C_CHAR, MAT_T_UTF8, 2, unitSizes.data(), unit.data(), 0));
    write (Mat_VarCreate (abscissa, MAT_C_DOUBLE, MAT_T_DOUBLE, 2, sizes.frequencies.data(), frequencies.data(), 0));
    write (Mat_VarCreate ("H", MAT_C_DOUBLE, MAT_T_DOUBLE, static_cast<int> (sizes.responses.size()),
                          sizes.responses.data(), &parts, MAT_F_COMPLEX));
    Mat_Close (file);
    return readContent (path);
}

Measurement measurementFromBytes (const std::string& bytes)
{
    return mergedResponses (
        { measurementFromMatlab (readMatlabFile (bytes, "a.mat"), "a.mat", CsvForm::byHeadings, {}) }, {});
}
} // namespace

TEST_CASE ("MATLAB files are read as libmatio writes them, compressed or not", "[files][matlab]")
{
    for (const auto compression : { MAT_COMPRESSION_NONE, MAT_COMPRESSION_ZLIB })
    {
        const auto variables =
            readMatlabFile (writtenBy (MAT_FT_MAT5, compression, { { 5, 1 }, { 5, 3, 2 } }), "a.mat");
        REQUIRE (variables.size() == 3);
        CHECK (variables[0].text == "(mm/s)/V");
        CHECK (variables[1].name == "f");
        CHECK (variables[1].real == std::vector<double> { 1, 2, 3, 4, 5 });
        CHECK (variables[2].sizes == std::vector<std::size_t> { 5, 3, 2 });
        CHECK (variables[2].real[29] == 29);
        CHECK (variables[2].imaginary[29] == -29);
    }
}

TEST_CASE ("The numbers of lines, points and references assign the dimensions of an array", "[files][matlab]")
{
    // Line f (of 5), point p (of 3) and driver i (of 2) of an array whose entries count up.
    struct Case
    {
        Sizes sizes;
        double line, point, reference;
    };

    for (const auto& each :
         { Case { { { 5, 1 }, { 5, 3, 2 } }, 1, 5, 15 }, Case { { { 1, 5 }, { 3, 5, 2 } }, 3, 1, 15 },
           Case { { { 5, 1 }, { 2, 3, 5 } }, 6, 2, 1 }, Case { { { 5, 1 }, { 3, 2, 5 } }, 6, 1, 3 } })
    {
        const auto measured = measurementFromBytes (writtenBy (MAT_FT_MAT5, MAT_COMPRESSION_ZLIB, each.sizes));
        REQUIRE (measured.responses.values.size() == 2);
        REQUIRE (measured.responses.points.rows() == 3);
        const auto expected = 1e-3 * (4 * each.line + 2 * each.point + each.reference);
        CHECK (measured.responses.values[1](4, 2).real() == Approx (expected));
        CHECK (measured.responses.values[1](4, 2).imag() == Approx (-expected));
    }

    const auto renamed = writtenBy (MAT_FT_MAT5, MAT_COMPRESSION_NONE, { { 5, 1 }, { 5, 3, 2 } }, "axis");
    CHECK (measurementFromBytes (renamed).responses.frequencies[4] == 5);
    const auto single = measurementFromBytes (writtenBy (MAT_FT_MAT5, MAT_COMPRESSION_NONE, { { 5, 1 }, { 5, 1 } }));
    CHECK (single.responses.values.size() == 1);
    CHECK (single.responses.points.rows() == 1);
}

TEST_CASE ("MATLAB files of other versions and damaged ones are refused in a sentence", "[files][matlab]")
{
    const auto refusal = [] (const std::string& bytes) { return errorText ([&] { measurementFromBytes (bytes); }); };
    const auto good = writtenBy (MAT_FT_MAT5, MAT_COMPRESSION_ZLIB, { { 5, 1 }, { 5, 3 } });
    CHECK (refusal (writtenBy (MAT_FT_MAT73, MAT_COMPRESSION_NONE, { { 5, 1 }, { 5, 3 } }))
           == "a.mat: is a MATLAB file of version 7.3; allowed: versions 4 to 7 (save it with '-v7')");
    CHECK (refusal (good.substr (0, 100)) == "a.mat: is not a MATLAB file of version 4 to 7");
    CHECK (refusal (good.substr (0, good.size() - 9)) == "a.mat: is damaged: an element is longer than the file");
    CHECK (refusal (good.substr (0, 128)).starts_with ("a.mat: has no vector of frequencies; allowed: one named 'f'"));
    CHECK (refusal (writtenBy (MAT_FT_MAT5, MAT_COMPRESSION_NONE, { { 4, 1 }, { 5, 3 } }))
           == "a.mat: has 0 complex arrays with a size of 4, the number of frequencies; allowed: one, or the name "
              "'H' or 'FRF'; "
              "it has 'unit' (1 x 8), 'f' (4 x 1), 'H' (5 x 3, complex)");

    for (std::size_t i = 128; i < good.size(); ++i) // No byte that is wrong does more than lead to a sentence.
    {
        auto bad = good;
        bad[i] = static_cast<char> (bad[i] ^ 0x55);
        refusal (bad);
    }
}

TEST_CASE ("Objects of MATLAB are named, with what to save instead", "[files][measurement]")
{
    const auto element = [] (std::uint32_t type, const std::string& data)
    {
        const auto size = static_cast<std::uint32_t> (data.size());
        return std::string (reinterpret_cast<const char*> (&type), 4)
               + std::string (reinterpret_cast<const char*> (&size), 4) + data
               + std::string ((8 - data.size() % 8) % 8, '\0');
    };
    const auto head = std::string ("MATLAB 5.0 MAT-file") + std::string (105, ' ') + std::string ("\0\1IM", 4);
    const std::string opaque { "\x11\0\0\0\0\0\0\0", 8 }, object { "\x3\0\0\0\0\0\0\0", 8 },
        sizes { "\1\0\0\0\1\0\0\0", 8 };
    const auto refusal = [&] (const std::string& matrix)
    { return errorText ([&] { measurementFromBytes (head + element (14, matrix)); }); };

    for (const auto& matrix : { element (6, opaque) + element (1, "G1") + element (1, "MCOS") + element (1, "frd"),
                                element (6, object) + element (5, sizes) + element (1, "G1") + element (1, "frd") })
    {
        const auto text = refusal (matrix);
        CHECK (text.find ("it has 'G1' (an object of class frd)") != text.npos);
        CHECK (
            text.find (
                "save arrays, of an frd or idfrd by G = chgFreqUnit (G1, 'Hz'); f = G.Frequency; H = G.ResponseData; "
                "save ('responses.mat', 'f', 'H', '-v7')")
            != text.npos);
    }
}

namespace
{
const std::vector<double> tens { 10, 20, 30, 40, 50, 60, 70, 80 };

MatlabVariable vectorOf (const std::string& name, std::vector<double> numbers)
{
    return { name, { numbers.size(), 1 }, std::move (numbers), {}, {}, {} };
}

MatlabVariable textOf (const std::string& name, const std::string& text)
{
    return { name, { 1, text.size() }, {}, {}, text, {} };
}

/** Line f (from 0) is value + f - f i. */
MatlabVariable responsesOf (const std::string& name, const std::vector<double>& values)
{
    MatlabVariable variable { name, { tens.size(), values.size() }, {}, {}, {}, {} };

    for (const auto value : values)
        for (std::size_t f = 0; f < tens.size(); ++f)
        {
            variable.real.push_back (value + static_cast<double> (f));
            variable.imaginary.push_back (-static_cast<double> (f));
        }

    return variable;
}

MeasurementFile readFrom (const std::vector<MatlabVariable>& variables, const std::vector<std::string>& names = {})
{
    return measurementFromMatlab (variables, "a.mat", CsvForm::byHeadings, names);
}

/** Points 1 and 2 have responses that begin with 1 and 2. */
void requireTwoPoints (const std::vector<MatlabVariable>& variables)
{
    INFO (variables.front().name);
    const auto measured = mergedResponses ({ readFrom (variables) }, {}).responses;
    REQUIRE (measured.points.rows() == 2);
    REQUIRE (measured.values.size() == 1);
    REQUIRE (measured.frequencies.size() == 8);
    CHECK (std::abs (measured.frequencies[7] - 80) < 1e-9);
    CHECK (std::abs (measured.values[0](3, 0) - std::complex<double> (4, -3)) < 1e-9);
    CHECK (std::abs (measured.values[0](3, 1) - std::complex<double> (5, -3)) < 1e-9);
}
} // namespace

TEST_CASE ("MATLAB variables in the layouts of many laboratories are the same responses", "[files][matlab]")
{
    const auto f = vectorOf ("f", tens);
    const auto one = responsesOf ("H1", { 1 }), two = responsesOf ("H2", { 2 }), both = responsesOf ("H", { 1, 2 });
    const auto named = [] (MatlabVariable variable, const std::string& name)
    {
        variable.name = name;
        return variable;
    };
    const auto part = [&named] (const MatlabVariable& variable, const std::string& name, bool isReal)
    {
        auto real = named (variable, name);
        real.real = isReal ? variable.real : variable.imaginary;
        real.imaginary.clear();
        return real;
    };
    const auto withFrequencies = [] (MatlabVariable variable, const std::string& name)
    {
        variable.name = name;
        ++variable.sizes[1];
        variable.real.insert (variable.real.begin(), tens.begin(), tens.end());
        variable.imaginary.insert (variable.imaginary.begin(), tens.size(), 0);
        return variable;
    };

    requireTwoPoints ({ f, both });
    requireTwoPoints ({ f, one, two });
    requireTwoPoints ({ f, named (two, "FRF_10"), named (one, "FRF_9") });
    requireTwoPoints ({ f, named (one, "H1_2"), named (two, "H1_3") });
    requireTwoPoints ({ named (f, "S(1).freq"), named (one, "S(1).H"), named (f, "S(2).freq"), named (two, "S(2).H") });
    requireTwoPoints ({ f, named (one, "H{1}"), named (two, "H{2}") });
    requireTwoPoints ({ vectorOf ("f_kHz", { 0.01, 0.02, 0.03, 0.04, 0.05, 0.06, 0.07, 0.08 }), both });
    requireTwoPoints (
        { vectorOf ("freq", { 0.01, 0.02, 0.03, 0.04, 0.05, 0.06, 0.07, 0.08 }), textOf ("freq_unit", "kHz"), both });
    requireTwoPoints ({ vectorOf ("FRF.x_values.start_value", { 10 }), vectorOf ("FRF.x_values.increment", { 10 }),
                        vectorOf ("FRF.x_values.number_of_values", { 8 }), named (both, "FRF.y_values.values") });
    requireTwoPoints ({ vectorOf ("df", { 10 }), vectorOf ("f0", { 10 }), both });
    requireTwoPoints ({ withFrequencies (one, "H1_2"), withFrequencies (two, "H1_3") });
    requireTwoPoints ({ withFrequencies (both, "data") });
    requireTwoPoints ({ f, part (both, "H_re", true), part (both, "H_im", false) });
    requireTwoPoints ({ f, part (both, "realH", true), part (both, "imagH", false) });
    requireTwoPoints ({ f, part (both, "d.H.Real", true), part (both, "d.H.Imaginary", false) });
    requireTwoPoints ({ f, both, textOf ("comment", "x"), vectorOf ("t", { 1, 2, 3 }) });

    auto columns = vectorOf ("data", tens); // f, re, im, re, im, without a complex number.
    columns.sizes = { 8, 5 };

    for (const auto* const response : { &one, &two })
        for (const auto* const numbers : { &response->real, &response->imaginary })
            columns.real.insert (columns.real.end(), numbers->begin(), numbers->end());

    requireTwoPoints ({ columns });

    auto size = part (both, "mag", true), phase = part (both, "phase_deg", true);

    for (std::size_t i = 0; i < size.real.size(); ++i)
    {
        const std::complex<double> value (both.real[i], both.imaginary[i]);
        size.real[i] = std::abs (value);
        phase.real[i] = std::arg (value) * 180 / std::acos (-1.0);
    }

    requireTwoPoints ({ f, size, phase });
}

TEST_CASE ("Of several MATLAB variables the responses are read, or those that are named", "[files][matlab]")
{
    const auto f = vectorOf ("f", tens);
    const auto response = responsesOf ("Hf_chan_2", { 1 }), spectrum = responsesOf ("Hf_Cross_Spec_chan_2", { 2 });
    const auto chosen = readFrom ({ f, response, spectrum });
    REQUIRE (chosen.responses.size() == 1);
    CHECK (chosen.responses[0].values[0] == 1.0);
    CHECK (chosen.remarks
           == std::vector<std::string> {
               "a.mat: 'Hf_chan_2' is read, 'Hf_Cross_Spec_chan_2' is not; --variables names others." });
    CHECK (readFrom ({ f, response, spectrum }, { "Hf_Cross_Spec_chan_2" }).responses[0].values[0] == 2.0);
    CHECK (errorText (
               [&] {
                   readFrom ({ f, response }, { "G" });
               })
           == "a.mat: has no responses in a variable 'G'; allowed for --variables: 'Hf_chan_2'");

    const auto left = responsesOf ("left", { 1 }), right = responsesOf ("right", { 2 });
    CHECK (errorText (
               [&] {
                   readFrom ({ f, left, right });
               })
               .find ("--variables names those to read: 'left', 'right'")
           != std::string::npos);
    const auto asked = readFrom ({ f, left, right }, { "right", "left" });
    REQUIRE (asked.responses.size() == 2);
    CHECK (asked.responses[0].point == "right");

    // H1 and H2 of one measurement are two estimates, not two points.
    auto h2 = responsesOf ("H2", { 10.1 });
    CHECK (readFrom ({ f, responsesOf ("H1", { 10 }), h2 }).responses.size() == 1);
    const auto grid = readFrom ({ f, responsesOf ("H1_1", { 1 }), responsesOf ("H1_2", { 2 }),
                                  responsesOf ("H2_1", { 3 }), responsesOf ("H2_2", { 4 }) });
    REQUIRE (grid.responses.size() == 4);
    CHECK (grid.responses[2].point == "2");
    CHECK (grid.responses[2].reference == "1");
}

TEST_CASE ("The unit of a MATLAB file stands in the structure of its responses", "[files][matlab]")
{
    auto values = responsesOf ("FRF.y_values.values", { 1 });
    const std::vector<MatlabVariable> testlab { vectorOf ("FRF.x_values.start_value", { 10 }),
                                                vectorOf ("FRF.x_values.increment", { 10 }),
                                                textOf ("FRF.x_values.quantity.label", "Hz"), values,
                                                textOf ("FRF.y_values.quantity.label", "g/lbf") };
    CHECK (readFrom (testlab).responses[0].unit.factor == Approx (9.80665 / 4.4482216));
    const auto unknown = readFrom ({ vectorOf ("f", tens), responsesOf ("H", { 1 }), textOf ("unit", "furlong/N") });
    REQUIRE (unknown.remarks.size() == 1);
    CHECK (unknown.remarks[0].starts_with ("a.mat: 'furlong/N' is not a known unit"));
}

TEST_CASE ("MATLAB files of level 4 are read as libmatio writes them", "[files][matlab]")
{
    const auto variables =
        readMatlabFile (writtenBy (MAT_FT_MAT4, MAT_COMPRESSION_NONE, { { 5, 1 }, { 5, 3 } }), "a.mat");
    REQUIRE (variables.size() >= 2); // libmatio may leave out the text.
    const auto &f = variables[variables.size() - 2], &h = variables.back();
    CHECK (f.real == std::vector<double> { 1, 2, 3, 4, 5 });
    CHECK (h.sizes == std::vector<std::size_t> { 5, 3 });
    CHECK (h.imaginary[14] == -14);
    const std::string text ("\x33\0\0\0\x01\0\0\0\x03\0\0\0\0\0\0\0\x05\0\0\0unit\0g/N", 28);
    CHECK (readMatlabFile (text, "a.mat").front().text == "g/N");

    const auto good = writtenBy (MAT_FT_MAT4, MAT_COMPRESSION_NONE, { { 5, 1 }, { 5, 3 } });

    for (std::size_t i = 0; i < good.size(); ++i) // No byte that is wrong does more than lead to a sentence.
    {
        auto bad = good;
        bad[i] = static_cast<char> (bad[i] ^ 0x55);
        errorText ([&] { measurementFromBytes (bad); });
    }

    CHECK (errorText ([&] { readMatlabFile (good.substr (0, good.size() - 9), "a.mat"); })
           == "a.mat: is damaged: an array is larger than the file");
}
