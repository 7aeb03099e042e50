#pragma once

namespace antinode
{
/** mm to m (or mm/s to m/s), correctly rounded: 24 becomes the double next to 0.024. [any] */
double fromMillimetres (double millimetres);

/** ms to s, correctly rounded. [any] */
double fromMilliseconds (double milliseconds);

/** us to s, correctly rounded. [any] */
double fromMicroseconds (double microseconds);

/** Degrees to rad. [any] */
double fromDegrees (double degrees);

/** V/us to V/s. [any] */
double fromVoltsPerMicrosecond (double voltsPerMicrosecond);

/** mA to A, correctly rounded. [any] */
double fromMilliamperes (double milliamperes);

/** g to kg, correctly rounded. [any] */
double fromGrams (double grams);

/** N/mm to N/m. [any] */
double fromNewtonsPerMillimetre (double newtonsPerMillimetre);

/** nF to F. [any] */
double fromNanofarads (double nanofarads);

/** Hz to rad/s. [any] */
double fromHertz (double hertz);

/** % to a share, correctly rounded. [any] */
double fromPercent (double percent);

/** The number of mm that fromMillimetres turns into this length again; of several the one with the fewest digits. A few
    lengths in a hundred have none, because a double in mm is coarser there: then the nearest. [any] */
double toMillimetres (double metres);

/** The same for ms. [any] */
double toMilliseconds (double seconds);

/** The same for us. [any] */
double toMicroseconds (double seconds);

/** The same for degrees; a third of all angles have no exact number. [any] */
double toDegrees (double radians);

/** The same for V/us. [any] */
double toVoltsPerMicrosecond (double voltsPerSecond);

/** The same for g. [any] */
double toGrams (double kilograms);

/** N/m to N/mm, correctly rounded. [any] */
double toNewtonsPerMillimetre (double newtonsPerMetre);

/** The same for nF. [any] */
double toNanofarads (double farads);

/** The same for %. [any] */
double toPercent (double share);

/** The same for Hz; here about a third of all values have no exact number. [any] */
double toHertz (double angularFrequency);
} // namespace antinode
