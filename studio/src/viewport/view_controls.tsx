// The 3D view's own controls: a button that opens how the ground is shown.
import { signal } from "@preact/signals";
import { Home, SlidersHorizontal } from "lucide-preact";
import { render } from "preact";
import { useEffect, useRef } from "preact/hooks";
import { lifeShown } from "./content";
import { climateNames, type ClimateChoice } from "./climate";
import type { ViewOptions } from "./options";
import { styleNames } from "./view_actions";
import type { Viewport } from "./viewport";

const compass = ["N", "NE", "E", "SE", "S", "SW", "W", "NW"];

function Slider(
  props: {
    name: string; low: number; high: number; step: number; value: number; words: string; set: (value: number) => void;
  },
) {
  return (
    <label class="view-slider">
      <span>{props.name}</span>
      <input
        type="range" min={props.low} max={props.high} step={props.step} value={props.value} aria-valuetext={props.words}
        onInput={(event) => props.set(Number(event.currentTarget.value))}
      />
      <output>{props.words}</output>
    </label>
  );
}

function Controls({ viewport }: { viewport: Viewport }) {
  const open = useRef(signal(false)).current, box = useRef<HTMLDivElement>(null);
  const now = viewport.options.value;
  const change = (part: Partial<ViewOptions>): void => {
    viewport.options.value = { ...viewport.options.peek(), ...part };
  };
  useEffect(() => {
    if (!open.value) return undefined;
    const away = (event: Event): void => {
      if (
        event instanceof KeyboardEvent ? event.key === "Escape" : !box.current?.contains(event.target as Node)
      ) open.value = false;
    };
    document.addEventListener("pointerdown", away, true);
    document.addEventListener("keydown", away);
    return () => {
      document.removeEventListener("pointerdown", away, true);
      document.removeEventListener("keydown", away);
    };
  }, [open.value]);
  const { azimuth_deg, elevation_deg } = now.sun;
  const bearing = `${compass[Math.round(azimuth_deg / 45) % 8]} ${Math.round(azimuth_deg)}\u00b0`;
  return (
    <div class="view-controls" ref={box}>
      <button
        type="button"
        class="icon"
        title="Show the whole terrain (Home)"
        aria-label="Show the whole terrain"
        onClick={() => viewport.frameAll()}
      >
        <Home aria-hidden />
      </button>
      <button
        type="button"
        class="icon"
        title="How the ground is shown"
        aria-label="How the ground is shown"
        aria-expanded={open.value}
        aria-haspopup="dialog"
        onClick={() => (open.value = !open.value)}
      >
        <SlidersHorizontal aria-hidden />
      </button>
      {open.value && (
        <div class="view-options" role="dialog" aria-label="How the ground is shown">
          <div class="view-styles" role="radiogroup" aria-label="Ground">
            {styleNames.map(([style, name]) => (
              <button
                key={style}
                type="button"
                role="radio"
                aria-checked={now.ground === style}
                onClick={() => change({ ground: style })}
              >
                {name}
              </button>
            ))}
          </div>
          <label class="view-slider view-choice" title={climateNames.find(([name]) => name === now.climate)?.[2]}>
            <span>Climate</span>
            <select
              value={now.climate}
              onChange={(event) => change({ climate: event.currentTarget.value as ClimateChoice })}
            >
              {climateNames.map(([climate, name]) => <option key={climate} value={climate}>{name}</option>)}
            </select>
          </label>
          <Slider
            name="Heights"
            low={0.5}
            high={6}
            step={0.1}
            value={now.exaggeration}
            words={`\u00d7 ${now.exaggeration.toFixed(1)}`}
            set={(exaggeration) => change({ exaggeration })}
          />
          <Slider
            name="Sun from"
            low={0}
            high={360}
            step={1}
            value={azimuth_deg}
            words={bearing}
            set={(azimuth) => change({ sun: { azimuth_deg: azimuth, elevation_deg } })}
          />
          <Slider
            name="Sun height"
            low={2}
            high={85}
            step={1}
            value={elevation_deg}
            words={`${Math.round(elevation_deg)}\u00b0`}
            set={(elevation) => change({ sun: { azimuth_deg, elevation_deg: elevation } })}
          />
          <div class="view-switches">
            {(
              [
                ["water", "Water"],
                ["wireframe", "Wireframe"],
                ["grid", "Map grid"],
              ] as const
            ).map(([name, title]) => (
              <label key={name}>
                <input
                  type="checkbox"
                  checked={now[name]}
                  onChange={(event) => change({ [name]: event.currentTarget.checked })}
                />
                {title}
              </label>
            ))}
            <label>
              <input
                type="checkbox"
                checked={lifeShown.value}
                onChange={(event) => (lifeShown.value = event.currentTarget.checked)}
              />
              Life
            </label>
          </div>
        </div>
      )}
    </div>
  );
}

/** Puts the controls into the upper left corner of a view until the returned function is called. */
export function mountControls(viewport: Viewport, host: HTMLElement): () => void {
  const place = document.createElement("div");
  place.className = "view-controls-place";
  for (const type of ["pointerdown", "pointermove", "wheel", "dblclick"] as const) {
    place.addEventListener(type, (event) => event.stopPropagation());
  }
  host.append(place);
  render(<Controls viewport={viewport} />, place);
  return () => {
    render(null, place);
    place.remove();
  };
}
