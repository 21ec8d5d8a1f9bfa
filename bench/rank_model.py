#!/usr/bin/env python3
"""What steps on 1 to 100 000 ranks take by the traffic model of docs/cluster.md: on paper, not measured.

  bench/rank_model.py [--element-ns NS] [--certificate SHARE] [--latency-us US] [--bandwidth-GBs GB]

A body of tetrahedra in cubes (6 a cube, 1 node a cube), cut into cubes of equal size. A step of a rank takes
  (own elements + elements computed twice) * element time * (1 + certificate share)
  + messages to up to 26 neighbours, which go out at once: latency + 24 bytes a ghost / bandwidth
  + one maximum over all ranks: 2 log2(ranks) latencies, of which the accelerations (a tenth of the step) hide a part.
Elements computed twice: a layer of cubes around the part, as far as there are neighbours.
"""
import argparse
import math

RANKS = (1, 8, 64, 512, 4096, 32768, 100000)


def step(ranks, own, args):
    """Seconds of a step, and the share of elements computed twice; own: elements of a rank."""
    side = (own / 6) ** (1 / 3)
    faces = 3 * min(2, round(ranks ** (1 / 3)) - 1)  # with a neighbour, of the part that has most
    ghosts = faces * side * side
    # A border layer lies half on either side: a cube of elements for each ghost.
    twice = 6 * ghosts * 0.5
    work = (own + twice) * args.element_ns * 1e-9 * (1 + args.certificate)
    neighbours = 0 if ranks == 1 else args.latency_us * 1e-6 + 24 * ghosts / (args.bandwidth_GBs * 1e9)
    maximum = 0 if ranks == 1 else max(0.0, 2 * math.log2(ranks) * args.latency_us * 1e-6 - 0.1 * work)
    return work + neighbours + maximum, twice / own


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--element-ns", type=float, default=8, help="a tetrahedron's share of a step, one core, ns")
    parser.add_argument("--certificate", type=float, default=0.35, help="of a step's work, on top")
    parser.add_argument("--latency-us", type=float, default=2)
    parser.add_argument("--bandwidth-GBs", type=float, default=5, help="of a rank")
    args = parser.parse_args()
    print("| ranks | weak, 1e5 tetrahedra a rank: ms a step | efficiency | strong, 5e7 tetrahedra: ms a step | speed-up | efficiency |")
    print("|---|---|---|---|---|---|")
    one, whole = step(1, 1e5, args)[0], step(1, 5e7, args)[0]
    for ranks in RANKS:
        weak, strong = step(ranks, 1e5, args)[0], step(ranks, 5e7 / ranks, args)[0]
        print(f"| {ranks} | {1e3 * weak:.2f} | {one / weak:.0%} | {1e3 * strong:.3g} | {whole / strong:.3g} | "
              f"{whole / strong / ranks:.0%} |")


if __name__ == "__main__":
    main()
