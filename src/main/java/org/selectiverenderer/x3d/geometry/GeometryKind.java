package org.selectiverenderer.x3d.geometry;

/** Turns one kind of geometry node into a mesh. */
@FunctionalInterface
interface GeometryKind {
  /** The mesh of the job's node; empty when nothing of it can be drawn. */
  Mesh mesh(Job job);
}
