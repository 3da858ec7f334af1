#!/usr/bin/env python3
"""Draws where the published propagation fades and where it grows, over alpha and gamma.

Runs the reference pack's GLSL for each pair, some minutes in all. Needs matplotlib
(python3-matplotlib)."""

import argparse
import subprocess

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402
from matplotlib.colors import TwoSlopeNorm  # noqa: E402


def measure(program):
    """{gamma: {alpha: gain of a step}}"""
    output = subprocess.run([program], check=True, text=True, stdout=subprocess.PIPE).stdout
    gains = {}
    for line in output.splitlines():
        gamma, alpha, gain = map(float, line.split(","))
        gains.setdefault(gamma, {})[alpha] = gain
    return gains


def draw(gains, path):
    gammas = sorted(gains)
    alphas = sorted(gains[gammas[0]])
    values = [[gains[gamma][alpha] for gamma in gammas] for alpha in alphas]
    figure, axes = plt.subplots(figsize=(6.4, 4.4), layout="constrained")
    mesh = axes.pcolormesh(gammas, alphas, values, shading="nearest", cmap="RdBu_r",
                           norm=TwoSlopeNorm(1, 0, 3.5))
    figure.colorbar(mesh, label="measured gain of a step in open air")
    theory = [gammas[0] + i * (gammas[-1] - gammas[0]) / 200 for i in range(201)]
    axes.plot(theory, [6 ** (1 - 1 / gamma) for gamma in theory], "k-", lw=2,
              label=r"theory: $\alpha_c = 6^{1 - 1/\gamma}$")
    axes.plot([2.2], [2.43902], "o", ms=8, mfc="white", mec="black", ls="none",
              label="published: 2.2, 2.43902")
    axes.set(xlabel=r"$\gamma$", ylabel=r"$\alpha$", title="blue fades, red grows without limit")
    axes.legend(loc="lower right")
    figure.savefig(path, dpi=100)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("program", help="the program stability_map")
    parser.add_argument("out", help="picture, .png or .svg")
    args = parser.parse_args()
    gains = measure(args.program)
    draw(gains, args.out)
    wrong = [(gamma, alpha) for gamma, row in gains.items() for alpha, gain in row.items()
             if (gain > 1) != (alpha > 6 ** (1 - 1 / gamma)) and abs(gain - 1) > 2e-3]
    worst = max(abs(gain / (alpha / 6 * 6 ** (1 / gamma)) - 1)
                for gamma, row in gains.items() for alpha, gain in row.items())
    print(f"{sum(len(row) for row in gains.values())} settings, {len(wrong)} on the wrong side of the "
          f"curve, largest difference from theory {100 * worst:.3f} %")


if __name__ == "__main__":
    main()
