package org.selectiverenderer.geometry.tessellate;

import org.selectiverenderer.geometry.mesh.Mesh;

/** Tessellates one type of geometry node. */
@FunctionalInterface
interface GeometryKind {
  /** Returns the mesh of the job's node; empty if nothing of it can be drawn. */
  Mesh mesh(TessellationJob job);
}
