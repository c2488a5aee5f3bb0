package org.web3d.x3d.sai.rendering;

import org.web3d.x3d.sai.X3DComposedGeometryNode;

/** Strips of triangles over indexed coordinates (X3D 4.0, clause 11). */
public interface IndexedTriangleStripSet extends X3DComposedGeometryNode {
  /** The number of elements that {@link #getIndex} writes. */
  int getNumIndex();

  /**
   * The indices of the coordinates; -1 ends a strip; go into the first {@link #getNumIndex()}
   * elements of {@code value}.
   */
  void getIndex(int[] value);

  /** Sets {@link #getIndex} to all elements of {@code value}. */
  void setIndex(int[] value);
}
