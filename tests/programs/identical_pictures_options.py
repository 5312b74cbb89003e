"""The options of the programs, with the values at which identical_pictures.py compares two builds."""
# Where an option shows nothing by itself, others go with it.
SAMPLED = ("--spp", "4")
ADAPTIVE = ("--target-error", "0.02", "--max-spp", "32")
MIRRORS = ("--reflect", "0.5")
ONE, ALL = "{scene}", "{scenes}"
PAIR = ("a.pfm", "b.pfm")
PARTS = ("a.film", "b.film")
FOUND = "found.json"
WIDTH = "48"

# Of each option its values, each a list of arguments, or why it is left out. All scenes are rendered, to PFM files,
# which hold the most, unless the arguments name {scene} or another output.
LAVARAY = {
    "--help": [["--help"], ["--help", "--verbose"]],
    "--version": [["--version"], ["--version", "--quiet"]],
    "--output": [["--output", "{}" + ending] for ending in (".bmp", ".png", ".ppm", ".exr")]
                + [["--output", "{}.film", *SAMPLED], ["--output", "-", ONE]],
    "--width": [["--width", "33"], ["--width", "80"]],
    "--height": [["--height", "31"], ["--height", "50", "--width", "50"]],
    "--crop": [["--crop", "5,3,40,20"], ["--crop", "0,10,48,11", *SAMPLED]],
    "--normalize": [["--normalize"], ["--normalize", *SAMPLED]],
    "--spp": [["--spp", "2"], ["--spp", "17"]],
    "--filter": [["--filter", name, *SAMPLED] for name in ("box", "tent", "gaussian", "blackman-harris")],
    "--target-error": [["--target-error", "0.05", "--max-spp", "64"], ["--target-error", "0.02", "--max-spp", "64"]],
    "--max-spp": [["--max-spp", "2", "--target-error", "0.001"], ["--max-spp", "24", "--target-error", "0.001"]],
    "--time-limit": [["--time-limit", "1000", *SAMPLED], ["--time-limit", "1000", *ADAPTIVE]],
    "--sample-range": [["--sample-range", "0:4", "--spp", "10", "--output", "{}.film"],
                       ["--sample-range", "4:10", "--spp", "10", "--output", "{}.film"]],
    "--seed": [["--seed", "1", *SAMPLED], ["--seed", "4294967295", *ADAPTIVE]],
    "--sampler": [["--sampler", "sobol", *SAMPLED], ["--sampler", "random", *SAMPLED],
                  ["--sampler", "random", *ADAPTIVE]],
    "--view": [["--view", name] for name in ("color", "normal", "depth", "object", "shadow", "cost")]
              + [["--view", name, *SAMPLED] for name in ("normal", "depth", "shadow", "cost")]
              + [["--view", name, *ADAPTIVE] for name in ("samples", "error")],
    "--half": [["--half", "--output", "{}.exr"], ["--half", *SAMPLED, "--output", "{}.exr"]],
    "--layers": [["--layers", "normal,depth,object", "--output", "{}.exr"],
                 ["--layers", "samples,error", *ADAPTIVE, "--output", "{}.exr"]],
    "--max-depth": [["--max-depth", "0", *MIRRORS], ["--max-depth", "40", *MIRRORS]],
    "--reflect": [["--reflect", "0.3"], ["--reflect", "1"]],
    "--light-radius": [["--light-radius", "3"], ["--light-radius", "20", *SAMPLED]],
    "--checkpoint": [["--checkpoint", "kept.film", *SAMPLED, ONE], ["--checkpoint", "kept.film", *ADAPTIVE, ONE]],
    "--checkpoint-every": [["--checkpoint-every", value, "--checkpoint", "kept.film", *SAMPLED, ONE]
                           for value in ("0", "1000")],
    "--display": "a window; window_test.py compares what it shows with the file",
    "--watch": "never ends by itself; watch_test.py compares its pictures with those of a run of its own",
    "--shaders": "the shaders are those of a tree, and go with its build alone; watch_test.py and cli_test.sh",
    "--device": [["--device", "0"], ["--device", "llvmpipe"]],
    "--tuning": [["--tuning", way] for way in ("auto", "texels,1", "storage,4")],
    "--list-devices": [["--list-devices"], ["--list-devices", "--verbose"]],
    "--check": [["--check"], ["--check", "--json", "{}.json"]],
    "--stats": [["--stats"], ["--stats", *ADAPTIVE, *MIRRORS]],
    "--json": [["--json", "{}.json"], ["--json", "{}.json", *ADAPTIVE, *MIRRORS]],
    "--validate": [["--validate"], ["--validate", *SAMPLED]],
    "--quiet": [["--quiet"], ["--quiet", "--stats", *SAMPLED]],
    "--verbose": [["--verbose"], ["--verbose", *ADAPTIVE]],
    "--resume": [["--resume", "half.film", "--spp", "8", ONE], ["--resume", "half.film", "--spp", "8", *MIRRORS, ONE]],
}

DIFF = {
    "--help": [["--help"], ["--help", "--info"]],
    "--version": [["--version"], ["--version", "--info"]],
    "--tolerance": [["--tolerance", "1", *PAIR], ["--tolerance", "255", *PAIR]],
    "--max-differing": [["--max-differing", "10", *PAIR], ["--max-differing", "100000", *PAIR]],
    "--max-rmse": [["--max-rmse", "0.001", *PAIR], ["--max-rmse", "1", *PAIR]],
    "--max-flip": [["--max-flip", "0.001", *PAIR], ["--max-flip", "1", *PAIR]],
    "--output": [["--output", "{n}" + ending, *PAIR] for ending in (".png", ".pfm", ".bmp", ".exr")],
    "--report": [["--report", "{n}.html", *PAIR], ["--report", "{n}.html", PAIR[0], PAIR[0]]],
    "--json": [["--json", "{n}.json", *PAIR], ["--json", "{n}.json", "--max-flip", "1", *PAIR]],
    "--name": [["--name", name, "--json", "{n}.json", *PAIR] for name in ("<b>", "a pair")],
    "--driver": [["--driver", driver, "--report", "{n}.html", *PAIR] for driver in ("</script>", "a driver")],
    "--from": [["--from", FOUND], ["--from", FOUND, FOUND, "--report", "{n}.html"]],
    "--info": [["--info", name] for name in PAIR],
}

MERGE = {
    "--help": [["--help"], ["--help", "--check"]],
    "--version": [["--version"], ["--version", "--check"]],
    "--output": [["--output", "{n}" + ending, *PARTS] for ending in (".bmp", ".png", ".ppm", ".pfm", ".exr")],
    "--check": [["--check", *PARTS], ["--check", PARTS[0]]],
    "--crop": [["--crop", "3,4,40,20", "-o", "{n}.pfm", *PARTS], ["--crop", "0,0,48,1", "-o", "{n}.png", *PARTS]],
    "--normalize": [["--normalize", "-o", "{n}" + ending, *PARTS] for ending in (".pfm", ".png")],
    "--half": [["--half", "-o", "{n}.exr", *PARTS], ["--half", "--normalize", "-o", "{n}.exr", *PARTS]],
    "--quiet": [["--quiet", "-o", "{n}.pfm", *PARTS], ["--quiet", "--check", *PARTS]],
}

OPTIONS = {"lavaray": LAVARAY, "lavaray-diff": DIFF, "lavaray-merge": MERGE}


def arguments_of(name, values):
    """All arguments of a trial of lavaray's option `name`."""
    arguments = list(values)
    if name in ("--help", "--version", "--list-devices"):
        return arguments
    if not {"--quiet", "--verbose"} & set(values):
        arguments.append("-q")
    if name not in ("--width", "--height"):
        arguments += ["--width", WIDTH]
    if not {"--output", "--check"} & set(values):
        arguments += ["-o", "picture.pfm" if ONE in values else "{}.pfm"]
    return arguments if ONE in values else arguments + [ALL]


def half_rendered(values):
    """The command that leaves the checkpoint that --resume goes on from."""
    picture = [value for value in values[2:] if value != ONE]
    return ["lavaray", "-q", ONE, "--width", WIDTH, *picture, "--time-limit", "0", "--checkpoint", values[1],
            "-o", "half.pfm"]


def trials():
    """(name, commands): every scene as it is, each of lavaray's options at each value, then the other programs'."""
    yield "as they are", [["lavaray", "-q", ALL, "--width", "200", "-o", "{}.pfm"]]
    for name, values_of in LAVARAY.items():
        for values in values_of if isinstance(values_of, list) else []:
            command = ["lavaray", *arguments_of(name, values)]
            yield " ".join(values), [half_rendered(values), command] if name == "--resume" else [command]
    render = ["lavaray", "-q", ONE, "--width", WIDTH]
    pair = [[*render, "-o", PAIR[0]], [*render, "--spp", "8", "--filter", "tent", "-o", PAIR[1]]]
    parts = [[*render, "--spp", "9", "--sample-range", samples, "-o", part]
             for part, samples in zip(PARTS, ("0:4", "4:9"))]
    for program, inputs in (("lavaray-diff", [*pair, ["lavaray-diff", *PAIR, "--json", FOUND]]), ("lavaray-merge", parts)):
        yield program, inputs + [[program, *values] for values_of in OPTIONS[program].values() for values in values_of]
