#include "Support/ErrorText.h"

#include <antinode_base/MessageText.h>
#include <antinode_text/JsonText.h>

#include <catch2/catch.hpp>

using namespace antinode;

namespace
{
std::string parseError (std::string_view text)
{
    return errorText ([&] { parseJson (text, "my.json"); });
}

std::string nested (std::size_t depth)
{
    return std::string (depth, '[') + std::string (depth, ']');
}
} // namespace

TEST_CASE ("JSON text becomes the document it writes", "[files]")
{
    const auto document =
        parseJson (R"({ "a": [1, -2.5, true, null, "\u00e9"], "b": { "c": 18446744073709551615 } })", "my.json");
    CHECK (document["a"] == nlohmann::json::array ({ 1, -2.5, true, nullptr, "é" }));
    CHECK (document["b"]["c"] == 18446744073709551615u);
    CHECK (parseJson ("\xef\xbb\xbf{}", "my.json") == nlohmann::json::object());
}

TEST_CASE ("Errors of JSON text name line and column", "[files]")
{
    CHECK (parseError ("{\n  \"a\": 1,\n  b: 2\n}")
           == "my.json: line 3, column 3: is not valid JSON: syntax error while parsing object key - invalid literal; "
              "expected "
              "string literal");
    CHECK (parseError ("{\"a\": 1e999}").find ("my.json: line 1, column 11: has a number that is too large: '1e999'")
           == 0);
    CHECK (parseError ("{\"a\": NaN}").find ("my.json: line 1, column 7: is not valid JSON") == 0);
    CHECK (parseError (std::string_view ("{}\0{}", 5))
           == "my.json: line 1, column 3: has a NUL byte; allowed: UTF-8 text");
    CHECK (parseError (" \n") == "my.json: is empty; allowed: a JSON document");
}

TEST_CASE ("A key that is given twice is found wherever it stands", "[files]")
{
    CHECK (parseError (R"({ "a": 1, "a": 2 })") == "my.json: /a: is given twice; allowed: once");
    CHECK (parseError (R"({ "b": [0, { "c": 1, "d": { "x/y": 1, "x/y": 1 } }] })")
           == "my.json: /b/1/d/x~1y: is given twice; allowed: once");
    CHECK (parseError (R"({ "a": { "a": 1 }, "b": { "a": [{ "a": 1 }, { "a": 1 }] } })").empty());
}

TEST_CASE ("Nesting ends at 64 levels", "[files]")
{
    CHECK (parseError (nested (64)).empty());
    CHECK (parseError (nested (65)) == "my.json: is nested too deeply; allowed: up to 64 levels");
    CHECK (parseError (std::string (1000000, '[')) == "my.json: is nested too deeply; allowed: up to 64 levels");
}

TEST_CASE ("An assignment sets one value of a document", "[files]")
{
    auto document = parseJson (R"({ "targets": [{ "x_mm": 0 }], "name": "a" })", "focus");
    applyAssignment (document, "targets.0.x_mm=24");
    applyAssignment (document, "targets.1={\"shape\": \"bump\"}");
    applyAssignment (document, "name=a=b");
    applyAssignment (document, "allocation.method=exact");
    applyAssignment (document, "probes_mm.0=[24, 0]");
    applyAssignment (document, "modes.captured=NaN");

    CHECK (document
           == parseJson (R"({ "targets": [{ "x_mm": 24 }, { "shape": "bump" }], "name": "a=b", "probes_mm": [[24, 0]],
                                       "allocation": { "method": "exact" }, "modes": { "captured": "NaN" } })",
                         "focus"));
}

TEST_CASE ("An assignment that does not fit says why and changes nothing", "[files]")
{
    const auto original = parseJson (R"({ "targets": [{ "x_mm": 0 }] })", "focus");
    auto document = original;
    const auto error = [&] (std::string_view assignment)
    { return errorText ([&] { applyAssignment (document, assignment); }); };

    CHECK (error ("targets") == "assignment 'targets': has no '='; allowed: key=value, for example targets.0.x_mm=24");
    CHECK (error ("=3") == "assignment '=3': has an empty key; allowed: for example targets.0.x_mm=24");
    CHECK (error ("a..b=3") == "assignment 'a..b=3': has an empty key; allowed: for example targets.0.x_mm=24");
    CHECK (error ("targets.2=3") == "assignment 'targets.2=3': index 2 is beyond the list; allowed: 0 to 1");
    CHECK (error ("targets.x=3") == "assignment 'targets.x=3': 'x' does not fit a list; allowed: an index from 0");
    CHECK (error ("targets.-1=3") == "assignment 'targets.-1=3': '-1' does not fit a list; allowed: an index from 0");
    CHECK (error ("targets.0.0=3")
           == "assignment 'targets.0.0=3': '0' does not fit an object; allowed: the name of a key");
    CHECK (error ("targets.0.x_mm.y=3")
           == "assignment 'targets.0.x_mm.y=3': 'y' does not fit: its parent is neither an object nor a list");
    CHECK (error ("targets.1.a.2=3") == "assignment 'targets.1.a.2=3': index 2 is beyond the list; allowed: 0 to 0");
    CHECK (error ("a=\xff") == "assignment 'a=?': is not UTF-8 text");
    CHECK (error ("a.b.c.d.e.f.g.h.i.j.k.l.m.n.o.p.q=1").find ("has too many keys") != std::string::npos);
    CHECK (document == original);
}

TEST_CASE ("Text from outside fits on one line of a message", "[files]")
{
    CHECK (printable ("a\nb\x1b[31m\x7f\xff") == "a?b?[31m??");
    CHECK (printable ("Gerät \xe2\x80\xa8 \xc2\x85") == "Gerät ? ?");
    CHECK (printable ("abcdef", 3) == "abc...");
    CHECK (printable ("aé", 2) == "a...");
    CHECK (inQuotes ("x") == "'x'");
    CHECK (isUtf8 ("\xf0\x9f\x8e\xb5 \xed\x9f\xbf \xef\xbf\xbf"));

    for (const auto* const wrong : { "\x80", "\xc1\xbf", "\xe0\x9f\xbf", "\xed\xa0\x80", "\xf0\x8f\xbf\xbf",
                                     "\xf4\x90\x80\x80", "\xe2\x82", "\xf8" })
        CHECK_FALSE (isUtf8 (wrong));
}

TEST_CASE ("Numbers of messages are short and exact", "[files]")
{
    CHECK (numberText (-7) == "-7");
    CHECK (numberText (100000) == "100000");
    CHECK (numberText (0.0001) == "0.0001");
    CHECK (numberText (0.1 + 0.2) == "0.30000000000000004");
}

TEST_CASE ("A misspelt word gets the word it stands for", "[files]")
{
    const std::vector<std::string_view> keys { "length_mm", "width_mm", "thickness_mm" };
    CHECK (didYouMean ("lenght_mm", keys) == " (did you mean 'length_mm'?)");
    CHECK (didYouMean ("width", keys) == " (did you mean 'width_mm'?)");
    CHECK (didYouMean ("tickness_mm", keys) == " (did you mean 'thickness_mm'?)");
    CHECK (didYouMean ("colour", keys).empty());
    CHECK (didYouMean (std::string (1000, 'x'), keys).empty());
}
