"""Reads what Mesa's compiler printed for Adreno chips (tools/adreno) and tabulates it, kernel by kernel.

A compiled shader is known by the BLAKE3 of its SPIR-V, which the compiler prints, so that variants with one entry point
are told apart. Columns, per chip:

  instr        machine instructions, with repeats and nops, as Mesa counts them
  nops         of which do nothing: the compiler found nothing to do while a result is awaited
  half         of which read or write a half register (`hr`), truths of comparisons too: Mesa's own count of half
               registers is 0 where full and half registers are one file
  full         full registers of a thread
  spills       loads and stores of private memory (ldp, stp)
  waves        at once on a core, of 16: registers alone, by Mesa's rule
  pair         instructions for a pair of particles, without nops: of the longest innermost loop, over the four
               neighbours or candidates that it takes at once; of the kernels that look at pairs
"""

import argparse
import csv
import json
import pathlib
import re
import sys

import blake3

# Of Mesa's freedreno_devices.py: registers of four components on a core, and what a wave is counted in.
REGISTERS = {"618": (48, 1), "630": (96, 2), "660": (64, 2), "730": (96, 2), "740": (96, 2), "750": (96, 2)}
MAX_WAVES = 16
WALKS_A_LIST = re.compile(r"(constrain_density|correct_positions|xsph|curl|confine_vorticity|list_neighbours|compute_density"
                          r"|accelerate|factor_pressure|correct_pressure|apply_pressure)")
LIST_CHUNK = 4
FIELDS = ["instr", "nops", "half", "full", "spills", "waves", "pair"]


def work_of(line):
    """Instructions of one line without nops: a repeated one counts as often as it is done."""
    if re.match(r"(\([a-z0-9]+\))*nop\b", line):
        return 0
    repeated = re.search(r"\(rpt(\d)\)", line)
    return 1 + (int(repeated.group(1)) if repeated else 0)


def longest_loop(code):
    """Work in the longest loop that holds no other: from a label to the last jump back to it."""
    labels, loops = {}, []
    for at, line in enumerate(code):
        if label := re.fullmatch(r"(l\d+):", line):
            labels[label.group(1)] = at
        elif (jump := re.search(r"#(l\d+)", line)) and jump.group(1) in labels:
            loops.append((labels[jump.group(1)], at))
    innermost = [loop for loop in loops if not any(loop[0] < other[0] and other[1] < loop[1] for other in loops)]
    return max((sum(map(work_of, code[start:end + 1])) for start, end in innermost), default=0)


def shader_of(text, name, chip):
    """What one dump says, or None where it was cut off."""
    code_from = text.find("Native code")
    numbers = re.search(r"prog \S+: (\d+) instr, (\d+) nops", text)
    full = re.search(r"(\d+) half, (\d+) full", text)
    if code_from < 0 or not numbers or not full:
        return None
    body = text[code_from:]
    code = [line.strip() for line in body.splitlines()[1:]]
    code = [line for line in code if line and line[0] not in ";@"]
    registers, granularity = REGISTERS[chip]
    threads = re.search(r"workgroup_size: (\d+), (\d+), (\d+)", text)
    size = 1
    for axis in threads.groups() if threads else ():
        size *= int(axis)
    is_compute = "MESA_SHADER_COMPUTE" in text or "MESA_SHADER_KERNEL" in text
    used = max(int(full.group(2)), 1)
    # Groups of 64 and vertex shaders run in waves of 64, all else in waves of 128.
    doubled = (size > 64 if is_compute else "MESA_SHADER_FRAGMENT" in text) and used * 2 <= registers
    waves = min(MAX_WAVES, registers // (used * (2 if doubled else 1)) * granularity)
    return {
        "instr": int(numbers.group(1)),
        "nops": int(numbers.group(2)),
        "half": sum(work_of(line) for line in code if re.search(r"\bhr\d", line)),
        "full": int(full.group(2)),
        "spills": sum(1 for line in code if re.search(r"\b(stp|ldp)\.", line)),
        "waves": waves,
        "pair": longest_loop(code) / LIST_CHUNK if WALKS_A_LIST.match(name) else "",
    }


def read_log(path, chip, names):
    """Name -> figures of all shaders in a log, and how many it could not name."""
    text = path.read_text(errors="replace").replace("MESA: info: ", "")
    found, unnamed = {}, 0
    for part in re.split(r"^(?=NIR \(final form\))", text, flags=re.M)[1:]:
        words = re.search(r"source_blake3: \{(.*?)\}", part)
        if not words:
            continue
        digest = b"".join(int(word, 16).to_bytes(4, "little") for word in words.group(1).split(", "))
        name = names.get(digest)
        figures = shader_of(part, name, chip) if name else None
        if figures:
            found[name] = figures
        else:
            unnamed += name is None
    return found, unnamed


def wanted_modules(manifest, tier):
    """Names of the modules that a device of that tier may run."""
    tiers = {"floor": ["floor"], "mobile": ["floor", "mobile"]}[tier]
    modules = json.loads(manifest.read_text())["modules"]
    return {pathlib.Path(module["spirv"]).stem for module in modules if module["tier"] in tiers}


def text_of(value):
    return f"{value:g}" if isinstance(value, float) else str(value)


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--spirv", type=pathlib.Path, action="append", required=True)
    parser.add_argument("--manifest", type=pathlib.Path, help="names those of --tier that no log has")
    parser.add_argument("--tier", choices=["floor", "mobile"], default="mobile")
    parser.add_argument("--before", type=pathlib.Path)
    parser.add_argument("--out", type=pathlib.Path, required=True)
    parser.add_argument("logs", nargs="+", metavar="CHIP=LOG")
    arguments = parser.parse_args()
    names = {}
    for folder in arguments.spirv:
        for file in sorted(folder.glob("*.spv")):
            names[blake3.blake3(file.read_bytes()).digest()] = file.stem
    before = {}
    if arguments.before:
        with arguments.before.open(newline="") as file:
            before = {(row["kernel"], row["chip"]): row for row in csv.DictReader(file)}
    rows = []
    for log in arguments.logs:
        chip, path = log.split("=", 1)
        found, unnamed = read_log(pathlib.Path(path), chip, names)
        if not found:
            sys.exit(f"adreno_table: error: {path}: no shader of ours was compiled; its end says why")
        print(f"Adreno {chip}: {len(found)} modules; {unnamed} shaders are not the program's own", file=sys.stderr)
        for name in sorted(found):
            row = {"kernel": name, "chip": chip, **found[name]}
            if earlier := before.get((name, chip)):
                row |= {"instr_before": earlier["instr"], "pair_before": earlier["pair"]}
            rows.append(row)
    if arguments.manifest:
        missing = wanted_modules(arguments.manifest, arguments.tier) - {row["kernel"] for row in rows}
        print(f"not built, as nothing that was run needs them: {len(missing)}: {' '.join(sorted(missing))}",
              file=sys.stderr)
    rows.sort(key=lambda row: (row["kernel"], row["chip"]))
    fields = ["kernel", "chip", *FIELDS] + (["instr_before", "pair_before"] if before else [])
    table = [[text_of(row.get(field, "")) for field in fields] for row in rows]
    with arguments.out.with_suffix(".csv").open("w", newline="") as file:
        csv.writer(file, lineterminator="\n").writerows([fields, *table])
    with arguments.out.with_suffix(".md").open("w") as file:
        for line in [fields, ["---"] * len(fields), *table]:
            file.write("| " + " | ".join(line) + " |\n")
    widths = [max(len(line[column]) for line in [fields, *table]) for column in range(len(fields))]
    for line in [fields, *table]:
        print("  ".join(cell.ljust(width) for cell, width in zip(line, widths)).rstrip())


if __name__ == "__main__":
    main()
