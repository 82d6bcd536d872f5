"""Counts the blocks of files with readers that other people wrote in Python."""

import collections

AIR = {"minecraft:air", "minecraft:cave_air", "minecraft:void_air", "minecraft:structure_void"}


def by_name(states):
    """Counts by block name, without air, of (state or name, count) pairs."""
    counts = collections.Counter()
    for state, count in states:
        name = str(state).split("[")[0]
        counts[name if ":" in name else "minecraft:" + name] += count
    return {name: count for name, count in counts.items() if name not in AIR}


def litemapy(path):
    import litemapy

    return by_name(
        (region[x, y, z].id, 1)
        for region in litemapy.Schematic.load(path).regions.values()
        for x, y, z in region.block_positions()
    )


def litemapy_sponge(path):
    import litemapy
    import nbtlib

    region, _ = litemapy.Region.from_sponge_nbt(nbtlib.load(path))
    return by_name((region[cell].id, 1) for cell in region.block_positions())


def litemapy_structure(path):
    import litemapy
    import nbtlib

    region, _ = litemapy.Region.from_structure_nbt(nbtlib.load(path))
    return by_name((region[cell].id, 1) for cell in region.block_positions())


def mcschematic(path):
    import mcschematic as reader

    structure = reader.MCSchematic(path).getStructure()
    return by_name((state, 1) for _, state in structure.blockStateIterator())


READERS = {
    "litemapy": litemapy,
    "litemapy (sponge)": litemapy_sponge,
    "litemapy (structure)": litemapy_structure,
    "mcschematic": mcschematic,
}
