# Copyright (c) 2026 The Pelage authors
# SPDX-License-Identifier: MIT
"""Tables and plots of what pelage-quality measured on one model."""
import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot

TITLES = {"lines": "lines of a pixel's width", "thin": "thin fibres"}
RAY_METHODS = [("occupancy 128/4", "density clusters 4", "deep shadow map 0.03"),
               ("deep opacity 4", "deep opacity 16", "deep opacity 32"), ("opacity 16", "opacity 128", "opacity 256")]
NANOSECONDS = [5, 10, 20, 40, 80]
COLOURS = [colour for name, step in (("tab20", 2), ("tab20b", 5), ("tab20c", 3))
           for colour in matplotlib.pyplot.get_cmap(name).colors[::step]]


def print_tables(model):
    """RMS / maximum errors, a row a method and a column a drawing and alpha; what visibility methods keep and take."""
    print("RMS / maximum error of visibility:\n")
    print_errors(model, "visibility", [("bytes_per_texel", "bytes a texel", 0), ("nanoseconds", "ns a fragment", 1)])
    print("RMS / maximum error of blending:\n")
    print_errors(model, "blending", [])
    print("| map of 512x512 | MiB |\n| --- | ---: |")
    for row in model["lines"]["visibility"][0]["methods"]:
        print(f"| {row['name']} | {row['bytes_per_texel'] / 4:.0f} |")
    print()


def print_errors(model, kind, columns):
    """columns: (key, head, decimals) that stand before the errors, from lines at alpha 0.15."""
    heads = [f"{TITLES[part]}, {one['alpha']:.2f}" for part in TITLES for one in model[part][kind]]
    print("| " + " | ".join(["method", *(head for _, head, _ in columns), *heads]) + " |")
    print("| --- |" + " ---: |" * (len(columns) + len(heads)))
    for i, middle in enumerate(model["lines"][kind][1]["methods"]):
        values = [f"{middle[key]:.{decimals}f}" for key, _, decimals in columns]
        for part in TITLES:
            for one in model[part][kind]:
                method = one["methods"][i]
                values.append(f"{method['rms']:.4f} / {method['maximum']:.3f}")
        print(f"| {middle['name']} | " + " | ".join(values) + " |")
    print()


def draw_ray(model, path):
    """Visibility along the ray that has most fragments, alpha 0.03."""
    ray = model["lines"]["visibility"][2]["ray"]
    figure, axes = matplotlib.pyplot.subplots(1, 3, figsize=(12, 3.6), sharey=True)
    dark = next((z for z, passed in zip(ray["depth"], ray["truth"]) if passed < 0.003), ray["depth"][-1])
    for axis, names in zip(axes, RAY_METHODS):
        axis.plot(ray["depth"], ray["truth"], color="black", linewidth=1.6, label="truth")
        for name in names:
            axis.plot(ray["depth"], ray["methods"][name], linewidth=1.1, label=name)
        axis.set_xlabel("depth")
        axis.set_xlim(ray["depth"][0], dark)
        axis.legend(fontsize=8)
    axes[0].set_ylabel("visibility")
    save(figure, path)


def draw_errors(model, path):
    """Error against memory and against time, and the blendings."""
    figure, axes = matplotlib.pyplot.subplots(1, 3, figsize=(15, 4.6))
    for colour, method in zip(COLOURS, model["lines"]["visibility"][1]["methods"]):
        axes[0].plot(method["bytes_per_texel"], method["rms"], "o", color=colour, label=method["name"])
        axes[1].plot(method["nanoseconds"], method["rms"], "o", color=colour, label=method["name"])
    axes[0].set(xlabel="bytes a texel", ylabel="RMS error of visibility, lines, alpha 0.15")
    axes[1].set(xlabel="ns to put a fragment in and look one up")
    for axis in axes[:2]:
        axis.set(xscale="log", yscale="log")
    axes[1].set_xticks(NANOSECONDS, labels=map(str, NANOSECONDS))
    axes[1].minorticks_off()
    axes[0].legend(fontsize=7, loc="lower right")
    for colour, method in zip(COLOURS, zip(*(one["methods"] for one in model["lines"]["blending"]))):
        alphas = [one["alpha"] for one in model["lines"]["blending"]]
        axes[2].plot(alphas, [m["rms"] for m in method], "o-", color=colour, linewidth=1, label=method[0]["name"])
    axes[2].set(yscale="log", xlabel="alpha", ylabel="RMS error of colour, lines")
    axes[2].legend(fontsize=7, loc="upper left", bbox_to_anchor=(1, 1))
    save(figure, path)


def save(figure, path):
    figure.tight_layout(pad=0.5, w_pad=1.5)
    figure.savefig(path, dpi=110)
    matplotlib.pyplot.close(figure)
