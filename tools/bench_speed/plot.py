"""Time against the number of triangles or spheres, from what the program bench-speed saved."""

from bench_error import plot

STYLES = {
    "lavaray": ("#0072B2", "circle", "lavaray"),
    "embree robust": ("#D55E00", "square", "Embree, robust"),
    "embree default": ("#009E73", "triangle", "Embree, default"),
    "embree packets of 8": ("#CC79A7", "diamond", "Embree, packets of 8"),
}
BUILDS = {"lavaray all arrays": "lavaray", "embree default commit": "embree default"}


def curves(rows):
    """`rows`: (x, items, timings) in any order. The minimum processor nanoseconds per item, by contestant."""
    result = {name: [] for name in STYLES}
    for x, items, timings in sorted(rows, key=lambda row: row[0]):
        for timing in timings:
            name = BUILDS.get(timing["name"], timing["name"])
            if name in STYLES:
                result[name].append((x, 1e9 * min(timing["cpu"]) / items))
    return result


def svg(results):
    balls = [s for s in results["scenes"] if s["what"] == "bumpy ball"]
    spheres = [s for s in results["scenes"] if s["spheres"]]

    def batch(scenes, name):
        return curves([(s["primitives"], b["rays"], b["timings"]) for s in scenes for b in s["batches"]
                       if b["name"] == name])

    panels = [(f"ns a {name} ray, triangles", batch(balls, name), None) for name in ("camera", "shadow", "mirror")]
    panels += [
        ("ns a ray of a picture, triangles",
         curves([(s["primitives"], s["picture"]["rays"], s["picture"]["timings"]) for s in balls]), None),
        ("ns a camera ray, spheres", batch(spheres, "camera"), None),
        ("ns a triangle built", curves([(s["primitives"], s["primitives"], s["builds"]) for s in balls]), None),
    ]
    width, height = results["size"]
    title = f"Processor time against the number of triangles or spheres, {width} x {height} pixels"
    return plot.svg(title, "triangles or spheres", panels, STYLES, "processor ns")
