"""Steps a block of water with SPlisHSPlasH and writes what each step took as JSON: with WCSPH and fixed steps, or with DFSPH
and steps by its CFL condition that are no longer than those given.

Needs the package pySPlisHSPlasH (2.19.0). Where it cannot be imported for want of a GL library, replace the wheel's own
libGLX, libGLdispatch, libOpenGL and libGLU by links to the system's.

    python step_splishsplash.py FOLDER wcsph SPACING_M DT_S END_S SPEED_OF_SOUND_M_S
    python step_splishsplash.py FOLDER dfsph SPACING_M DT_S END_S DENSITY_TOLERANCE
"""

import json
import sys
import time
from pathlib import Path

import pysplishsplash as sph

REST_DENSITY = 1000.0
EXPONENT = 7.0
BOX_M = (2.0, 1.0, 1.0)
BLOCK_M = (0.5, 0.5, 1.0)
# A cube with its faces outwards.
CORNERS = [(x, y, z) for z in (-0.5, 0.5) for y in (-0.5, 0.5) for x in (-0.5, 0.5)]
FACES = [(1, 3, 4), (1, 4, 2), (5, 6, 8), (5, 8, 7), (1, 2, 6), (1, 6, 5), (3, 7, 8), (3, 8, 4), (1, 5, 7), (1, 7, 3),
         (2, 4, 8), (2, 8, 6)]


def method(name: str, dt: float, number: float) -> dict:
    if name == "wcsph":
        # Of p = stiffness ((rho/rho0)^7 - 1): the square of the speed of sound is 7 stiffness / rho0.
        stiffness = number * number * REST_DENSITY / EXPONENT
        return {"simulationMethod": 0, "cflMethod": 0, "stiffness": stiffness, "exponent": EXPONENT}
    # Its tolerance is in percent, the divergence's as it is by default.
    return {"simulationMethod": 4, "cflMethod": 1, "cflMaxTimeStepSize": dt, "maxError": 100.0 * number}


def scene(folder: Path, spacing: float, dt: float, settings: dict) -> Path:
    obj = [f"v {x} {y} {z}" for x, y, z in CORNERS] + [f"f {a} {b} {c}" for a, b, c in FACES]
    (folder / "box.obj").write_text("\n".join(obj) + "\n")
    half = 0.5 * spacing
    configuration = {
        "particleRadius": half,
        **settings,
        "density0": REST_DENSITY,
        "gravitation": [0, -9.81, 0],
        "timeStepSize": dt,
        # Akinci et al. 2012: particles on the walls.
        "boundaryHandlingMethod": 0,
    }
    everything = {
        "Configuration": configuration,
        "Materials": [{"id": "Fluid", "viscosityMethod": 1, "viscosity": 0.01}],
        "RigidBodies": [{
            "geometryFile": "box.obj",
            "translation": [0.5 * side for side in BOX_M],
            "rotationAxis": [1, 0, 0],
            "rotationAngle": 0,
            # Wall particles stand a spacing from the fluid's.
            "scale": [side + spacing for side in BOX_M],
            "isDynamic": False,
            "isWall": True,
        }],
        # Its blocks begin a spacing behind their start and end as far before their end.
        "FluidBlocks": [{
            "denseMode": 0,
            "start": [-half] * 3,
            "end": [side + half + 1e-3 * spacing for side in BLOCK_M],
            "id": "Fluid",
        }],
    }
    path = folder / "scene.json"
    path.write_text(json.dumps(everything))
    return path


def main(folder: Path, name: str, spacing: float, dt: float, end: float, number: float) -> None:
    (folder / "out" / "log").mkdir(parents=True, exist_ok=True)
    base = sph.Exec.SimulatorBase()
    path = scene(folder, spacing, dt, method(name, dt, number))
    base.init(sceneFile=str(path), useGui=False, outputDir=str(folder / "out"), initialPause=False, useCache=False)
    base.initSimulation()
    ends = []
    base.setTimeStepCB(lambda: ends.append(time.perf_counter()))
    base.setValueFloat(base.STOP_AT, end - 0.5 * dt)
    base.runSimulation()
    fluid = sph.Simulation.getCurrent().getFluidModel(0)
    densities = [fluid.getDensity(i) for i in range(fluid.numActiveParticles())]
    told = {
        "particles": len(densities),
        "step_s": [later - earlier for earlier, later in zip(ends, ends[1:])],
        "density": [sum(densities) / len(densities), max(densities)],
    }
    base.cleanup()
    # Apart from what the program says itself.
    (folder / "told.json").write_text(json.dumps(told))


if __name__ == "__main__":
    main(Path(sys.argv[1]).resolve(), sys.argv[2], *(float(x) for x in sys.argv[3:]))
