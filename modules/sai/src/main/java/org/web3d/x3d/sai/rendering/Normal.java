package org.web3d.x3d.sai.rendering;

import org.web3d.x3d.sai.X3DNormalNode;

/** Normals (X3D 4.0, clause 11). */
public interface Normal extends X3DNormalNode {
  /** The number of tuples that {@link #getVector} writes. */
  int getNumVector();

  /**
   * The unit vectors; go into the first {@link #getNumVector()} times three elements of {@code
   * value}.
   */
  void getVector(float[] value);

  /** Sets {@link #getVector} to all elements of {@code value}, three for each tuple. */
  void setVector(float[] value);
}
