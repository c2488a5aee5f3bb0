package org.web3d.x3d.sai.geometry3d;

import org.web3d.x3d.sai.X3DGeometryNode;
import org.web3d.x3d.sai.X3DNode;

/** A cross section moved along a spine (X3D 4.0, clause 13). */
public interface Extrusion extends X3DGeometryNode {
  /** Whether the beginning is closed. */
  boolean getBeginCap();

  /**
   * Sets {@link #getBeginCap()}. Only while the node is not {@linkplain X3DNode#realize()
   * realized}.
   */
  void setBeginCap(boolean value);

  /** Whether the front is the side from which the vertices run counterclockwise. */
  boolean getCcw();

  /** Sets {@link #getCcw()}. Only while the node is not {@linkplain X3DNode#realize() realized}. */
  void setCcw(boolean value);

  /** Whether the cross section is convex. */
  boolean getConvex();

  /**
   * Sets {@link #getConvex()}. Only while the node is not {@linkplain X3DNode#realize() realized}.
   */
  void setConvex(boolean value);

  /** The angle between faces, in radians, up to which their common edge is shaded smoothly. */
  float getCreaseAngle();

  /**
   * Sets {@link #getCreaseAngle()}. Only while the node is not {@linkplain X3DNode#realize()
   * realized}.
   */
  void setCreaseAngle(float value);

  /** The number of tuples that {@link #getCrossSection} writes. */
  int getNumCrossSection();

  /**
   * The points of the cross section in the XZ plane, in metres; go into the first {@link
   * #getNumCrossSection()} times two elements of {@code value}.
   */
  void getCrossSection(float[] value);

  /** Sets {@link #getCrossSection} to all elements of {@code value}, two for each tuple. */
  void setCrossSection(float[] value);

  /** Whether the end is closed. */
  boolean getEndCap();

  /**
   * Sets {@link #getEndCap()}. Only while the node is not {@linkplain X3DNode#realize() realized}.
   */
  void setEndCap(boolean value);

  /** The number of tuples that {@link #getOrientation} writes. */
  int getNumOrientation();

  /**
   * The turns of the cross section at the points of the spine, as axis and angle in radians; go
   * into the first {@link #getNumOrientation()} times four elements of {@code value}.
   */
  void getOrientation(float[] value);

  /** Sets {@link #getOrientation} to all elements of {@code value}, four for each tuple. */
  void setOrientation(float[] value);

  /** The number of tuples that {@link #getScale} writes. */
  int getNumScale();

  /**
   * The factors of the cross section at the points of the spine; go into the first {@link
   * #getNumScale()} times two elements of {@code value}.
   */
  void getScale(float[] value);

  /** Sets {@link #getScale} to all elements of {@code value}, two for each tuple. */
  void setScale(float[] value);

  /** Whether only the front is seen. */
  boolean getSolid();

  /**
   * Sets {@link #getSolid()}. Only while the node is not {@linkplain X3DNode#realize() realized}.
   */
  void setSolid(boolean value);

  /** The number of tuples that {@link #getSpine} writes. */
  int getNumSpine();

  /**
   * The points of the spine in metres; go into the first {@link #getNumSpine()} times three
   * elements of {@code value}.
   */
  void getSpine(float[] value);

  /** Sets {@link #getSpine} to all elements of {@code value}, three for each tuple. */
  void setSpine(float[] value);
}
