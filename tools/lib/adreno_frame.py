"""Estimates frame times of the deck's phone scenes on Adrenos out of the table of tools/adreno. An estimate: nothing of
it ran on an Adreno. Assumptions stand here, each once; mobile/PRECISION.md says what they are worth.

    python3 tools/lib/adreno_frame.py target/adreno/mobile.csv
"""

import csv
import sys

# Peak f32 rate (GFLOPS, a multiply-add being two) and memory bandwidth (GB/s) as public tables have them; the chip
# whose instructions stand for it.
CHIPS = {"540": (567, 29.8, "618"), "640": (899, 34.1, "660"), "740": (2089, 67.2, "740")}
CHUNKS = 9              # of four neighbours a particle: 33 within h = 2 d, and what does not fill the last
CANDIDATE_CHUNKS = 32   # of four candidates: 125 cells of h/2 with a particle each
CELLS_A_PARTICLE = 5    # of the grid, as `brooklet plan` has them for these scenes
SCAN_ITEMS = 16
PIXELS = 1920 * 1080
WET = 0.25              # of the picture, and of the blocks of 80 x 40 x 40 cells
FRAGMENT_EFFICIENCY = 0.5
BYTES_A_PIXEL = 60      # written and read again, all passes together

WALLS = "constrain_density+walls+"
STEP = {  # module: runs a frame
    "predict+walls": 1, "count_cells": 1, "reorder+velocities_only": 1, "reorder+relaxed_precision+positions_only": 1,
    "list_neighbours+relaxed_precision": 1,
    WALLS + "restricted_momentum+relaxed_precision": 1, "prolong_multiplier+relaxed_precision": 1,
    "correct_positions+walls+relaxed_precision": 2, WALLS + "accumulated_momentum+relaxed_precision": 1,
    "update_velocity+relaxed_precision+in_place_velocity": 1, "xsph+relaxed_precision": 1, "measure_particles+density+walls": 1,
}
SCANS = ["reduce_groups", "scan_groups+group_offsets"]
# Of a mesh: module, threads a cell of the wet blocks.
MESH = {"gather_field": 1 / 8, "count_mesh": 1, "emit_vertices": 1, "mesh_normals": 1 / 8, "emit_triangles": 1,
        "smooth_normals": 4 / 8, "sort_rings": 1 / 8}
FIELD_LOOPS = 8         # a thread of gather_field does its code so often: particles in reach of eight points
# Share of the picture.
PICTURE = {"draw_mesh_depth.fragment": WET, "draw_water.fragment+mesh_normals": WET,
           "draw_floor.fragment+water_shadow": 0.6, "draw_sky.fragment": 0.4, "draw_opaque_planes.fragment": 0.25,
           "draw_resolve.fragment+water": 1.0}
CELLS = 80 * 40 * 40

# The deck's own figure on the 540: 5,000 particles, 2 iterations, 40 frames/s. Its loop (27 cells, no list): what it
# looks at a walk, the walks of a frame, and instructions a candidate as its listing has them.
DECK_PARTICLES, DECK_SECONDS = 5000, 1 / 40
DECK_CANDIDATES, DECK_WALKS, DECK_INSTRUCTIONS = 27 * 8, 2 * 2 + 2, 15


def work(row, loops):
    """Instructions that a thread executes: its loop over pairs so often, all else once."""
    straight = int(row["instr"]) - int(row["nops"])
    chunk = 4 * float(row["pair"] or 0)
    return straight + chunk * (loops - 1)


def step_instructions(table, chip, particles):
    total = 0.0
    for name, runs in STEP.items():
        loops = CANDIDATE_CHUNKS if name.startswith("list") else CHUNKS
        if name.startswith("measure"):  # walks the list once more, about as a kernel of its own does
            total += CHUNKS * 4 * 25
        total += runs * work(table[name, chip], loops)
    scans = sum(work(table[name, chip], 1) for name in SCANS)
    return particles * (total + scans * CELLS_A_PARTICLE / SCAN_ITEMS)


def mesh_instructions(table, chip, particles):
    cells = CELLS * WET
    total = sum(share * cells * work(table[name, chip], 1) * (FIELD_LOOPS if name == "gather_field" else 1)
                for name, share in MESH.items())
    return total + particles * (work(table["anisotropy", chip], 1) + CHUNKS * 4 * 11)


def picture_instructions(table, chip):
    return PIXELS * sum(share * work(table[name, chip], 1) for name, share in PICTURE.items())


def step_bytes(particles):
    walks = sum(runs for name, runs in STEP.items() if not name.startswith(("predict", "count", "reorder", "update")))
    return particles * (walks * (CHUNKS * 8 + 40) + 9 * 32 + CELLS_A_PARTICLE * 16)


def main():
    with open(sys.argv[1], newline="") as file:
        table = {(row["kernel"], row["chip"]): row for row in csv.DictReader(file)}
    frame = [*STEP, *SCANS, *MESH, *PICTURE, "anisotropy"]
    missing = sorted({name for name in frame for _, _, chip in CHIPS.values() if (name, chip) not in table})
    if missing:
        sys.exit(f"adreno_frame: error: {sys.argv[1]} has not, for every chip: {', '.join(missing)}; the program's kernels "
                 "are others (`brooklet plan phone-5k --tier mobile --set solver.precision=relaxed`), or tools/adreno ran "
                 "for fewer chips or with --scene")
    rate_540 = CHIPS["540"][0] * 1e9 / 2
    deck = DECK_PARTICLES * DECK_CANDIDATES * DECK_WALKS * DECK_INSTRUCTIONS
    efficiency = deck / rate_540 / DECK_SECONDS
    print(f"the deck's frame at the peak rate: {deck / rate_540 * 1e3:.2f} ms of its {DECK_SECONDS * 1e3:.0f} ms: "
          f"an efficiency of {efficiency:.1%}\n")
    print("| Adreno | particles | instructions a particle | step at peak, ms | step, calibrated, ms | frames/s |"
          " with mesh and picture, ms | frames/s |")
    print("|---|---|---|---|---|---|---|---|")
    for chip, (gflops, bandwidth, proxy) in CHIPS.items():
        rate = gflops * 1e9 / 2
        for particles in (1000, 5000):
            step = step_instructions(table, proxy, particles)
            peak = max(step / rate, step_bytes(particles) / bandwidth / 1e9) * 1e3
            calibrated = step / rate / efficiency * 1e3
            mesh = mesh_instructions(table, proxy, particles) / rate / efficiency * 1e3
            picture = max(picture_instructions(table, proxy) / rate / FRAGMENT_EFFICIENCY,
                          PIXELS * BYTES_A_PIXEL / bandwidth / 1e9) * 1e3
            whole = calibrated + mesh + picture
            print(f"| {chip} | {particles:,} | {step / particles:,.0f} | {peak:.2f} | {calibrated:.1f} | "
                  f"{1e3 / calibrated:.0f} | {whole:.1f} | {1e3 / whole:.0f} |")


if __name__ == "__main__":
    main()
