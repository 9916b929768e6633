// Strokes as hands and pens make them: uneven in time, trembling, slow at the ends and in bends. Metres at 20 m a
// pixel; made from fixed numbers, so that every run has the same ones.
import type { Sample } from "../fit";

function noise(seed: number): () => number {
  let state = seed;
  return () => {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
    return state / 2 ** 32 - 0.5;
  };
}

/** A curve drawn by a trembling hand: `tremble_m` of jitter, pauses where it bends. */
function drawn(
  seed: number, count: number, tremble_m: number, curve: (t: number) => readonly [number, number],
): Sample[] {
  const random = noise(seed);
  let t = 0;
  const samples: Sample[] = [];
  while (t <= 1) {
    const [x, y] = curve(t);
    const pressure = Math.min(1, 0.35 + 0.6 * Math.sin(Math.PI * t) + 0.04 * random());
    samples.push({ x: x + tremble_m * random(), y: y + tremble_m * random(), pressure });
    t += (0.4 + Math.sin(Math.PI * t) + 0.5 * (random() + 0.5)) / count;
    if (random() > 0.45) samples.push(samples[samples.length - 1]!);  // the pen rested
  }
  return samples;
}

export const recorded: readonly Sample[][] = [
  drawn(7, 260, 24, (t) => [-9000 + 18000 * t, 2600 * Math.sin(6 * t) + 800 * Math.cos(11 * t)]),
  drawn(21, 400, 30, (t) => [6000 * Math.cos(5 * t) * (1 - 0.5 * t), 6000 * Math.sin(5 * t) * (1 - 0.5 * t)]),
  drawn(3, 180, 16, (t) => [9000 * t * t, 5000 * Math.sqrt(t)]),
];
