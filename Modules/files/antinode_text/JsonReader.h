#pragma once

#include <antinode_base/Reflection.h>

#include <nlohmann/json.hpp>

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace antinode
{
/** The allowed numbers, in the unit that the key names. */
struct NumberRange
{
    double minimum = 0, maximum = 0;
    bool aboveMinimum = false; ///< The minimum itself is not allowed.
    bool belowMaximum = false; ///< The maximum itself is not allowed.

    bool contains (double value) const;

    /** "0 to 200", or "above 0.5 to 1000". [any] */
    std::string text() const;
};

class JsonObject;

/** One value of a document that is being read, with its place for the errors. Every getter gives a value that is
   allowed, or throws InputError: source, JSON pointer, what is wrong, what is allowed. The document must outlive it.
   [worker] */
class JsonValue
{
public:
    /** The root of a document. @param source  how errors name the document */
    JsonValue (const nlohmann::json& document, const std::string& source);

    bool isObject() const { return json->is_object(); }
    bool isList() const { return json->is_array(); }
    bool isString() const { return json->is_string(); }

    /** True for text that is exactly this. */
    bool isWord (std::string_view word) const { return *json == word; }

    double number (const NumberRange&) const;
    int integer (int minimum, int maximum) const;
    bool boolean() const;

    /** 1 or -1. */
    int sign() const;

    /** Text without control characters; line breaks only where they are allowed. */
    std::string text (std::size_t maximumBytes, bool lineBreaksAllowed = false) const;

    /** A list whose number of entries is within these bounds. */
    std::vector<JsonValue> items (std::size_t minimum, std::size_t maximum) const;

    /** A list of numbers. */
    std::vector<double> numbers (std::size_t minimumCount, std::size_t maximumCount, const NumberRange&) const;

    /** One number, as a list of one, or a list of numbers. */
    std::vector<double> numberOrNumbers (std::size_t maximumCount, const NumberRange&) const;

    /** The value that goes with one of these words. */
    template <typename T, std::size_t count>
    T choice (const WordList<T, count>& words) const
    {
        for (const auto& [word, value] : words)
            if (isWord (word))
                return value;

        failChoice (listWords (words));
    }

    /** An object with no other keys than these. */
    JsonObject object (std::vector<std::string_view> allowedKeys) const;

    /** The entry of an object, where it has one. */
    std::optional<JsonValue> find (std::string_view key) const;

    /** The entry of an object. @throws InputError  when it is missing */
    JsonValue required (std::string_view key) const;

    /** Checks that the document is an object that says "schema": this one. */
    void requireSchema (std::string_view schema) const;

    /** Throws InputError with this value's place. */
    [[noreturn]] void fail (const std::string& wrong) const;

    /** The value for a message: "is -7", "is a list". */
    std::string description() const;

private:
    friend class JsonObject;

    JsonValue (const nlohmann::json&, std::string source, std::string pointer);
    JsonValue child (std::string_view key, const nlohmann::json&) const;
    void requireCount (std::size_t minimum, std::size_t maximum) const;
    [[noreturn]] void failChoice (const std::vector<std::string_view>& allowed) const;

    const nlohmann::json* json;
    std::string source;
    std::string pointer;
};

/** An object that is being read: only keys that are known, all that are needed. [worker] */
class JsonObject
{
public:
    /** @throws InputError  when the value is no object or has a key that is not allowed */
    JsonObject (JsonValue, std::vector<std::string_view> allowedKeys);

    /** @throws InputError  when the key is missing */
    JsonValue required (std::string_view key) const { return value.required (key); }

    std::optional<JsonValue> optional (std::string_view key) const { return value.find (key); }

    bool has (std::string_view key) const { return value.find (key).has_value(); }

    /** The one of two keys that is given. @throws InputError  when none or both are */
    std::pair<std::string_view, JsonValue> oneOf (std::string_view first, std::string_view second) const;

    /** Throws InputError with this object's place. */
    [[noreturn]] void fail (const std::string& wrong) const { value.fail (wrong); }

private:
    JsonValue value;
};

/** The allowed ranges in files, wide enough for any device that can be built. In the unit that the keys name. */
namespace ranges
{
constexpr std::size_t maximumCeramics = 1024;
constexpr std::size_t maximumModes = 5000;
constexpr std::size_t maximumPoints = 100000;
constexpr std::size_t maximumNameBytes = 200;
constexpr std::size_t maximumDescriptionBytes = 20000;

constexpr NumberRange lengthMillimetre { 1e-4, 1e5 };
constexpr NumberRange positionMillimetre { -1e5, 1e5 };
constexpr NumberRange angleDegrees { -360, 360 };
constexpr NumberRange supportStiffness { 0, 1e9 }; // in N and mm, per length, area or not
constexpr NumberRange supportDamping { 0, 1e9 };   // N s/m
constexpr NumberRange supportLossFactor { 0, 10 };
constexpr NumberRange massPerArea { 0, 1e5 }; // kg/m^2
constexpr NumberRange massGram { 0, 1e9 };
constexpr NumberRange frequencyHz { 1e-3, 1e8 };
constexpr NumberRange voltage { 1e-3, 1e5 };
constexpr NumberRange slewVoltsPerMicrosecond { 1e-6, 1e6 };
constexpr NumberRange currentMilliampere { 1e-6, 1e6 };
constexpr NumberRange capacitanceNanofarad { 1e-6, 1e9 };
constexpr NumberRange lossFactor { 0, 1 };
constexpr NumberRange timeMillisecond { 1e-3, 60000 };
constexpr NumberRange dampingRatio { 0, 1, true, true };
constexpr NumberRange qualityFactor { 0.5, 1e9, true };
constexpr NumberRange frequencySpreadPercent { 0, 10 };
constexpr NumberRange spreadPercent { 0, 50 };
} // namespace ranges
} // namespace antinode
