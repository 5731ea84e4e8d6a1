# SPDX-License-Identifier: MIT
# The table of contents: every header of the library, by floor. A header includes headers of its own floor or of lower
# ones, never upward and never in a circle (tests/checks/floors.py). To add a header, add its name here.

set(LANTERN_FLOOR_0
  alternative
  halton
  hash
  image
  interval
  load
  ray
  samples
  save
  sobol
  srgb
  todo
  validate
  warp
)

set(LANTERN_FLOOR_1
  camera
  filter
  pfm
  png
  ppm
  surface
)

set(LANTERN_FLOOR_2
  blinn_phong
  bvh
  closest
  coated
  diffuse
  emissive
  glass
  glossy
  light
  material
  mirror
  precise
  rectangle_light
  sky
  sphere
)

set(LANTERN_FLOOR_3
  direct
  distribution
  exact
  exact_light
  render
  whitted
)

# These need stb and belong to lantern::png; everything else needs GLM and threads alone.
set(LANTERN_STB_HEADERS
  png
)
