#include "History.h"

#include <algorithm>
#include <utility>

namespace antinode
{
namespace
{
constexpr juce::uint32 joinWithin = 600; // ms: arrow keys and steps of a wheel follow each other closely
constexpr std::size_t maximumEntries = 200;

/** What the user changed. A device may get its focus later, when it is solved: then all of its parameters change. */
bool isChange (const std::string& name, const SessionState& before, const SessionState& after, const Parameters& all)
{
    const auto ofFocus = all.ofFocus();
    const auto isOfFocus = std::find (ofFocus.begin(), ofFocus.end(), all.find (name)) != ofFocus.end();
    return before.parameters.at (name) != after.parameters.at (name) || (before.device != after.device && isOfFocus);
}

/** Keeps of both states only the parameters that differ, and of these those that the user moved. */
void keepChanges (SessionState& before, SessionState& after, const std::set<std::string>* gestured,
                  const Parameters& all)
{
    for (const auto& [name, value] : std::map (after.parameters))
    {
        const auto isOthers = gestured != nullptr && gestured->count (name) == 0;

        if (name == "arm" || isOthers || ! isChange (name, before, after, all))
        {
            before.parameters.erase (name);
            after.parameters.erase (name);
        }
    }
}

bool isSame (const SessionState& before, const SessionState& after)
{
    return before.parameters == after.parameters && before.mutes == after.mutes && before.device == after.device
           && before.focus == after.focus && before.following == after.following;
}

bool changeSameParameters (const SessionState& one, const SessionState& other)
{
    const auto sameNames =
        one.parameters.size() == other.parameters.size()
        && std::equal (one.parameters.begin(), one.parameters.end(), other.parameters.begin(),
                       [] (const auto& left, const auto& right) { return left.first == right.first; });
    return sameNames && one.mutes == other.mutes && one.device == other.device && one.focus == other.focus
           && one.following == other.following;
}
} // namespace

History::History (AntinodeProcessor& processorToWatch) : processor (processorToWatch)
{
    for (auto* const parameter : processor.parameters().all())
        parameter->addListener (this);
}

History::~History()
{
    for (auto* const parameter : processor.parameters().all())
        parameter->removeListener (this);
}

void History::record (const std::function<void()>& change)
{
    auto before = processor.state();
    change();
    closeEntry();
    add (std::move (before), nullptr);
    closeEntry();
}

void History::parameterGestureChanged (int index, bool isStarting)
{
    if (isApplying)
        return;

    if (isStarting)
    {
        if (gestures++ == 0)
        {
            atStart = processor.state();
            gestured.clear();
        }

        gestured.insert (
            processor.parameters().all()[static_cast<std::size_t> (index)]->getParameterID().toStdString());
    }
    else if (gestures > 0 && --gestures == 0)
        add (std::move (atStart), &gestured);
}

void History::add (SessionState before, const std::set<std::string>* moved)
{
    auto after = processor.state();
    keepChanges (before, after, moved, processor.parameters());

    if (isSame (before, after))
        return;

    const auto now = juce::Time::getMillisecondCounter();
    entries.resize (position);

    if (mayJoin && position > 0 && now - entries.back().time < joinWithin
        && changeSameParameters (entries.back().after, after))
    {
        entries.back().after = std::move (after);
        entries.back().time = now;
        return;
    }

    push ({ std::move (before), std::move (after), now });
    mayJoin = true;
}

void History::push (Entry entry)
{
    entries.resize (position);

    if (entries.size() == maximumEntries)
        entries.erase (entries.begin());

    entries.push_back (std::move (entry));
    position = entries.size();
}

void History::resetDrift()
{
    auto known = processor.session().following().drift();

    if (known == nullptr)
        return;

    auto state = processor.state();
    state.parameters.clear();
    push ({ state, state, juce::Time::getMillisecondCounter(), std::move (known) });
    closeEntry();
    processor.session().following().setDrift (nullptr);
}

void History::undo()
{
    if (! canUndo())
        return;

    auto& entry = entries[--position];

    // With the focus that was chosen for it since.
    if (entry.before.device != entry.after.device)
    {
        entry.after.focus = processor.state().focus;

        for (auto& [name, value] : entry.after.parameters)
            value = processor.parameters().values().at (name);
    }

    if (entry.drift != nullptr)
        processor.session().following().setDrift (entry.drift);
    else
        apply (entry.before, entry.after);
}

void History::redo()
{
    if (! canRedo())
        return;

    const auto& entry = entries[position++];

    if (entry.drift != nullptr)
        processor.session().following().setDrift (nullptr);
    else
        apply (entry.after, entry.before);
}

void History::apply (const SessionState& wanted, const SessionState& present)
{
    auto state = processor.state();
    const auto isOtherDevice = wanted.device != present.device;

    for (const auto& [name, value] : wanted.parameters)
        state.parameters[name] = value;

    if (isOtherDevice)
        state.device = wanted.device;

    if (wanted.focus != present.focus || isOtherDevice)
        state.focus = wanted.focus;

    if (wanted.mutes != present.mutes)
        state.mutes = wanted.mutes;

    if (wanted.following != present.following)
        state.following = wanted.following;

    const juce::ScopedValueSetter<bool> applying (isApplying, true);
    processor.setState (state, isOtherDevice);
    closeEntry();
}
} // namespace antinode
