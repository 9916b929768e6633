// Search among operators by a few letters: of the name, the words of its summary, its family, what it makes.
import type { OperatorInfo } from "../../api/types";

/** How well `wanted` fits `text`: 0 not at all; whole words before beginnings before letters in a row. */
export function fuzzy(wanted: string, text: string): number {
  const query = wanted.trim().toLowerCase();
  const target = text.toLowerCase();
  if (query === "") return 1;
  const at = target.indexOf(query);
  if (at !== -1) {
    const starts = at === 0 || /[\s._-]/.test(target[at - 1]!);
    return (starts ? 100 : 60) + 40 * (query.length / target.length);
  }
  let from = 0;
  let score = 0;
  for (const letter of query) {
    const next = target.indexOf(letter, from);
    if (next === -1) return 0;
    const starts = next === 0 || /[\s._-]/.test(target[next - 1]!);
    score += starts ? 8 : next === from ? 4 : 0;
    from = next + 1;
  }
  return score >= query.length * 4 ? score : 0;
}

/** Words that people of other programs look for, and where they find it. */
const ALSO: { readonly [word: string]: string } = {
  "terrain.noise": "perlin simplex fbm fractal mountain ridged base heightmap",
  "terrain.import": "dem geotiff heightmap file load open",
  "terrain.smooth": "blur sharpen", "terrain.blend": "combine mix merge max min",
  "erosion.run": "hydraulic thermal weathering rivers", "erosion.refine": "enlarge large amplify gullies detail",
  "hydrology.flow": "accumulation drainage",
  "terrain.mask": "select slope height selector", "render.perspective": "picture view render 3d",
  "ecosystem.scatter": "trees instances place", "island.build": "volcano atoll coast draw",
};

function scoreOf(query: string, op: OperatorInfo): number {
  const words = query.trim().split(/\s+/).filter(Boolean);
  let sum = 0;
  for (const word of words) {
    const makes = op.out.map((port) => port.kind).join(" ");
    const summary = op.summary.toLowerCase().includes(word.toLowerCase()) ? fuzzy(word, op.summary) * 0.5 : 0;
    const also = (ALSO[op.name] ?? "").split(" ")
      .some((other) => word.length > 2 && other.startsWith(word.toLowerCase()));
    const best = Math.max(fuzzy(word, op.name) * 1.2, summary, also ? 55 : 0, makes.startsWith(word.toLowerCase())
      ? 30 : 0);
    if (best === 0) return 0;
    sum += best;
  }
  return words.length === 0 ? 1 : sum;
}

/** The operators that fit, best first; `rank` (0 first) goes before among those that fit about as well. */
export function findOperators(query: string, operators: readonly OperatorInfo[],
                              rank: (op: OperatorInfo) => number): OperatorInfo[] {
  return operators.map((op, index) => ({ op, index, score: scoreOf(query, op), rank: rank(op) }))
    .filter((found) => found.score > 0)
    .map((found) => ({ ...found, order: found.score - (query.trim() === "" ? 1000 : 15) * found.rank }))
    .sort((a, b) => b.order - a.order || a.index - b.index)
    .map((found) => found.op);
}

/** "terrain, labels → terrain"; optional inputs in brackets. */
export function takesAndMakes(op: OperatorInfo): { takes: string; makes: string } {
  const kinds = (ports: readonly { kind: string }[]) => [...new Set(ports.map((port) => port.kind))].join(", ");
  const required = kinds(op.in.filter((port) => port.required));
  return { takes: required || "nothing", makes: kinds(op.out) };
}
