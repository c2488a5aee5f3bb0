package org.web3d.x3d.sai.geometry3d;

import org.web3d.x3d.sai.X3DComposedGeometryNode;
import org.web3d.x3d.sai.X3DNode;

/** Polygons over shared coordinates (X3D 4.0, clause 13). */
public interface IndexedFaceSet extends X3DComposedGeometryNode {
  /** The number of elements that {@link #getColorIndex} writes. */
  int getNumColorIndex();

  /**
   * The indices of the colours; go into the first {@link #getNumColorIndex()} elements of {@code
   * value}.
   */
  void getColorIndex(int[] value);

  /** Sets {@link #getColorIndex} to all elements of {@code value}. */
  void setColorIndex(int[] value);

  /** The number of elements that {@link #getCoordIndex} writes. */
  int getNumCoordIndex();

  /**
   * The indices of the coordinates; -1 ends a face; go into the first {@link #getNumCoordIndex()}
   * elements of {@code value}.
   */
  void getCoordIndex(int[] value);

  /** Sets {@link #getCoordIndex} to all elements of {@code value}. */
  void setCoordIndex(int[] value);

  /** The number of elements that {@link #getTexCoordIndex} writes. */
  int getNumTexCoordIndex();

  /**
   * The indices of the texture coordinates; go into the first {@link #getNumTexCoordIndex()}
   * elements of {@code value}.
   */
  void getTexCoordIndex(int[] value);

  /** Sets {@link #getTexCoordIndex} to all elements of {@code value}. */
  void setTexCoordIndex(int[] value);

  /** The number of elements that {@link #getNormalIndex} writes. */
  int getNumNormalIndex();

  /**
   * The indices of the normals; go into the first {@link #getNumNormalIndex()} elements of {@code
   * value}.
   */
  void getNormalIndex(int[] value);

  /** Sets {@link #getNormalIndex} to all elements of {@code value}. */
  void setNormalIndex(int[] value);

  /** The angle between faces, in radians, up to which their common edge is shaded smoothly. */
  float getCreaseAngle();

  /**
   * Sets {@link #getCreaseAngle()}. Only while the node is not {@linkplain X3DNode#realize()
   * realized}.
   */
  void setCreaseAngle(float value);

  /** Whether all faces are convex. */
  boolean getConvex();

  /**
   * Sets {@link #getConvex()}. Only while the node is not {@linkplain X3DNode#realize() realized}.
   */
  void setConvex(boolean value);
}
