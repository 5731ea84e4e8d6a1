# SPDX-License-Identifier: MIT
# The table of contents: every header of the library, by floor. A header includes headers of its own floor or of lower
# ones, never upward and never in a circle (tests/checks/floors.py). To add a header, add its name here.

set(LANTERN_FLOOR_0
  alternative
  centered
  basis
  double_double
  halton
  hash
  image
  interval
  load
  ray
  samples
  save
  sobol
  solid_angle
  srgb
  todo
  validate
  warp
)

set(LANTERN_FLOOR_1
  aabb
  bounding_sphere
  bounding_volume
  boxes_of
  camera
  filter
  hull
  moving_camera
  obb
  pfm
  png
  ppm
  precise
  surface
)

set(LANTERN_FLOOR_2
  any_of
  blinn_phong
  box
  bvh
  closest
  coated
  cylinder
  diffuse
  disk
  disk_light
  emissive
  glass
  glossy
  grid
  instance
  kd_tree
  light
  material
  mesh
  mirror
  moving
  moving_light
  obj
  object
  octree
  plane
  rectangle
  rectangle_light
  rotating
  sky
  sphere
  sphere_light
  triangle
  within
)

set(LANTERN_FLOOR_3
  direct
  distribution
  exact
  exact_error
  exact_light
  render
  validate_scene
  whitted
)

# These need stb and belong to lantern::png, or tinyobjloader and lantern::obj; everything else needs GLM and threads alone.
set(LANTERN_STB_HEADERS
  png
)
set(LANTERN_TINYOBJ_HEADERS
  obj
)
