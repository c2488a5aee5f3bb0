package org.selectiverenderer.geometry.tessellate;

import org.selectiverenderer.geometry.mesh.Mesh;

/** Turns one kind of geometry node into a mesh. */
@FunctionalInterface
interface GeometryKind {
  /** The mesh of the job's node; empty when nothing of it can be drawn. */
  Mesh mesh(TessellationJob job);
}
