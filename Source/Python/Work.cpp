#include "Work.h"

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

bool Work::goesOn()
{
    if (isEnded)
        return false;

    if (! hasSignals || std::this_thread::get_id() != owner || Clock::now() < nextLook)
        return true;

    const py::gil_scoped_acquire withGil;

    if (PyErr_CheckSignals() != 0)
        end (std::make_exception_ptr (py::error_already_set()));

    nextLook = Clock::now() + lookInterval;
    return ! isEnded;
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
