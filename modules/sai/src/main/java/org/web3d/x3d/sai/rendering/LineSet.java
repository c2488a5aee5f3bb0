package org.web3d.x3d.sai.rendering;

import org.jspecify.annotations.Nullable;
import org.web3d.x3d.sai.X3DColorNode;
import org.web3d.x3d.sai.X3DCoordinateNode;
import org.web3d.x3d.sai.X3DGeometryNode;
import org.web3d.x3d.sai.X3DNode;
import org.web3d.x3d.sai.X3DProtoInstance;

/** Polylines over consecutive coordinates (X3D 4.0, clause 11). */
public interface LineSet extends X3DGeometryNode {
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

  /** The number of elements that {@link #getVertexCount} writes. */
  int getNumVertexCount();

  /**
   * The number of vertices of each polyline; go into the first {@link #getNumVertexCount()}
   * elements of {@code value}.
   */
  void getVertexCount(int[] value);

  /** Sets {@link #getVertexCount} to all elements of {@code value}. */
  void setVertexCount(int[] value);
}
