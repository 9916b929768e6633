// Where the steps of a graph lie: layered from left to right by depth, in the order within a layer that crosses few
// wires, and each as near to the height of what it reads as its layer has room for.

export interface LayoutNode {
  id: string;
  width: number;
  height: number;
}

/** `from` is read by `to`. */
export interface LayoutWire {
  from: string;
  to: string;
}

export interface LayoutOptions {
  columnGap: number;
  rowGap: number;
}

export interface Placed {
  x: number;
  y: number;
  layer: number;
}

/** Where a wire crosses a layer in which neither of its ends lies. */
export interface Crossing {
  left: number;
  right: number;
  y: number;
}

export interface Layout {
  places: ReadonlyMap<string, Placed>;
  /** By wireName(): what a long wire passes on its way. */
  crossings: ReadonlyMap<string, readonly Crossing[]>;
  width: number;
  height: number;
}

export function wireName({ from, to }: LayoutWire): string {
  return `${from}>${to}`;
}

const LANE = 14;

interface Work {
  nodes: Map<string, LayoutNode>;
  before: Map<string, string[]>;
  after: Map<string, string[]>;
  layers: string[][];
  /** Of long wires: the places that are kept free for them, layer by layer. */
  lanes: Map<string, string[]>;
}

/** Longest way from a node that reads nothing; in a cycle, which a recipe has not, the way ends where it closes. */
function depths(nodes: readonly LayoutNode[], before: ReadonlyMap<string, string[]>): Map<string, number> {
  const found = new Map<string, number>();
  const onWay = new Set<string>();
  const depth = (id: string): number => {
    const known = found.get(id);
    if (known !== undefined) return known;
    if (onWay.has(id)) return -1;
    onWay.add(id);
    const deepest = Math.max(-1, ...(before.get(id) ?? []).map(depth));
    onWay.delete(id);
    found.set(id, deepest + 1);
    return deepest + 1;
  };
  nodes.forEach((node) => depth(node.id));
  return found;
}

/** Nodes that read nothing move right, to just before the first that reads them. */
function pulledRight(found: Map<string, number>, work: Pick<Work, "before" | "after">): void {
  for (const [id] of found) {
    const readers = work.after.get(id) ?? [];
    if ((work.before.get(id) ?? []).length > 0 || readers.length === 0) continue;
    found.set(id, Math.max(0, Math.min(...readers.map((reader) => found.get(reader) ?? 0)) - 1));
  }
}

function prepare(nodes: readonly LayoutNode[], wires: readonly LayoutWire[]): Work {
  const known = new Map(nodes.map((node) => [node.id, node]));
  const before = new Map<string, string[]>(nodes.map((node) => [node.id, []]));
  const after = new Map<string, string[]>(nodes.map((node) => [node.id, []]));
  for (const { from, to } of wires) {
    if (!known.has(from) || !known.has(to) || from === to || before.get(to)!.includes(from)) continue;
    before.get(to)!.push(from);
    after.get(from)!.push(to);
  }
  const found = depths(nodes, before);
  pulledRight(found, { before, after });
  const layers: string[][] = [];
  for (const node of nodes) (layers[found.get(node.id) ?? 0] ??= []).push(node.id);
  const work: Work = { nodes: known, before, after, layers: [...layers].map((layer) => layer ?? []), lanes: new Map() };
  for (const [to, sources] of [...before]) for (const from of [...sources]) keepLanes(work, from, to, found);
  return work;
}

/** A wire that passes layers becomes a chain of short ones, through a lane in each layer. */
function keepLanes(work: Work, from: string, to: string, depth: ReadonlyMap<string, number>): void {
  const lanes: string[] = [];
  for (let layer = depth.get(from)! + 1; layer < depth.get(to)!; ++layer) {
    const lane = `${from}>${to}>${layer}`;
    work.nodes.set(lane, { id: lane, width: 0, height: LANE });
    work.layers[layer]!.push(lane);
    lanes.push(lane);
  }
  if (lanes.length === 0) return;
  work.lanes.set(wireName({ from, to }), lanes);
  const chain = [from, ...lanes, to];
  const replace = (list: string[] | undefined, old: string, by: string) =>
    (list ?? []).map((id) => (id === old ? by : id));
  work.after.set(from, replace(work.after.get(from), to, lanes[0]!));
  work.before.set(to, replace(work.before.get(to), from, lanes[lanes.length - 1]!));
  lanes.forEach((lane, i) => {
    work.before.set(lane, [chain[i]!]);
    work.after.set(lane, [chain[i + 2]!]);
  });
}

/** Sorts each layer by the mean place of its neighbours, to and fro; ties keep the order of the recipe. */
function untangle({ layers, before, after }: Work): void {
  const sweep = (order: string[][], neighbours: ReadonlyMap<string, string[]>) => {
    for (const layer of order) {
      const place = new Map(layers.flatMap((other) => other.map((id, i) => [id, (i + 0.5) / other.length] as const)));
      const mean = new Map(layer.map((id) => {
        const near = neighbours.get(id) ?? [];
        return [id, near.length === 0 ? place.get(id)! : near.reduce((sum, n) => sum + place.get(n)!, 0) / near.length];
      }));
      layer.sort((a, b) => mean.get(a)! - mean.get(b)!);
    }
  };
  for (let round = 0; round < 4; ++round) {
    sweep(layers, before);
    sweep([...layers].reverse(), after);
  }
  sweep(layers, before);
}

/** Heights at which the nodes of a layer lie, apart by the gap and as near to `wanted` as the order lets them. */
function spread(layer: string[], wanted: number[], work: Work, gap: number): number[] {
  const height = (i: number) => work.nodes.get(layer[i]!)!.height;
  const blocks: { first: number; count: number; top: number; weight: number; size: number }[] = [];
  for (let i = 0; i < layer.length; ++i) {
    let block = { first: i, count: 1, top: wanted[i]!, weight: 1, size: height(i) + gap };
    for (let last = blocks[blocks.length - 1]; last && last.top + last.size > block.top;
      last = blocks[blocks.length - 1]) {
      const weight = last.weight + block.weight;
      const top = (last.top * last.weight + (block.top - last.size) * block.weight) / weight;
      block = { first: last.first, count: last.count + block.count, top, weight, size: last.size + block.size };
      blocks.pop();
    }
    blocks.push(block);
  }
  const tops: number[] = [];
  for (const block of blocks) {
    let top = block.top;
    for (let i = block.first; i < block.first + block.count; ++i) {
      tops[i] = top;
      top += height(i) + gap;
    }
  }
  return tops;
}

function heights(work: Work, gap: number): Map<string, number> {
  const tops = new Map<string, number>();
  const middle = (id: string) => tops.get(id)! + work.nodes.get(id)!.height / 2;
  const settle = (order: string[][], neighbours: ReadonlyMap<string, string[]>) => {
    for (const layer of order) {
      const wanted = layer.map((id) => {
        const near = (neighbours.get(id) ?? []).filter((other) => tops.has(other));
        if (near.length === 0) return tops.get(id) ?? 0;
        return near.reduce((sum, other) => sum + middle(other), 0) / near.length - work.nodes.get(id)!.height / 2;
      });
      spread(layer, wanted, work, gap).forEach((top, i) => tops.set(layer[i]!, top));
    }
  };
  settle(work.layers, work.before);
  settle([...work.layers].reverse(), work.after);
  settle(work.layers, work.before);
  return tops;
}

export function layOut(nodes: readonly LayoutNode[], wires: readonly LayoutWire[],
                       { columnGap, rowGap }: LayoutOptions): Layout {
  const work = prepare(nodes, wires);
  untangle(work);
  const tops = heights(work, rowGap);
  const highest = Math.min(...tops.values(), Infinity);
  const columns = columnsOf(work, columnGap);
  const places = new Map<string, Placed>();
  let height = 0;
  work.layers.forEach((layer, i) => {
    for (const id of layer) {
      const y = Math.round(tops.get(id)! - highest);
      places.set(id, { x: columns[i]!.left, y, layer: i });
      height = Math.max(height, y + work.nodes.get(id)!.height);
    }
  });
  const crossings = new Map<string, Crossing[]>();
  for (const [name, lanes] of work.lanes) {
    crossings.set(name, lanes.map((lane) =>
      ({ ...columns[places.get(lane)!.layer]!, y: places.get(lane)!.y + LANE / 2 })));
    lanes.forEach((lane) => places.delete(lane));
  }
  return { places, crossings, width: columns[columns.length - 1]?.right ?? 0, height };
}

function columnsOf(work: Work, gap: number): { left: number; right: number }[] {
  let x = 0;
  return work.layers.map((layer) => {
    const left = x;
    const right = left + Math.max(0, ...layer.map((id) => work.nodes.get(id)!.width));
    x = right + gap;
    return { left, right };
  });
}
