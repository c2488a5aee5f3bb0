package org.web3d.x3d.sai.rendering;

import org.web3d.x3d.sai.X3DComposedGeometryNode;

/** Strips of triangles over consecutive coordinates (X3D 4.0, clause 11). */
public interface TriangleStripSet extends X3DComposedGeometryNode {
  /** The number of elements that {@link #getStripCount} writes. */
  int getNumStripCount();

  /**
   * The number of vertices of each strip; go into the first {@link #getNumStripCount()} elements of
   * {@code value}.
   */
  void getStripCount(int[] value);

  /** Sets {@link #getStripCount} to all elements of {@code value}. */
  void setStripCount(int[] value);
}
