#pragma once

#include "GoodFiles.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <functional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace antinode
{
/** A file that no reader may accept. */
struct BrokenFile
{
    std::string name;  ///< How it is broken.
    std::string bytes; ///< What the file holds.
    bool isFocus = false;
};

/** Makes broken files out of good ones, one fault in each. */
class FileBreaker
{
public:
    std::vector<BrokenFile> takeFiles()
    {
        for (const auto& good : goodFiles())
            breakFile (good);

        addNoDocuments();
        return std::move (files);
    }

private:
    using Json = nlohmann::ordered_json;
    using Pointer = Json::json_pointer;

    void add (const std::string& name, const std::string& bytes)
    {
        constexpr std::size_t longestName = 80;

        if (known.insert (bytes).second)
            files.push_back (
                { (std::string (current.name) + ": " + name).substr (0, longestName), bytes, current.isFocus });
    }

    void breakFile (const GoodFile& good)
    {
        current = good;
        const auto document = Json::parse (good.text);
        visit (document, Pointer(),
               [&] (const Pointer& place, const Json& value) { breakValue (document, place, value); });

        if (good.isMinimal)
            return;

        const auto text = document.dump();
        breakText (text);
        breakBytes (text);
        duplicateKeys (text);
    }

    static void visit (const Json& value, const Pointer& place,
                       const std::function<void (const Pointer&, const Json&)>& action)
    {
        if (! place.empty())
            action (place, value);

        if (value.is_object())
            for (const auto& [key, entry] : value.items())
                visit (entry, place / key, action);

        if (value.is_array())
            for (std::size_t i = 0; i < value.size(); ++i)
                visit (value[i], place / i, action);
    }

    void replace (const Json& document, const Pointer& place, const Json& value)
    {
        auto changed = document;
        changed[place] = value;
        add (place.to_string() + " is " + value.dump(), changed.dump());
    }

    void breakValue (const Json& document, const Pointer& place, const Json& value)
    {
        if (current.isMinimal)
        {
            remove (document, place);
            return;
        }

        replace (document, place, nullptr);

        if (! value.is_object())
            replace (document, place, Json::object());

        if (value.is_number())
            breakNumber (document, place);
        else if (value.is_string())
            breakWord (document, place);
        else if (value.is_array())
            breakList (document, place, value);
        else if (value.is_object())
            breakObject (document, place);
    }

    /** In a minimal file every key is needed, and so is every entry of its lists, whose lengths depend on each other; a
       device may have no ceramics. */
    void remove (const Json& document, const Pointer& place)
    {
        auto changed = document;
        auto& parent = changed[place.parent_pointer()];

        if (parent.is_object())
            parent.erase (place.back());
        else if (place.parent_pointer().back() != "ceramics" && place.parent_pointer().back() != "participation_per_V")
            parent.erase (static_cast<std::size_t> (std::stoul (place.back())));

        if (changed != document)
            add (place.to_string() + " is missing", changed.dump());
    }

    void breakNumber (const Json& document, const Pointer& place)
    {
        static const std::set<std::string> positive { "length_mm",
                                                      "width_mm",
                                                      "thickness_mm",
                                                      "length_x_mm",
                                                      "length_y_mm",
                                                      "voltage_V",
                                                      "E1_GPa",
                                                      "E2_GPa",
                                                      "G12_GPa",
                                                      "youngs_modulus_GPa",
                                                      "density_kg_m3",
                                                      "full_scale_V",
                                                      "damping_ratio",
                                                      "count",
                                                      "quality_factor",
                                                      "maximum_frequency_Hz",
                                                      "frequency_Hz",
                                                      "focus_time_ms",
                                                      "window_ms",
                                                      "brake",
                                                      "phase",
                                                      "polarity",
                                                      "permittivity_relative",
                                                      "capacitance_nF",
                                                      "maximum_duration_ms",
                                                      "peak_velocity_mm_s" };

        for (const auto& wrong : { Json ("text"), Json (true), Json::array(), Json (1e300), Json (-1e300) })
            replace (document, place, wrong);

        if (positive.contains (place.back()))
        {
            replace (document, place, 0);
            replace (document, place, -7);
        }

        for (const auto* const token : { "NaN", "-Infinity", "1e999" })
            replaceByToken (document, place, token);
    }

    void replaceByToken (const Json& document, const Pointer& place, const std::string& token)
    {
        const std::string mark = "\"@\"";
        auto changed = document;
        changed[place] = "@";
        auto text = changed.dump();
        text.replace (text.find (mark), mark.size(), token);
        add (place.to_string() + " is " + token, text);
    }

    void breakWord (const Json& document, const Pointer& place)
    {
        replace (document, place, 7);
        replace (document, place, Json::array());

        for (const auto& wrong : { std::string ("line\u0007"), std::string (100000, 'x') })
            replace (document, place, wrong);
    }

    void breakList (const Json& document, const Pointer& place, const Json& list)
    {
        replace (document, place, "text");
        replace (document, place, false);
        auto longer = list;
        longer.push_back (nullptr);
        replace (document, place, longer);
    }

    void breakObject (const Json& document, const Pointer& place)
    {
        replace (document, place, "text");
        replace (document, place, Json::array());
        replace (document, place / "surprise", 1);
        replace (document, place / "a/b~\n\"", 1);
    }

    /** Faults of the text that hold for any document. */
    void breakText (const std::string& text)
    {
        constexpr std::size_t cuts = 24;

        for (std::size_t i = 1; i < cuts; ++i)
            add ("cut after " + std::to_string (i) + "/24", text.substr (0, i * text.size() / cuts));

        add ("cut before the last brace", text.substr (0, text.size() - 1));

        for (const auto* const rest : { "x", "{}", ",", "]", "}", "\x01", " // end" })
            add (std::string ("followed by ") + rest, text + rest);

        add ("with a comment", "/* note */" + text);
        add ("with a comma too many", text.substr (0, text.size() - 1) + ",}");
        add ("with a member without a key", text.substr (0, text.size() - 1) + ",7}");
        add ("an unknown key", text.substr (0, text.size() - 1) + ",\"surprise\":1}");
        add ("a later schema", std::string (text).replace (text.find ("/1\""), 3, "/2\""));
        auto quotes = text;
        std::replace (quotes.begin(), quotes.end(), '"', '\'');
        add ("with single quotation marks", quotes);

        for (const auto* const token :
             { "nan", "Infinity", "+1", "01", ".5", "1.", "0x10", "1,5", "tru", "undefined", "1e", "--1" })
            add (std::string ("with the token ") + token,
                 text.substr (0, text.size() - 1) + ",\"surprise\":" + token + "}");

        for (const std::size_t depth : { 64U, 65U, 1000U, 100000U })
        {
            const auto lists = std::string (depth, '[') + std::string (depth, ']');
            add ("nested " + std::to_string (depth), text.substr (0, text.size() - 1) + ",\"name\":" + lists + "}");
        }
    }

    void breakBytes (const std::string& text)
    {
        using namespace std::string_literals;
        constexpr std::size_t places = 6;

        for (const auto& bytes :
             { "\xff"s, "\xc0\x80"s, "\xed\xa0\x80"s, "\xf4\x90\x80\x80"s, "\xe2\x82"s, "\0"s, "\x1b"s })
            for (std::size_t i = 0; i < places; ++i)
                add ("bytes that are no text, " + std::to_string (i) + "/6",
                     std::string (text).insert (i * text.size() / places, bytes));

        std::string wide = "\xff\xfe";

        for (const auto character : text)
            (wide += character) += '\0';

        add ("UTF-16", wide);
        add ("bytes after a NUL", text + '\0' + text);
    }

    void duplicateKeys (const std::string& text)
    {
        for (auto colon = text.find ("\":"); colon != std::string::npos; colon = text.find ("\":", colon + 2))
        {
            const auto begin = text.rfind ('"', colon - 1);
            const auto member = text.substr (begin, colon - begin) + "\":null,";
            add ("twice " + text.substr (begin, colon - begin + 1) + " at " + std::to_string (begin),
                 std::string (text).insert (begin, member));
        }
    }

    void addNoDocuments()
    {
        using namespace std::string_literals;
        current = { "no document", {}, false, false };

        for (const auto& text : { ""s,
                                  " "s,
                                  "\n\n"s,
                                  "\0"s,
                                  "null"s,
                                  "true"s,
                                  "7"s,
                                  "\"text\""s,
                                  "[]"s,
                                  "{}"s,
                                  "[{}]"s,
                                  "{\"\":{}}"s,
                                  "\xef\xbb\xbf"s,
                                  "\xff\xfe"s,
                                  "PK\x03\x04"s,
                                  "<html>"s,
                                  "{\"schema\":null}"s,
                                  "{\"schema\":\"\"}"s,
                                  std::string (100000, '['),
                                  std::string (100000, '{'),
                                  std::string (1000000, ' ') })
            add ("text " + std::to_string (files.size()), text);
    }

    GoodFile current;
    std::vector<BrokenFile> files;
    std::set<std::string> known;
};

/** More than a thousand distinct files, each broken in one way; neighbours in the list are broken in similar ways. */
inline std::vector<BrokenFile> brokenFiles()
{
    return FileBreaker().takeFiles();
}
} // namespace antinode
