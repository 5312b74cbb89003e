"""The tables, as text."""

from bench_error import analysis
from bench_error.experiment import ADAPTIVE, FIXED, PEERS, label


def table(title, header, rows):
    """Columns no wider than needed, the first aligned left, numbers right."""
    cells = [list(header)] + [["-" if c is None else str(c) for c in row] for row in rows]
    widths = [max(len(row[i]) for row in cells) for i in range(len(header))]
    lines = [title, ""]
    for number, row in enumerate(cells):
        words = [row[0].ljust(widths[0])] + [c.rjust(w) for c, w in zip(row[1:], widths[1:])]
        lines.append("  " + "  ".join(words).rstrip())
        if number == 0:
            lines.append("  " + "  ".join("-" * w for w in widths))
    return "\n".join(lines) + "\n"


def number(value, digits=3):
    return None if value is None else f"{value:.{digits}g}"


def percent(value):
    return f"{100 * value:.0f}%"


class Report:
    def __init__(self, scenes, measurements, references, targets, clock, peers):
        self.scenes = scenes
        self.compared = [scene.name for scene in scenes if not (scene.slopes_only or scene.variant)]
        self.peers = peers
        self.rivalled = [s.name for s in scenes if s.name in peers.files and not s.slopes_only]
        self.references = references
        self.targets = targets
        self.clock = clock
        self.curves = {
            (scene.name, method): analysis.points(measurements, scene.name, method)
            for scene in scenes
            for method in (*FIXED, ADAPTIVE, *PEERS)
        }

    def text(self):
        parts = [self.scene_table(), *(self.error_table(s.name) for s in self.scenes), self.slope_table()]
        if self.targets:
            parts += [self.equal_error_table(), self.equal_time_table(), self.honoured_table()]
        if self.peers.files or self.peers.left_out:
            parts.append(self.peer_table())
        if self.targets and self.rivalled:
            parts.append(self.rival_table())
        return "\n".join(parts)

    def startup(self, scene):
        """The run with one sample per pixel: mostly start-up, reading the scene and building the tree."""
        return next((p for p in self.curves[scene, "sobol"] if p.setting == 1), None)

    def scene_table(self):
        rows = []
        for scene in self.scenes:
            start = self.startup(scene.name)
            found = self.references[scene.name]
            rows.append((scene.name, scene.hard, found.samples, number(found.rmse),
                         number(start.cpu) if start else None, number(start.wall) if start else None))
        header = ("scene", "what is hard", "reference spp", "its error", "cpu s at 1 spp", "wall s")
        return table("Scenes; the error of a reference is half the RMSE between its two halves", header, rows)

    def error_table(self, scene):
        rows = []
        floor = 4 * self.references[scene].rmse
        for method in (*FIXED, ADAPTIVE, *PEERS):
            for p in self.curves[scene, method]:
                name = label(method, p.setting)
                rows.append((name, number(p.rmse) + ("?" if p.rmse < floor else ""), number(p.relmse),
                             number(p.max), number(p.flip), number(p.cpu_min), number(p.cpu), number(p.wall_min),
                             number(p.wall)))
        header = ("method", "RMSE", "relMSE", "max", "FLIP", "cpu min", "median", "wall min", "median s")
        return table(f"{scene}: error and time (?: less than 4 times the reference's own error)", header, rows)

    def slope_table(self):
        header = ["scene"]
        for method in FIXED:
            header += [f"{method}: spp", "time"]
        header += ["adaptive: time", "sobol RMSE at 16 spp"]
        rows = []
        for scene in self.scenes:
            row = [scene.name]
            for method in FIXED:
                curve = self.curves[scene.name, method]
                row += [analysis.spp_slope(curve), analysis.time_slope(curve, self.clock)]
            row.append(analysis.time_slope(self.curves[scene.name, ADAPTIVE], self.clock))
            row = row[:1] + [None if x is None else f"{x:.2f}" for x in row[1:]]
            at16 = next((p for p in self.curves[scene.name, "sobol"] if p.setting == 16), None)
            rows.append(row + [number(at16.rmse) if at16 else None])
        return table(f"Slopes of log RMSE against log spp (from 4 spp) and log {self.clock} time", header, rows)

    def adaptive_points(self, target):
        """(scene, adaptive run at that target) for the compared scenes."""
        return [(name, p) for name in self.compared for p in self.curves[name, ADAPTIVE] if p.setting == target]

    def fixed_time(self, scene, method, rmse):
        return analysis.time_at_error(self.curves[scene, method], rmse, self.clock)

    def ratios(self, target):
        """The time of adaptive over that of each fixed sampler at the same true RMSE, one per compared scene."""
        found = [record["of"] for record in self.equal_errors() if record["target"] == target]
        return {method: [of[method] for of in found if of[method]] for method in FIXED}

    def equal_error_table(self):
        rows = []
        every = {method: [] for method in FIXED}
        for target in self.targets:
            for scene, p in self.adaptive_points(target):
                time = p.time(self.clock)
                fixed = [self.fixed_time(scene, method, p.rmse) for method in ("sobol", "random")]
                ratios = [number(time / f.value) if f else None for f in fixed]
                rows.append((f"{target:g} {scene}", number(p.rmse), number(time), *fixed, *ratios))
            ratios = self.ratios(target)
            for method in FIXED:
                every[method] += ratios[method]
            rows.append((f"{target:g} geometric mean", "", "", "", "", *self.mean_ratios(ratios)))
        rows.append(("all geometric mean", "", "", "", "", *self.mean_ratios(every)))
        header = ("E and scene", "true RMSE", "adaptive s", "sobol s", "random s", "adaptive/sobol", "adaptive/random")
        title = (f"Equal error: {self.clock} seconds, start-up included, to the true RMSE that adaptive reached for E\n"
                 "(fixed: interpolated; ~: extrapolated; <=: the fastest run is better already)")
        return table(title, header, rows)

    @staticmethod
    def mean_ratios(ratios):
        return [number(analysis.geometric_mean(ratios[method])) for method in ("sobol", "random")]

    def equal_time_table(self):
        rows = []
        for target in self.targets:
            for scene, p in self.adaptive_points(target):
                time = p.time(self.clock)
                fixed = [analysis.error_at_time(self.curves[scene, m], time, self.clock) for m in ("random", "sobol")]
                rows.append((f"{target:g} {scene}", number(time), *fixed, number(p.rmse)))
        header = ("E and scene", f"{self.clock} s", "random RMSE", "sobol RMSE", "adaptive RMSE")
        return table("Equal time: true RMSE after the time that adaptive took for E (~: extrapolated)", header, rows)

    def honoured_table(self):
        runs = {(s, p.setting): p.rmses for s in self.compared for p in self.curves[s, ADAPTIVE]}
        rows = []

        def add(name, chosen):
            result = analysis.honoured(chosen)
            if result:
                rows.append((name, result.runs, percent(result.kept), percent(result.wasted),
                             f"{result.worst:.2f} E"))

        for scene in self.compared:
            add(scene, {t: rmses for (s, t), rmses in runs.items() if s == scene})
        for target in self.targets:
            rmses = [rmse for (_, t), all_of in runs.items() if t == target for rmse in all_of]
            add(f"E = {target:g}", {target: rmses})
        add("all", self.rmses_by_target())
        header = ("runs", "number", "<= E", "< E/3", "largest RMSE")
        return table("Target honoured: true RMSE of runs with --target-error E", header, rows)

    def peer_table(self):
        """Which scenes POV-Ray takes part in, how much its pictures differ, and what keeps it from the others."""
        rows = []
        for name, difference in self.peers.differences.items():
            min_errors = [analysis.min_error(self.curves[name, method]) for method in PEERS]
            rows.append((name, number(difference), *map(number, min_errors), ""))
        rows += [(name, None, None, None, reason) for name, reason in self.peers.left_out.items()]
        header = ("scene", "differs by", *(f"least {option}" for option in PEERS.values()), "no peer, because of")
        return table("POV-Ray: RMSE between its image and lavaray's with one ray a pixel, and the least RMSE that its\n"
                     "methods reached", header, rows)

    def rival_points(self, target):
        """(scene, adaptive run, POV-Ray's times by each method, its best time) at equal error; None for a time if
        POV-Ray does not reach that error."""
        result = []
        for name in self.rivalled:
            curves = {method: self.curves[name, method] for method in PEERS}
            for p in self.curves[name, ADAPTIVE]:
                if p.setting == target:
                    times = [analysis.time_of_peer([c], p.rmse, self.clock) for c in curves.values()]
                    best = analysis.time_of_peer(curves.values(), p.rmse, self.clock)
                    result.append((name, p, times, best))
        return result

    def rival_ratios(self, target):
        return [p.time(self.clock) / best.value for _, p, _, best in self.rival_points(target) if best]

    def rival_table(self):
        rows = []
        every, asked = [], 0
        for target in self.targets:
            found = self.rival_points(target)
            for name, p, times, best in found:
                ratio = analysis.Estimate(p.time(self.clock) / best.value, ">=" if best.mark else "") if best else None
                rows.append((f"{target:g} {name}", number(p.rmse), number(p.time(self.clock)),
                             *(time or "not reached" for time in times), ratio))
            ratios = self.rival_ratios(target)
            rows.append(self.rival_mean(f"{target:g}", ratios, len(found)))
            every += ratios
            asked += len(found)
        rows.append(self.rival_mean("all", every, asked))
        header = ("E and scene", "true RMSE", "adaptive s", *(f"{option} s" for option in PEERS.values()),
                  "adaptive/best")
        title = (f"Equal error against POV-Ray: {self.clock} seconds, start-up included, to the true RMSE that\n"
                 "adaptive reached for E (interpolated; <=: POV-Ray's fastest run is better already, so that the\n"
                 "ratio is a bound; not reached: none of its settings comes so far, and the mean is without them)")
        return table(title, header, rows)

    @staticmethod
    def rival_mean(name, ratios, asked):
        return (f"{name} geometric mean, {len(ratios)} of {asked}", "", "", "", "",
                number(analysis.geometric_mean(ratios)))

    def equal_errors(self):
        """For each target and compared scene: the true RMSE, the time of adaptive, and that in parts of the others'
        times at that error. None where it is unknown or not reached; POV-Ray's only where it takes part, if in a
        variant of the scene."""
        records = []
        for target in self.targets:
            rival = {name.removesuffix("-peer"): p.time(self.clock) / best.value if best else None
                     for name, p, _, best in self.rival_points(target)}
            for name, p in self.adaptive_points(target):
                fixed = {method: self.fixed_time(name, method, p.rmse) for method in FIXED}
                parts = {m: p.time(self.clock) / found.value if found else None for m, found in fixed.items()}
                if name in rival:
                    parts["povray"] = rival[name]
                records.append({"target": target, "scene": name, "rmse": p.rmse, "seconds": p.time(self.clock),
                                "of": parts})
        return records

    def rmses_by_target(self):
        return {t: [r for s in self.compared for p in self.curves[s, ADAPTIVE] if p.setting == t for r in p.rmses]
                for t in self.targets}

    def summary(self):
        """The figures of the tables, for the JSON file."""
        slopes = {}
        for scene in self.scenes:
            for method in FIXED:
                curve = self.curves[scene.name, method]
                slopes[f"{scene.name} {method}"] = {
                    "spp": analysis.spp_slope(curve),
                    "time": analysis.time_slope(curve, self.clock),
                }
        ratios = {}
        for target in self.targets:
            found = self.ratios(target)
            ratios[f"{target:g}"] = {method: analysis.geometric_mean(found[method]) for method in FIXED}
        every = {m: [r for t in self.targets for r in self.ratios(t)[m]] for m in FIXED}
        ratios["all"] = {method: analysis.geometric_mean(every[method]) for method in FIXED}
        rival = {f"{t:g}": self.rival_ratios(t) for t in self.targets}
        rival["all"] = [ratio for found in list(rival.values()) for ratio in found]
        kept = analysis.honoured(self.rmses_by_target())
        return {
            "slopes": slopes,
            "equal_errors": self.equal_errors(),
            "time_of_adaptive_over": ratios,
            "time_of_adaptive_over_povray": {t: analysis.geometric_mean(found) for t, found in rival.items()},
            "povray_differs_by": self.peers.differences,
            "povray_left_out": self.peers.left_out,
            "target_honoured": vars(kept) if kept else None,
            "startup_seconds": {s.name: p.time(self.clock) for s in self.scenes if (p := self.startup(s.name))},
        }
