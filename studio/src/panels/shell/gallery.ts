// The examples as the first screen shows them: six that say what there is, then all others by what they are about.
import type { ExampleInfo } from "../../api/api";

export interface GalleryGroup {
  title: string;
  examples: readonly ExampleInfo[];
}

const kFeatured = [
  "kauai", "reef_stages", "contours/volcano", "erosion/alps", "ecosystem/coral_reef_island", "erosion/canyon",
  "contours/canyon",
  "archipelago", "sketches/strokes",
];
const kFirst = 6;
const kTitles: { [group: string]: string } = {
  "": "Islands", contours: "From contours", ecosystem: "Life", erosion: "Worn by time", guide: "From the guide",
  hydrology: "Water",
  reef: "Reefs", sketches: "From sketches", pen: "By hand",
};

function titleOf(group: string): string {
  return kTitles[group] ?? group.charAt(0).toUpperCase() + group.slice(1).replace(/_/g, " ");
}

/** Those with a picture first; the blank sheet is offered elsewhere. */
export function galleryOf(examples: readonly ExampleInfo[]): GalleryGroup[] {
  const known = examples.filter((example) => example.name !== "blank");
  const featured = kFeatured.flatMap(
    (name) => known.filter((example) => example.name === name && example.picture !== false),
  ).slice(0, kFirst);
  const others = known.filter((example) => !featured.includes(example));
  const names = [...new Set(others.map((example) => example.group))];
  const groups = names.map((name) => {
    const own = others.filter((example) => example.group === name);
    const seen = own.filter((example) => example.picture !== false);
    return { title: titleOf(name), examples: [...seen, ...own.filter((example) => example.picture === false)] };
  });
  return featured.length > 0 ? [{ title: "Examples to begin with", examples: featured }, ...groups] : groups;
}
