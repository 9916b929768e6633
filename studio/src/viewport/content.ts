// Fetches what stands on the ground or is drawn over it and is no raster: the things and objects of a scene, and the
// shapes that a step makes.
import { effect, signal } from "@preact/signals";
import type { Json, ValueEvent } from "../api/types";
import { catalogueClasses } from "../document/catalogue";
import type { Studio } from "../document/studio";
import { objectShapes, type ObjectClass, type SceneObject } from "./objects_content";
import { shapeRoles, shapesOf } from "./shapes_content";
import { readThings, type Things } from "./things";
import type { OverlayShape } from "./types";

export interface Content {
  things: Things | null;
  shapes: readonly OverlayShape[];
}

/** Whether what lives on the ground is shown: of the window, never of the recipe. */
export const lifeShown = signal(true);

/** Classes of the objects that are seen on the map, the most frequent first. */
export const seenClasses = signal<readonly ObjectClass[]>([]);

/** The objects themselves. */
export const seenObjects = signal<readonly SceneObject[]>([]);

/** The newest answer of one source; what was there before stays until there is another. */
class Part {
  readonly answer = signal<{ kind: string; content: Json } | null>(null);
  private key = "";

  constructor(private readonly studio: Studio) {}

  follow(source: string | null, value: ValueEvent | undefined): void {
    const kind = value?.kind ?? "";
    const known = source !== null && (kind === "things" || kind in shapeRoles);
    if (source !== null && value === undefined && this.key.startsWith(`${source} `)) return;  // it is computed anew
    const wanted = known ? `${source} ${value!.key}` : "";
    if (wanted === this.key) return;
    this.key = wanted;
    if (!known) {
      this.answer.value = null;
      return;
    }
    const came = (content: Json | null): void => {
      if (wanted === this.key && content !== null) this.answer.value = { kind, content };
    };
    this.studio.content(source, kind === "things" ? "things" : "shapes").then(came, () => undefined);
  }
}

/** Calls whenever there is another; until the returned function is called. */
export function followContent(studio: Studio, came: (content: Content) => void): () => void {
  const overlay = new Part(studio), objects = new Part(studio), things = new Part(studio);
  const ends = [
    effect(() => {
      const { shown, values } = studio, now = shown.value;
      const newest = (source: string | null) => (source === null ? undefined : values.value.get(source));
      const life = lifeShown.value;
      overlay.follow(now.overlay, newest(now.overlay));
      objects.follow(life && now.objects !== now.overlay ? now.objects : null, newest(now.objects));
      things.follow(life && now.things !== now.overlay ? now.things : null, newest(now.things));
    }),
    effect(() => {
      const over = overlay.answer.value;
      const stands = over?.kind === "things" ? over : things.answer.value;
      const scene = over?.kind === "objects" ? over : objects.answer.value;
      const step = (studio.shown.value.objects ?? studio.shown.value.overlay)?.split(".")[0] ?? "";
      const living = scene === null ? null : objectShapes(scene.content, catalogueClasses(studio, step), stands !== null);
      const drawn = over === null || over.kind === "things" || over === scene ? [] : shapesOf(over.content, over.kind);
      seenClasses.value = living?.classes ?? [];
      seenObjects.value = living?.objects ?? [];
      came({ things: stands === null ? null : readThings(stands.content), shapes: [...(living?.shapes ?? []), ...drawn] });
    }),
  ];
  return () => {
    for (const end of ends) end();
    seenClasses.value = [];
    seenObjects.value = [];
  };
}
