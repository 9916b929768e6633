// The difference of two texts as few small replacements, so that what did not change keeps its cursor.

export interface Replacement {
  from: number;
  to: number;
  insert: string;
}

/** Above this many pairs of lines a difference is one block: nobody reads it as lines any more. */
const kMostPairs = 4_000_000;

function linesOf(text: string): string[] {
  return text.match(/[^\n]*\n|[^\n]+$/g) ?? [];
}

/** Lengths of longest common subsequences of the rests from (i, j) on. */
function commonLengths(a: readonly string[], b: readonly string[]): Uint32Array {
  const width = b.length + 1;
  const lengths = new Uint32Array((a.length + 1) * width);
  for (let i = a.length - 1; i >= 0; --i) {
    for (let j = b.length - 1; j >= 0; --j) {
      lengths[i * width + j] = a[i] === b[j]
        ? lengths[(i + 1) * width + j + 1]! + 1
        : Math.max(lengths[(i + 1) * width + j]!, lengths[i * width + j + 1]!);
    }
  }
  return lengths;
}

/** Runs of lines [from, to) of a that give way to lines [start, end) of b. */
function lineRuns(a: readonly string[], b: readonly string[]): [number, number, number, number][] {
  if (a.length * b.length > kMostPairs) return [[0, a.length, 0, b.length]];
  const lengths = commonLengths(a, b), width = b.length + 1;
  const runs: [number, number, number, number][] = [];
  let i = 0, j = 0;
  while (i < a.length || j < b.length) {
    const from = i, start = j;
    while ((i < a.length || j < b.length) && !(i < a.length && j < b.length && a[i] === b[j])) {
      if (j === b.length || (i < a.length && lengths[(i + 1) * width + j]! >= lengths[i * width + j + 1]!)) ++i;
      else ++j;
    }
    if (i > from || j > start) runs.push([from, i, start, j]);
    while (i < a.length && j < b.length && a[i] === b[j]) {
      ++i;
      ++j;
    }
  }
  return runs;
}

/** Without the letters at both ends that are the same. */
function narrowed(replaced: string, { from, to, insert }: Replacement): Replacement {
  let start = 0;
  const most = Math.min(replaced.length, insert.length);
  while (start < most && replaced[start] === insert[start]) ++start;
  let end = 0;
  while (end < most - start && replaced[replaced.length - 1 - end] === insert[insert.length - 1 - end]) ++end;
  return { from: from + start, to: to - end, insert: insert.slice(start, insert.length - end) };
}

/** In order and apart; offsets are of the text before. */
export function differences(before: string, after: string): Replacement[] {
  if (before === after) return [];
  const a = linesOf(before), b = linesOf(after);
  let head = 0;
  while (head < a.length && head < b.length && a[head] === b[head]) ++head;
  let tail = 0;
  while (tail < a.length - head && tail < b.length - head && a[a.length - 1 - tail] === b[b.length - 1 - tail]) ++tail;
  const offsets = [0];
  for (const line of a) offsets.push(offsets[offsets.length - 1]! + line.length);
  return lineRuns(a.slice(head, a.length - tail), b.slice(head, b.length - tail)).map(([i, k, j, l]) => {
    const from = offsets[head + i]!, to = offsets[head + k]!;
    return narrowed(before.slice(from, to), { from, to, insert: b.slice(head + j, head + l).join("") });
  });
}
