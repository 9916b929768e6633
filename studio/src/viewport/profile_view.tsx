// The profile along a drawn line: an area under the heights with round marks, and what is under the pointer.
import { useState } from "preact/hooks";
import type { ProfileData } from "./profile";
import { heightText, lengthText, multiples, roundUpNice } from "./ticks";

interface Props {
  data: ProfileData;
  width?: number;
  height?: number;
  /** A place of the line is pointed at; null: none. */
  pointed?: (place: readonly [number, number] | null) => void;
  close?: () => void;
}

const left = 58, right = 14, top = 26, bottom = 24;

function pieces(data: ProfileData, x: (s: number) => number, y: (h: number) => number): [number, number][][] {
  const result: [number, number][][] = [];
  let now: [number, number][] | null = null;
  data.height.forEach((h, i) => {
    if (h === null) {
      now = null;
      return;
    }
    if (now === null) result.push((now = []));
    now.push([x(data.distance[i]!), y(h)]);
  });
  return result;
}

export function Profile({ data, width = 520, height = 170, pointed, close }: Props) {
  const [index, setIndex] = useState<number | null>(null);
  const across = width - left - right, down = height - top - bottom;
  const step = roundUpNice(Math.max(1, data.max - data.min) / 4);
  const low = Math.floor(data.min / step) * step, high = Math.max(low + step, Math.ceil(data.max / step) * step);
  const x = (s: number): number => left + (s / data.length) * across;
  const y = (h: number): number => top + (1 - (h - low) / (high - low)) * down;
  const marks = multiples(0, data.length, roundUpNice(data.length / 6));
  const path = (line: [number, number][]): string => line.map(
    ([px, py], i) => `${i === 0 ? "M" : "L"}${px.toFixed(1)} ${py.toFixed(1)}`,
  ).join("");
  const lines = pieces(data, x, y), sea = y(Math.min(high, Math.max(low, 0)));
  const point = (event: PointerEvent): void => {
    const box = (event.currentTarget as SVGElement).getBoundingClientRect();
    const share = (((event.clientX - box.left) / box.width) * width - left) / across;
    const i = Math.round(Math.min(1, Math.max(0, share)) * (data.distance.length - 1));
    setIndex(i);
    pointed?.(data.places[i]!);
  };
  const leave = (): void => {
    setIndex(null);
    pointed?.(null);
  };
  const at = index === null ? null : data.height[index]!;
  const length = (metres: number): string => lengthText(Number(metres.toPrecision(3)));
  const words = index === null
    ? `${length(data.length)}   \u2191 ${heightText(data.rise)}   \u2193 ${heightText(data.fall)}`
    : `${length(data.distance[index]!)}   ${at === null ? "no ground" : heightText(at)}`;
  return (
    <div class="view-profile">
      <svg
        viewBox={`0 0 ${width} ${height}`}
        width={width}
        height={height}
        role="img"
        aria-label={`Profile, ${words}`}
        onPointerMove={point}
        onPointerLeave={leave}
      >
        <text x={left} y={16} class="view-profile-words">
          {words}
        </text>
        {multiples(low, high, step).map((h) => (
          <g key={h}>
            <line
              x1={left}
              x2={width - right}
              y1={y(h)}
              y2={y(h)}
              class={h === 0 ? "view-profile-sea" : "view-profile-line"}
            />
            <text x={left - 6} y={y(h) + 4} text-anchor="end" class="view-profile-mark">
              {heightText(h)}
            </text>
          </g>
        ))}
        {marks.map((s) => (
          <text key={s} x={x(s)} y={height - 7} text-anchor={s === 0 ? "start" : "middle"} class="view-profile-mark">
            {s === 0 ? "0" : lengthText(s)}
          </text>
        ))}
        {low < 0 && <rect x={left} y={sea} width={across} height={y(low) - sea} class="view-profile-water" />}
        {lines.map((line) => (
          <g key={line[0]![0]}>
            <path
              d={`${path(line)}L${line[line.length - 1]![0].toFixed(1)} ${y(low)}L${line[0]![0].toFixed(1)} ${y(low)}Z`}
              class="view-profile-ground"
            />
            <path d={path(line)} class="view-profile-top" />
          </g>
        ))}
        {index !== null && (
          <line
            x1={x(data.distance[index]!)}
            x2={x(data.distance[index]!)}
            y1={top}
            y2={height - bottom}
            class="view-profile-pointed"
          />
        )}
        {index !== null && at !== null && (
          <circle cx={x(data.distance[index]!)} cy={y(at)} r={3.5} class="view-profile-dot" />
        )}
      </svg>
      {close && (
        <button type="button" class="view-profile-close" aria-label="Close the profile" onClick={close}>
          {"\u00d7"}
        </button>
      )}
    </div>
  );
}
