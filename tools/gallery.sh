#!/usr/bin/env bash
# Renders the pictures of docs/gallery from the recipes, never by hand: tools/gallery.sh
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
made=$(mktemp -d)
trap 'rm -rf "$made"' EXIT
./run run recipes/island.json --out "$made/island" --no-cache
cp "$made/island/view.png" docs/gallery/island.png
for recipe in kauai reef_stages archipelago styles; do
  ./run run "recipes/$recipe.json" --out "$made" --no-cache
done
for recipe in reef/barrier reef/platform reef/ribbon reef/patch erosion/worn_island erosion/uplifted_range erosion/fans erosion/canyon erosion/cuestas erosion/alps; do
  ./run run "recipes/$recipe.json" --out "$made/$recipe" --no-cache
  cp "$made/$recipe/view.png" "docs/gallery/${recipe/\//_}.png"
done
./run run recipes/hydrology/map.json --out "$made/hydrology" --no-cache
cp "$made/hydrology/map.png" docs/gallery/hydrology_map.png
./run run recipes/hydrology/dead_sea.json --out "$made/dead_sea" --no-cache
cp "$made/dead_sea/view.png" docs/gallery/hydrology_dead_sea.png
for recipe in volcano mesa canyon range; do
  ./run run "recipes/contours/$recipe.json" --out "$made/contours_$recipe" --no-cache
  cp "$made/contours_$recipe/view.png" "docs/gallery/contours_$recipe.png"
done
for recipe in coral_reef_island island_to_colony canyon alpine_forest competition; do
  ./run run "recipes/ecosystem/$recipe.json" --out "$made/$recipe" --no-cache
done
cp "$made/coral_reef_island/view.png" docs/gallery/ecosystem_island.png
cp "$made/island_to_colony/dive.png" docs/gallery/ecosystem_colony.png
cp "$made/canyon/view.png" docs/gallery/ecosystem_canyon.png
cp "$made/canyon/dive.png" docs/gallery/ecosystem_canyon_dive.png
cp "$made/alpine_forest/view.png" docs/gallery/ecosystem_forest.png
cp "$made/competition/map.png" docs/gallery/ecosystem_competition.png
./run run recipes/contours/coastline.json --out "$made/coastline" --no-cache
for step in 1_coast 2_ranges 3_summits 4_histogram 5_edits 5_contours; do
  cp "$made/coastline/$step.png" "docs/gallery/coastline_$step.png"
done
for recipe in canyon chain; do
  ./run run "recipes/guide/$recipe.json" --out "$made/guide" --no-cache
done
./run run recipes/guide/ages.json --out "$made/ages" --no-cache --sweep variables.age=0:0.5:6
for frame in 1 2 3 6; do
  cp "$made/ages/000$frame/view.png" "docs/gallery/guide_ages_$frame.png"
done
cp "$made/guide/view.png" docs/gallery/guide_canyon.png
cp "$made/guide/inside.png" docs/gallery/guide_canyon_inside.png
cp "$made/guide/chain.png" docs/gallery/guide_chain.png
./run run recipes/guide/dem.json --out "$made/dem" --no-cache
./run new guide/crater --out "$made/dem"
./run run "$made/dem/crater.json" --out "$made/dem" --no-cache
cp "$made/dem/view.png" docs/gallery/guide_crater.png
for recipe in painted first; do
  ./run run "recipes/guide/$recipe.json" --out "$made/guide/$recipe" --no-cache
  cp "$made/guide/$recipe/view.png" "docs/gallery/guide_$recipe.png"
done
for recipe in strokes lambda compose redrawn session; do
  ./run run "recipes/sketches/$recipe.json" --out "$made/sketches_$recipe" --no-cache
done
for recipe in strokes lambda compose redrawn; do
  cp "$made/sketches_$recipe/view.png" "docs/gallery/sketches_$recipe.png"
done
cp "$made/sketches_session/4_rain.png" docs/gallery/sketches_session.png
mv docs/gallery/erosion_worn_island.png docs/gallery/worn_island.png
cp "$made"/{stone,desert,volcano}.png docs/gallery/
cp "$made"/view.png docs/gallery/kauai.png
cp "$made"/map.png docs/gallery/kauai_map.png
cp "$made"/{1_fringing,2_barrier,3_atoll}.png docs/gallery/
cp "$made"/sea.png docs/gallery/archipelago.png
