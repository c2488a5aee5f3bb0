package org.web3d.x3d.sai.rendering;

import org.web3d.x3d.sai.X3DComposedGeometryNode;

/** Triangles of three indexed coordinates each (X3D 4.0, clause 11). */
public interface IndexedTriangleSet extends X3DComposedGeometryNode {
  /** The number of elements that {@link #getIndex} writes. */
  int getNumIndex();

  /**
   * The indices of the coordinates; go into the first {@link #getNumIndex()} elements of {@code
   * value}.
   */
  void getIndex(int[] value);

  /** Sets {@link #getIndex} to all elements of {@code value}. */
  void setIndex(int[] value);
}
