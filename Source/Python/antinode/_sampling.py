"""Cases that cover evenly what varies, and what each key explains of a result: on scipy.stats.qmc."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any, Mapping, Sequence

from . import _antinode
from ._checks import within, word
from ._documents import as_json
from .errors import InputError

if TYPE_CHECKING:
    from ._antinode import Floats

Index = dict[str, dict[str, float]]


def sampled(plan: Mapping[str, Any], scheme: str, cases: int, *, seed: int = 1) -> dict[str, Any]:
    """A plan of a sweep whose cases cover the ranges evenly, with listed values instead of distributions.

    :func:`sweep`, the command ``antinode sweep`` and its shards take it as any other plan.

    Args:
        plan: a dict with the keys of a plan; its ``scheme`` and ``cases`` are replaced.
        scheme: ``latin_hypercube``: each dimension evenly; ``sobol``: all of them together evenly (Sobol's sequence,
            scrambled); ``saltelli``: cases for :func:`sobol_indices`.
        cases: 1 to 100 000; of ``saltelli`` the base cases, each of which makes (dimensions + 2) cases, 100 000 in all.
        seed: of the random numbers, also those of the plan.

    Raises:
        InputError: the plan is wrong, varies nothing, or has too many cases; or ``saltelli`` and each mode's own
            deviation, to which indices cannot be traced.

    Source: Docs/FileFormats.md, "Sweep". Needs SciPy.
    """
    word("scheme", scheme, ("latin_hypercube", "sobol", "saltelli"))
    varied = plan.get("vary")
    _antinode.Sweep.parse(as_json({**plan, "scheme": "random", "cases": 1, "seed": seed}), True)
    if not varied:
        raise InputError("plan: varies nothing; allowed: one thing or more in 'vary'")
    blocks = len(varied) + 2 if scheme == "saltelli" else 1
    within("cases", cases, 1, 100_000 // blocks)
    columns: dict[str, list[Any]] = {}
    for entry, shares in zip(varied, _shares(scheme, cases, len(varied), seed).T):
        columns.update(_values(entry, shares))
    spread = [key for key in [*columns, *plan.get("set", ())] if key.startswith("deviation.") and "_spread_" in key]
    if scheme == "saltelli" and spread:
        raise InputError(f"plan: draws each mode's own '{spread[0]}'; allowed with saltelli: what all modes share")
    rows = list(zip(*columns.values())) if len(columns) > 1 else next(iter(columns.values()))
    listed = {"keys": list(columns), "values": rows}
    return {**{k: v for k, v in plan.items() if k != "cases"}, "scheme": "grid", "seed": seed, "vary": [listed]}


def sobol_indices(results: Floats, keys: Sequence[str], *, seed: int = 1) -> dict[str, Index]:
    """The share of the variance of a result that each key explains: alone, and together with others.

    Args:
        results: N_c: a result in the order of the cases of ``sampled (plan, "saltelli", ...)``. Base cases of which one
            is NaN are left out.
        keys: a name for each dimension of the plan, in its order.
        seed: of the bootstrap.

    Returns:
        For each key ``first`` and ``total``, each with ``value``, ``lower_95`` and ``upper_95``.

    Raises:
        InputError: the numbers do not fit, fewer than 8 base cases are whole, or the result does not vary.

    Source: A. Saltelli et al., Comput. Phys. Commun. 181, 259 (2010), table 2 (b) and (f).
    """
    import numpy as np

    width = len(keys) + 2
    if not keys or len(results) % width:
        raise InputError(f"results: {len(results)} cases; allowed with {len(keys)} keys: a multiple of {width}")
    bases = np.reshape(np.asarray(results, float), (-1, width))
    bases = bases[np.isfinite(bases).all(axis=1)]
    if len(bases) < 8 or np.ptp(bases) == 0:
        raise InputError("results: do not vary in 8 whole base cases; allowed: a result that does")
    bases = bases - bases[:, :2].mean()

    def indices(rows: Any) -> Any:
        first, second, mixed = bases[rows, 0, None], bases[rows, 1, None], bases[rows, 2:]
        variance = np.var(bases[rows, :2])
        return np.stack([(second * (mixed - first)).mean(0), 0.5 * ((first - mixed) ** 2).mean(0)]) / (variance or np.nan)

    resampled = np.random.default_rng(seed).integers(len(bases), size=(500, len(bases)))
    lower, upper = np.nanquantile([indices(rows) for rows in resampled], [0.025, 0.975], axis=0)
    best = indices(slice(None))
    return {
        key: {
            order: {"value": float(best[o, k]), "lower_95": float(lower[o, k]), "upper_95": float(upper[o, k])}
            for o, order in enumerate(("first", "total"))
        }
        for k, key in enumerate(keys)
    }


def _shares(scheme: str, cases: int, dimensions: int, seed: int) -> Any:
    """A row per case, a column per dimension: shares between 0 and 1."""
    import numpy as np
    from scipy.stats import qmc  # type: ignore[import]

    if scheme == "latin_hypercube":
        return qmc.LatinHypercube(dimensions, seed=seed).random(cases)
    matrices = 2 if scheme == "saltelli" else 1
    drawn = qmc.Sobol(matrices * dimensions, seed=seed).random_base2(math.ceil(math.log2(cases)))[:cases]
    drawn = np.clip(drawn, 2.0**-33, 1 - 2.0**-33)  # A quantile of 0 may be infinite.
    if scheme == "sobol":
        return drawn
    first, second = drawn[:, :dimensions], drawn[:, dimensions:]
    mixed = [np.where(np.arange(dimensions) == i, second, first) for i in range(dimensions)]
    return np.stack([first, second, *mixed], axis=1).reshape(-1, dimensions)


def _values(entry: Mapping[str, Any], shares: Any) -> dict[str, list[Any]]:
    """What each key of a dimension gets in each case."""
    import numpy as np
    from scipy.stats import truncnorm, uniform

    keys = entry.get("keys") or [entry["key"]]
    if "uniform" in entry or "normal" in entry:
        if "uniform" in entry:
            low, high = entry["uniform"]["minimum"], entry["uniform"]["maximum"]
            drawn = uniform.ppf(shares, low, high - low)
        else:
            normal = entry["normal"]
            mean, deviation = normal["mean"], normal["standard_deviation"]
            bounds = [
                (normal[bound] - mean) / (deviation or 1) if bound in normal else infinity
                for bound, infinity in (("minimum", -math.inf), ("maximum", math.inf))
            ]
            drawn = mean + deviation * truncnorm.ppf(shares, *bounds)
    else:
        rows = entry.get("values")
        if rows is None:
            spaced: Any = np.geomspace if entry.get("spacing") == "logarithmic" else np.linspace
            rows = spaced(entry["from"], entry["to"], entry["count"]).tolist()
        chosen = [rows[min(int(share * len(rows)), len(rows) - 1)] for share in shares]
        if "values" in entry:
            columns = zip(*chosen) if "keys" in entry and len(keys) > 1 else [chosen]
            return {key: list(column) for key, column in zip(keys, columns)}
        drawn = np.asarray(chosen)
    times, plus = entry.get("times", [1] * len(keys)), entry.get("plus", [0] * len(keys))
    return {key: (p + t * drawn).tolist() for key, t, p in zip(keys, times, plus)}
