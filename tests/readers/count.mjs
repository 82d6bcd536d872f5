// Counts the blocks of files with other people's readers. Each line of standard input names a reader and a file; each
// line of output is what it counts, as JSON: {"reader", "file", "blocks": {name: count}} or {"reader", "file", "error"}.
import { readFileSync } from 'node:fs'
import { createInterface } from 'node:readline'

const AIR = new Set(['minecraft:air', 'minecraft:cave_air', 'minecraft:void_air', 'minecraft:structure_void'])

async function nucleation (bytes) {
  const { Schematic } = await import('nucleation')
  const schematic = Schematic.fromData(bytes)
  const counts = {}
  for (const [state, count] of Object.entries(JSON.parse(schematic.countBlocksJson()))) add(counts, state, count)
  return counts
}

async function deepslate (bytes) {
  const { NbtFile, Structure } = await import('deepslate')
  const structure = Structure.fromNbt(NbtFile.read(bytes).root)
  const counts = {}
  for (const block of structure.getBlocks()) add(counts, block.state.getName().toString(), 1)
  return counts
}

async function prismarine (bytes) {
  const { Schematic } = (await import('prismarine-schematic')).default
  const schematic = await Schematic.read(bytes)
  const tally = new Array(schematic.palette.length).fill(0)
  for (const index of schematic.blocks) tally[index]++
  const counts = {}
  tally.forEach((count, index) => {
    const block = schematic.Block.fromStateId(schematic.palette[index])
    if (count > 0) add(counts, `minecraft:${block.name}`, count)
  })
  return counts
}

const READERS = { nucleation, deepslate, prismarine }

function add (counts, state, count) {
  const name = state.split('[')[0]
  if (!AIR.has(name)) counts[name] = (counts[name] ?? 0) + count
}

// Readers print what they do not know; only our lines belong on standard output.
console.log = console.error

for await (const line of createInterface({ input: process.stdin })) {
  const [reader, file] = line.split('\t')
  let found
  try {
    found = { blocks: await READERS[reader](readFileSync(file)) }
  } catch (error) {
    found = { error: String(error?.message ?? error).slice(0, 200) }
  }
  process.stdout.write(JSON.stringify({ reader, file, ...found }) + '\n')
}
