package org.web3d.x3d.sai.geometry3d;

import org.jspecify.annotations.Nullable;
import org.web3d.x3d.sai.X3DColorNode;
import org.web3d.x3d.sai.X3DGeometryNode;
import org.web3d.x3d.sai.X3DNode;
import org.web3d.x3d.sai.X3DNormalNode;
import org.web3d.x3d.sai.X3DProtoInstance;
import org.web3d.x3d.sai.X3DTextureCoordinateNode;

/** A rectangular grid of heights over the XZ plane (X3D 4.0, clause 13). */
public interface ElevationGrid extends X3DGeometryNode {
  /** The colours, or null. */
  @Nullable X3DNode getColor();

  /** Sets {@link #getColor()}; null empties the field. */
  void setColor(@Nullable X3DColorNode value);

  /** Sets {@link #getColor()} to an instance of a prototype. */
  void setColor(X3DProtoInstance value);

  /** The normals, or null. */
  @Nullable X3DNode getNormal();

  /** Sets {@link #getNormal()}; null empties the field. */
  void setNormal(@Nullable X3DNormalNode value);

  /** Sets {@link #getNormal()} to an instance of a prototype. */
  void setNormal(X3DProtoInstance value);

  /** The texture coordinates, or null. */
  @Nullable X3DNode getTexCoord();

  /** Sets {@link #getTexCoord()}; null empties the field. */
  void setTexCoord(@Nullable X3DTextureCoordinateNode value);

  /** Sets {@link #getTexCoord()} to an instance of a prototype. */
  void setTexCoord(X3DProtoInstance value);

  /** Whether the front is the side from which the vertices run counterclockwise. */
  boolean getCcw();

  /** Sets {@link #getCcw()}. Only while the node is not {@linkplain X3DNode#realize() realized}. */
  void setCcw(boolean value);

  /** Whether each vertex has a colour, rather than each quadrilateral. */
  boolean getColorPerVertex();

  /**
   * Sets {@link #getColorPerVertex()}. Only while the node is not {@linkplain X3DNode#realize()
   * realized}.
   */
  void setColorPerVertex(boolean value);

  /** The angle between faces, in radians, up to which their common edge is shaded smoothly. */
  float getCreaseAngle();

  /**
   * Sets {@link #getCreaseAngle()}. Only while the node is not {@linkplain X3DNode#realize()
   * realized}.
   */
  void setCreaseAngle(float value);

  /** The number of elements that {@link #getHeight} writes. */
  int getNumHeight();

  /**
   * The heights in metres, row by row; go into the first {@link #getNumHeight()} elements of {@code
   * value}.
   */
  void getHeight(float[] value);

  /** Sets {@link #getHeight} to all elements of {@code value}. */
  void setHeight(float[] value);

  /** Whether each vertex has a normal, rather than each quadrilateral. */
  boolean getNormalPerVertex();

  /**
   * Sets {@link #getNormalPerVertex()}. Only while the node is not {@linkplain X3DNode#realize()
   * realized}.
   */
  void setNormalPerVertex(boolean value);

  /** Whether only the front is seen. */
  boolean getSolid();

  /**
   * Sets {@link #getSolid()}. Only while the node is not {@linkplain X3DNode#realize() realized}.
   */
  void setSolid(boolean value);

  /** The number of heights in a row. */
  int getXDimension();

  /**
   * Sets {@link #getXDimension()}. Only while the node is not {@linkplain X3DNode#realize()
   * realized}.
   */
  void setXDimension(int value);

  /** The distance between heights along X in metres. */
  float getXSpacing();

  /**
   * Sets {@link #getXSpacing()}. Only while the node is not {@linkplain X3DNode#realize()
   * realized}.
   */
  void setXSpacing(float value);

  /** The number of rows. */
  int getZDimension();

  /**
   * Sets {@link #getZDimension()}. Only while the node is not {@linkplain X3DNode#realize()
   * realized}.
   */
  void setZDimension(int value);

  /** The distance between rows along Z in metres. */
  float getZSpacing();

  /**
   * Sets {@link #getZSpacing()}. Only while the node is not {@linkplain X3DNode#realize()
   * realized}.
   */
  void setZSpacing(float value);
}
