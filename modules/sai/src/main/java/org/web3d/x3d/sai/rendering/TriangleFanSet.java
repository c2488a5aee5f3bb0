package org.web3d.x3d.sai.rendering;

import org.web3d.x3d.sai.X3DComposedGeometryNode;

/** Fans of triangles over consecutive coordinates (X3D 4.0, clause 11). */
public interface TriangleFanSet extends X3DComposedGeometryNode {
  /** The number of elements that {@link #getFanCount} writes. */
  int getNumFanCount();

  /**
   * The number of vertices of each fan; go into the first {@link #getNumFanCount()} elements of
   * {@code value}.
   */
  void getFanCount(int[] value);

  /** Sets {@link #getFanCount} to all elements of {@code value}. */
  void setFanCount(int[] value);
}
