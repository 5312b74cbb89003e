"""From measurements to the numbers in the tables: points, slopes, times at equal error, errors at equal time."""

import math
from dataclasses import dataclass
from statistics import median

from bench_error.experiment import ADAPTIVE, PEERS


@dataclass(frozen=True)
class Point:
    """All measurements of one contestant on one scene."""

    setting: float | str
    rmse: float  # root of the mean square over the seeds, as each is over the pixels
    relmse: float
    max: float
    flip: float | None
    cpu: float  # medians
    wall: float
    cpu_min: float
    wall_min: float
    rmses: tuple  # one per seed

    def time(self, clock):
        return self.cpu if clock == "cpu" else self.wall


def points(measurements, scene, method):
    """The curve of one method on one scene, the cheapest setting first. Which of POV-Ray's settings is cheaper depends
    on the scene, so those are ordered by their times."""
    groups = {}
    for m in measurements:
        if m.scene == scene and m.method == method:
            groups.setdefault(m.setting, []).append(m)
    curve = [make_point(setting, group) for setting, group in groups.items()]
    if method in PEERS:
        return sorted(curve, key=lambda p: p.cpu)
    return sorted(curve, key=lambda p: p.setting, reverse=method == ADAPTIVE)


def make_point(setting, group):
    count = len(group)
    return Point(
        setting=setting,
        rmse=math.sqrt(sum(m.rmse**2 for m in group) / count),
        relmse=sum(m.relmse for m in group) / count,
        max=max(m.max for m in group),
        flip=None if group[0].flip is None else sum(m.flip for m in group) / count,
        cpu=median(m.cpu for m in group),
        wall=median(m.wall for m in group),
        cpu_min=min(m.cpu for m in group),
        wall_min=min(m.wall for m in group),
        rmses=tuple(m.rmse for m in group),
    )


def slope(xs, ys):
    """Of the least-squares line through the logarithms; None if there is none."""
    pairs = [(math.log(x), math.log(y)) for x, y in zip(xs, ys) if x > 0 and y > 0]
    if len(pairs) < 2:
        return None
    mean_x = sum(x for x, _ in pairs) / len(pairs)
    mean_y = sum(y for _, y in pairs) / len(pairs)
    spread = sum((x - mean_x) ** 2 for x, _ in pairs)
    if spread < 1e-12:
        return None
    return sum((x - mean_x) * (y - mean_y) for x, y in pairs) / spread


def spp_slope(curve):
    """Without one sample per pixel, which lies at the pixel's centre and so is no member of the series."""
    used = [p for p in curve if p.setting > 1]
    return slope([p.setting for p in used], [p.rmse for p in used])


def time_slope(curve, clock):
    """Over all points. Start-up is not subtracted, so it flattens the cheap end."""
    return slope([p.time(clock) for p in curve], [p.rmse for p in curve])


@dataclass(frozen=True)
class Estimate:
    """How a value was found: "" measured or interpolated; "~" extrapolated; "<=" an upper bound, as every measurement
    is better than asked for; ">=" a fraction with such a bound below its line."""

    value: float
    mark: str = ""

    def __str__(self):
        return f"{self.mark}{self.value:.3g}"


def monotone(curve, clock):
    """(time, error) pairs with rising times and falling errors. If a costlier setting took less time, something else
    delayed the cheaper one, which gets the costlier one's time. A costlier setting that is no better is left out."""
    pairs = []
    min_time = math.inf
    for p in reversed(curve):
        min_time = min(min_time, p.time(clock))
        pairs.append((min_time, p.rmse))
    kept = []
    for time, error in reversed(pairs):
        if error <= 0 or (kept and error >= kept[-1][1]):
            continue
        if kept and kept[-1][0] == time:
            kept.pop()
        kept.append((time, error))
    return kept


def time_at_error(curve, error, clock):
    """Interpolated between logarithms, extrapolated along the last two points."""
    pairs = monotone(curve, clock)
    if pairs and pairs[0][1] <= error:
        return Estimate(pairs[0][0], "<=")
    return on_line([(1 / e, t) for t, e in pairs], 1 / error)


def time_of_peer(curves, error, clock):
    """The shortest of the curves' times at that error; None if none of them reaches it. Nothing is extrapolated: a
    curve's error may have stopped falling."""
    reaching = [by_time(curve, clock) for curve in curves if min_error(curve) <= error]
    times = [time for time in (time_at_error(curve, error, clock) for curve in reaching) if time]
    return min(times, key=lambda time: time.value, default=None)


def by_time(curve, clock):
    return sorted(curve, key=lambda p: p.time(clock))


def min_error(curve):
    return min((p.rmse for p in curve), default=math.inf)


def error_at_time(curve, time, clock):
    """None for a time too short for any image."""
    pairs = monotone(curve, clock)
    if pairs and pairs[0][0] > time:
        return None
    return on_line(pairs, time)


def on_line(pairs, wanted):
    """The value at the key `wanted` of these (key, value) pairs with rising keys: interpolated between logarithms, and
    beyond the last pair extrapolated along the last two. None if there are fewer than two."""
    if len(pairs) < 2:
        return None
    for (x1, y1), (x2, y2) in zip(pairs, pairs[1:]):
        if wanted <= x2:
            break
    part = math.log(wanted / x1) / math.log(x2 / x1)
    return Estimate(y1 * (y2 / y1) ** part, "~" if wanted > x2 else "")


def geometric_mean(values):
    values = [value for value in values if value is not None and value > 0]
    if not values:
        return None
    return math.exp(sum(math.log(value) for value in values) / len(values))


@dataclass(frozen=True)
class Honoured:
    runs: int
    kept: float  # share of the runs whose error is at most the target
    wasted: float  # share whose error is below a third of it
    worst: float  # largest error, as a multiple of the target


def honoured(rmses_by_target):
    """`rmses_by_target`: target -> true errors of its runs."""
    parts = [rmse / target for target, rmses in rmses_by_target.items() for rmse in rmses]
    if not parts:
        return None
    kept = sum(part <= 1 for part in parts) / len(parts)
    wasted = sum(part < 1 / 3 for part in parts) / len(parts)
    return Honoured(len(parts), kept, wasted, max(parts))
