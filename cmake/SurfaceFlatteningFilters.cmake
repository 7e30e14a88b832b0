# The filters of the plugin, one per line: each has <name>.xml in Plugin and, with what it does in ParaView's window, in
# Testing/GUI.
set(surfaceflattening_filters
  AreaWeights
  ConformalDisk
  ContextResolution
  DistortionMetrics
  FlatMapImage
  FlatMapSlab
  FlatMapTransfer
  FlattenRegion
  MeshSaliency
  OMTAreaPreserving
  PatientSpace
  PlanarWarp
  SurfaceToDisk
  VolumeToSurface
)
