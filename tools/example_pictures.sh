#!/usr/bin/env bash
# Small pictures of the examples for the studio's first screen, from docs/gallery: tools/example_pictures.sh
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
mkdir -p studio/examples
while read -r recipe picture; do
  gdal_translate -q -of JPEG -co QUALITY=82 -outsize 480 0 -r average --config GDAL_PAM_ENABLED NO \
    "docs/gallery/$picture.png" "studio/examples/${recipe//\//_}.jpg"
done <<'EXAMPLES'
archipelago archipelago
contours/canyon contours_canyon
contours/coastline coastline_5_contours
contours/mesa contours_mesa
contours/range contours_range
contours/volcano contours_volcano
ecosystem/alpine_forest ecosystem_forest
ecosystem/canyon ecosystem_canyon
ecosystem/competition ecosystem_competition
ecosystem/coral_reef_island ecosystem_island
ecosystem/island_to_colony ecosystem_colony
erosion/alps erosion_alps
erosion/canyon erosion_canyon
erosion/cuestas erosion_cuestas
erosion/fans erosion_fans
erosion/uplifted_range erosion_uplifted_range
erosion/worn_island worn_island
guide/ages guide_ages_3
guide/canyon guide_canyon
guide/chain guide_chain
guide/crater guide_crater
guide/first guide_first
guide/painted guide_painted
hydrology/dead_sea hydrology_dead_sea
hydrology/map hydrology_map
island island
kauai kauai
reef/barrier reef_barrier
reef/patch reef_patch
reef/platform reef_platform
reef/ribbon reef_ribbon
reef_stages 2_barrier
sketches/compose sketches_compose
sketches/lambda sketches_lambda
sketches/redrawn sketches_redrawn
sketches/session sketches_session
sketches/strokes sketches_strokes
EXAMPLES
