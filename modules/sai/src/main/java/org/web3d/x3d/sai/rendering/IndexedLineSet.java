package org.web3d.x3d.sai.rendering;

import org.jspecify.annotations.Nullable;
import org.web3d.x3d.sai.X3DColorNode;
import org.web3d.x3d.sai.X3DCoordinateNode;
import org.web3d.x3d.sai.X3DGeometryNode;
import org.web3d.x3d.sai.X3DNode;
import org.web3d.x3d.sai.X3DProtoInstance;

/** Polylines over shared coordinates (X3D 4.0, clause 11). */
public interface IndexedLineSet extends X3DGeometryNode {
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

  /** Whether each vertex has a colour, rather than each polyline. */
  boolean getColorPerVertex();

  /**
   * Sets {@link #getColorPerVertex()}. Only while the node is not {@linkplain X3DNode#realize()
   * realized}.
   */
  void setColorPerVertex(boolean value);

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
   * The indices of the coordinates; -1 ends a polyline; go into the first {@link
   * #getNumCoordIndex()} elements of {@code value}.
   */
  void getCoordIndex(int[] value);

  /** Sets {@link #getCoordIndex} to all elements of {@code value}. */
  void setCoordIndex(int[] value);
}
