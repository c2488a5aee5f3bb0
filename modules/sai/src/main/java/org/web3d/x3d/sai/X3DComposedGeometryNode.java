package org.web3d.x3d.sai;

import org.jspecify.annotations.Nullable;

/**
 * Geometry made of faces over shared coordinates, colours, normals and texture coordinates (X3D
 * 4.0, clause 11).
 */
public interface X3DComposedGeometryNode extends X3DGeometryNode {
  /** The number of nodes that {@link #getAttrib} writes. */
  int getNumAttrib();

  /**
   * The vertex attributes for shaders; go into the first {@link #getNumAttrib()} elements of {@code
   * value}.
   */
  void getAttrib(X3DNode[] value);

  /** Sets {@link #getAttrib} to all elements of {@code value}. */
  void setAttrib(X3DNode[] value);

  /** The fog depths, or null. */
  @Nullable X3DNode getFogCoord();

  /** Sets {@link #getFogCoord()}; null empties the field. */
  void setFogCoord(@Nullable X3DNode value);

  /** The coordinates, or null. */
  @Nullable X3DNode getCoord();

  /** Sets {@link #getCoord()}; null empties the field. */
  void setCoord(@Nullable X3DCoordinateNode value);

  /** Sets {@link #getCoord()} to an instance of a prototype. */
  void setCoord(X3DProtoInstance value);

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

  /** Whether only the front of the faces is seen. */
  boolean getSolid();

  /**
   * Sets {@link #getSolid()}. Only while the node is not {@linkplain X3DNode#realize() realized}.
   */
  void setSolid(boolean value);

  /** Whether the front is the side from which the vertices run counterclockwise. */
  boolean getCcw();

  /** Sets {@link #getCcw()}. Only while the node is not {@linkplain X3DNode#realize() realized}. */
  void setCcw(boolean value);

  /** Whether each vertex has a colour, rather than each face. */
  boolean getColorPerVertex();

  /**
   * Sets {@link #getColorPerVertex()}. Only while the node is not {@linkplain X3DNode#realize()
   * realized}.
   */
  void setColorPerVertex(boolean value);

  /** Whether each vertex has a normal, rather than each face. */
  boolean getNormalPerVertex();

  /**
   * Sets {@link #getNormalPerVertex()}. Only while the node is not {@linkplain X3DNode#realize()
   * realized}.
   */
  void setNormalPerVertex(boolean value);
}
