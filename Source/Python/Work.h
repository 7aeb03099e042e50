#pragma once

#include <antinode_base/Progress.h>
#include <antinode_base/Watch.h>

#include <pybind11/pybind11.h>

#include <atomic>
#include <chrono>
#include <exception>
#include <stop_token>
#include <thread>
#include <utility>

namespace antinode
{
/** Long work on behalf of Python: without the GIL, so that other threads of Python go on; ended by Ctrl+C, and by an
    exception of the function that shows progress. */
class Work
{
public:
    /** @param progressToShow  a function of what is being done and the share of it that is done; None: nothing is
       shown. [any] with the GIL */
    explicit Work (pybind11::object progressToShow);

    /** What the work gives. @throws  what the work throws; KeyboardInterrupt, or the exception of the progress function
        [worker] with the GIL, which is released meanwhile */
    template <typename Function>
    auto run (const Function& function)
    {
        try
        {
            const pybind11::gil_scoped_release withoutGil;
            const std::jthread ticker ([this] (const std::stop_token& stop) { tick (stop); });
            const WatchScope scope ([this] { return goesOn(); });
            auto result = function();

            if (isEnded) // After the last look of the work.
                throw Cancelled();

            return result;
        }
        catch (const Cancelled&)
        {
            if (failure)
                std::rethrow_exception (failure);

            throw;
        }
    }

    /** Passes progress on to Python, at most ten times a second. [worker] without the GIL */
    void show (const std::string& what, double share);

    /** show() as a function; empty where nothing is shown. It must not outlive the work. [any] */
    ShowProgress progress();

private:
    using Clock = std::chrono::steady_clock;

    bool goesOn();
    void tick (const std::stop_token&);
    void end (std::exception_ptr why);

    pybind11::object shown;
    bool hasSignals; ///< Python handles signals in its main thread only.
    std::thread::id owner = std::this_thread::get_id();
    Clock::time_point nextShow = Clock::now();
    std::exception_ptr failure;
    std::atomic<bool> isEnded { false }, isLookDue { false };
};

/** Work without progress and result. @throws  as Work [worker] with the GIL, which is released meanwhile */
template <typename Function>
void workAway (const Function& function)
{
    Work (pybind11::none())
        .run (
            [&]
            {
                function();
                return true;
            });
}
} // namespace antinode
