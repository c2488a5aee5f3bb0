package org.web3d.x3d.sai.rendering;

import org.web3d.x3d.sai.X3DCoordinateNode;

/** Positions of single precision (X3D 4.0, clause 11). */
public interface Coordinate extends X3DCoordinateNode {
  /** The number of tuples that {@link #getPoint} writes. */
  int getNumPoint();

  /**
   * The positions in metres; go into the first {@link #getNumPoint()} times three elements of
   * {@code value}.
   */
  void getPoint(float[] value);

  /** Sets {@link #getPoint} to all elements of {@code value}, three for each tuple. */
  void setPoint(float[] value);
}
