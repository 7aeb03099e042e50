#pragma once

#if defined(ANTINODE_RTSAN)
// NOLINTBEGIN (bugprone-reserved-identifier, readability-identifier-naming): RealtimeSanitizer's own names.
extern "C" void __rtsan_realtime_enter();
extern "C" void __rtsan_realtime_exit();
// NOLINTEND
#endif

namespace antinode::test
{
/** Tells RealtimeSanitizer, where it is linked, that the thread is a real-time one while an instance lives. */
struct RealtimeScope
{
#if defined(ANTINODE_RTSAN)
    RealtimeScope()
    {
        __rtsan_realtime_enter();
    }
    ~RealtimeScope()
    {
        __rtsan_realtime_exit();
    }
#else
    RealtimeScope() = default;
    ~RealtimeScope() {} // NOLINT (modernize-use-equals-default): so that no compiler calls an instance unused.
#endif
    RealtimeScope (const RealtimeScope&) = delete;
    RealtimeScope& operator= (const RealtimeScope&) = delete;
};
} // namespace antinode::test
