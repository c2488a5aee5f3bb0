package org.web3d.x3d.sai;

import org.jspecify.annotations.Nullable;

/** Geometry with its appearance (X3D 4.0, clause 12). */
public interface X3DShapeNode extends X3DChildNode, X3DBoundedObject {
  /** The appearance, or null. */
  @Nullable X3DNode getAppearance();

  /** Sets {@link #getAppearance()}; null empties the field. */
  void setAppearance(@Nullable X3DAppearanceNode value);

  /** Sets {@link #getAppearance()} to an instance of a prototype. */
  void setAppearance(X3DProtoInstance value);

  /** The geometry, or null. */
  @Nullable X3DNode getGeometry();

  /** Sets {@link #getGeometry()}; null empties the field. */
  void setGeometry(@Nullable X3DGeometryNode value);

  /** Sets {@link #getGeometry()} to an instance of a prototype. */
  void setGeometry(X3DProtoInstance value);
}
