#include "Work.h"

#include <condition_variable>
#include <mutex>

namespace antinode
{
namespace
{
namespace py = pybind11;
using namespace std::chrono_literals;

/** A look takes the GIL, for which a busy thread of Python lets wait 5 ms: rare enough for that not to count, and
    quick for who presses Ctrl+C. */
constexpr auto lookInterval = 50ms;
constexpr auto showInterval = 100ms;

bool isMainThread()
{
    const auto threading = py::module_::import ("threading");
    return threading.attr ("current_thread")().is (threading.attr ("main_thread")());
}
} // namespace

Work::Work (py::object progressToShow) : shown (std::move (progressToShow)), hasSignals (isMainThread()) {}

/** Asked so often that a clock would cost a tenth of a design: a thread of its own says when it is time to look. */
bool Work::goesOn()
{
    if (isEnded)
        return false;

    if (! isLookDue || std::this_thread::get_id() != owner)
        return true;

    isLookDue = false;
    const py::gil_scoped_acquire withGil;

    if (PyErr_CheckSignals() != 0)
        end (std::make_exception_ptr (py::error_already_set()));

    return ! isEnded;
}

void Work::tick (const std::stop_token& stop)
{
    std::mutex mutex;
    std::condition_variable_any stopped;
    std::unique_lock lock (mutex);

    while (hasSignals && ! stop.stop_requested())
    {
        stopped.wait_for (lock, stop, lookInterval, [] { return false; });
        isLookDue = true;
    }
}

void Work::end (std::exception_ptr why)
{
    failure = std::move (why);
    isEnded = true;
}

void Work::show (const std::string& what, double share)
{
    if (isEnded || (share < 1 && Clock::now() < nextShow))
        return;

    const py::gil_scoped_acquire withGil;

    try
    {
        shown (what, share);
    }
    catch (const py::error_already_set&)
    {
        end (std::current_exception());
    }

    nextShow = Clock::now() + showInterval;
}

ShowProgress Work::progress()
{
    if (shown.is_none())
        return {};

    return [this] (const std::string& what, double share) { show (what, share); };
}
} // namespace antinode
