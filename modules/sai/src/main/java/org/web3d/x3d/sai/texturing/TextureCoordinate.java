package org.web3d.x3d.sai.texturing;

import org.web3d.x3d.sai.X3DTextureCoordinateNode;

/** Places in an image (X3D 4.0, clause 18). */
public interface TextureCoordinate extends X3DTextureCoordinateNode {
  /** The number of tuples that {@link #getPoint} writes. */
  int getNumPoint();

  /**
   * The places, s and t, where the image spans 0 to 1; go into the first {@link #getNumPoint()}
   * times two elements of {@code value}.
   */
  void getPoint(float[] value);

  /** Sets {@link #getPoint} to all elements of {@code value}, two for each tuple. */
  void setPoint(float[] value);
}
