// Which of some titles a few typed letters mean, the likeliest first.

export interface Rankable {
  title: string;
  /** More words to be found by. */
  words?: string;
}

/** Higher is likelier; 0: not meant. Every typed word must be somewhere. */
export function rank(item: Rankable, typed: string): number {
  const title = item.title.toLowerCase();
  const all = `${title} ${(item.words ?? "").toLowerCase()}`;
  let sum = 1;
  for (const word of typed.toLowerCase().split(/\s+/).filter(Boolean)) {
    if (title.startsWith(word)) sum += 8;
    else if (new RegExp(`(^|[^a-z0-9])${escape(word)}`).test(title)) sum += 5;
    else if (title.includes(word)) sum += 3;
    else if (all.includes(word)) sum += 1;
    else return 0;
  }
  return sum;
}

function escape(word: string): string {
  return word.replace(/[.*+?^${}()|[\]\\]/g, "\\$&");
}

/** Equal ones keep their order. */
export function ranked<T extends Rankable>(items: readonly T[], typed: string): T[] {
  const scored = items.map((item, i) => ({ item, i, score: rank(item, typed) })).filter(({ score }) => score > 0);
  return scored.sort((a, b) => b.score - a.score || a.i - b.i).map(({ item }) => item);
}
