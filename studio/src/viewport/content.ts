// Fetches what is laid over the ground and is no raster: things that stand on it, and shapes.
import { effect } from "@preact/signals";
import type { Studio } from "../document/studio";
import { shapeRoles, shapesOf } from "./shapes_content";
import { readThings, type Things } from "./things";
import type { OverlayShape } from "./types";

export interface Content {
  things: Things | null;
  shapes: readonly OverlayShape[];
}

const nothing: Content = { things: null, shapes: [] };

/** Calls whenever there is another; until the returned function is called. */
export function followContent(studio: Studio, came: (content: Content) => void): () => void {
  let key = "";
  const fetch = async (source: string, kind: string): Promise<Content> => {
    const answer = await studio.content(source, kind === "things" ? "things" : "shapes");
    if (answer === null) return nothing;
    return kind === "things" ? { things: readThings(answer), shapes: [] } : { things: null, shapes: shapesOf(answer, kind) };
  };
  return effect(() => {
    const source = studio.shown.value.overlay, value = source === null ? undefined : studio.values.value.get(source);
    const kind = value?.kind ?? "", known = kind === "things" || kind in shapeRoles;
    const wanted = known ? value!.key : "";
    if (wanted === key) return;
    key = wanted;
    if (wanted === "" || source === null) return came(nothing);
    fetch(source, kind).then((content) => key === wanted && came(content), () => key === wanted && came(nothing));
  });
}
