"""Time against the size of the scene and of the picture, from what the program bench-speed saved."""

from bench_error import plot

STYLES = {
    "lavaray, 4 rays a lane": ("#0072B2", "circle", "4 rays a lane"),
    "lavaray, 2 rays a lane": ("#56B4E9", "circle", "2 rays a lane"),
    "lavaray, 1 ray a lane": ("#E69F00", "wedge", "1 ray a lane"),
    "lavaray all arrays": ("#000000", "circle", "lavaray"),
    "embree robust": ("#D55E00", "square", "Embree, robust"),
    "embree default": ("#009E73", "triangle", "Embree, default"),
    "embree packets of 8": ("#CC79A7", "diamond", "Embree, packets"),
}
LABELS = {"embree default commit": "embree default"}


def curves(rows):
    """`rows`: (x, items, timings) in any order. The minimum processor nanoseconds per item, by contestant; of Embree,
    which traces the rays in each of the orders, in the best one."""
    least = {name: {} for name in STYLES}
    for x, items, timings in rows:
        for timing in timings:
            name = LABELS.get(timing["name"], timing["name"])
            if name in STYLES:
                least[name][x] = min(1e9 * min(timing["cpu"]) / items, least[name].get(x, float("inf")))
    return {name: sorted(points.items()) for name, points in least.items()}


def batches(scenes, name):
    """`scenes`: (x, scene)."""
    return curves([(x, b["rays"], b["timings"]) for x, s in scenes for b in s["batches"] if b["name"] == name])


def pictures(scenes):
    return curves([(x, s["picture"]["rays"], s["picture"]["timings"]) for x, s in scenes])


def scenes_svg(results):
    """Over the number of triangles or spheres."""
    balls = [(s["primitives"], s) for s in results["scenes"] if s["what"] == "bumpy ball"]
    spheres = [(s["primitives"], s) for s in results["scenes"] if s["spheres"]]
    panels = [(f"ns a {name} ray, triangles", batches(balls, name), None) for name in ("camera", "shadow", "mirror")]
    panels += [
        ("ns a ray of a picture, triangles", pictures(balls), None),
        ("ns a ray of a picture, spheres", pictures(spheres), None),
        ("ns a triangle built", curves([(x, x, s["builds"]) for x, s in balls]), None),
    ]
    width, height = results["size"]
    title = f"lavaray's rays, 4, 2 or 1 a lane, and Embree's, {width} x {height} pixels"
    return plot.svg(title, "triangles or spheres", panels, STYLES, "processor ns")


def sizes_svg(runs):
    """Over the size of the picture: of each run the first scene."""
    scenes = [(run["size"][0], run["scenes"][0]) for run in runs]
    panels = [(f"ns a {name} ray", batches(scenes, name), None) for name in ("camera", "shadow")]
    panels.append(("ns a ray of a picture", pictures(scenes), None))
    title = f"lavaray's rays, 4, 2 or 1 a lane, and Embree's, in square pictures of {runs[0]['scenes'][0]['name']}"
    return plot.svg(title, "pixels a side", panels, STYLES, "processor ns")
