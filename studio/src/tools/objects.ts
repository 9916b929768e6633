// Which object of a scene a pen means: the nearest one that is seen. Its class goes into the recipe with the place, so
// that something that grows in front of it is not taken for it.
import type { Json } from "../api/types";
import { catalogueClasses, type CatalogueClass } from "../document/catalogue";
import type { Studio } from "../document/studio";
import { seenObjects } from "../viewport/content";
import { nearestObject, type SceneObject } from "../viewport/objects_content";
import type { OverlayShape } from "../viewport/types";
import type { Point } from "./geometry";
import type { Slot } from "./slots";

const kReach_px = 40;

/** It does something to an object that is there. */
export function meansObject(slot: Slot): boolean {
  return [...slot.also, ...slot.parts.map((part) => part.path)].some((path) => path.join("/") === "object/near");
}

export function objectUnder(slot: Slot, at: Point, pixel_m: number): SceneObject | null {
  if (!meansObject(slot)) return null;
  return nearestObject(seenObjects.peek(), at, kReach_px * pixel_m, slot.tool === "bend");
}

/** What a new edit says of the object beside where it is. */
export function objectMembers(object: SceneObject | null): { [name: string]: Json } {
  return object === null || object.name === "" ? {} : { "object/class": object.name };
}

export function objectInk(object: SceneObject | null): OverlayShape[] {
  if (object === null) return [];
  const label = object.name.replace(/_/g, " ");
  const [first] = object.points;
  if (object.points.length < 2) return first ? [{ shape: "dot", at: first, role: "selected", label }] : [];
  return [{ shape: "line", points: object.points, role: "selected", width_px: 3 }];
}

/** Classes that a step's pens choose from; [] for steps without a catalogue. */
export function classesFor(studio: Studio, step: string | null, slot: Slot): readonly CatalogueClass[] {
  const names = slot.members.some((member) => member.name === "class" && member.kind === "text");
  return names && step !== null ? catalogueClasses(studio, step) : [];
}

/** The class of the next object before one is chosen: the first that stands at a place. */
export function firstClass(classes: readonly CatalogueClass[]): string {
  return (classes.find((one) => one.skeleton === "point") ?? classes[0])?.name ?? "";
}

export function skeletonOf(classes: readonly CatalogueClass[], name: Json | undefined): CatalogueClass["skeleton"] {
  return classes.find((one) => one.name === name)?.skeleton ?? "point";
}
