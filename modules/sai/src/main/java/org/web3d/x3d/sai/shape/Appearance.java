package org.web3d.x3d.sai.shape;

import org.jspecify.annotations.Nullable;
import org.web3d.x3d.sai.X3DAppearanceNode;
import org.web3d.x3d.sai.X3DMaterialNode;
import org.web3d.x3d.sai.X3DNode;
import org.web3d.x3d.sai.X3DProtoInstance;
import org.web3d.x3d.sai.X3DTextureNode;
import org.web3d.x3d.sai.X3DTextureTransformNode;

/** Material, texture and the manner of drawing (X3D 4.0, clause 12). */
public interface Appearance extends X3DAppearanceNode {
  /** The material, or null. */
  @Nullable X3DNode getMaterial();

  /** Sets {@link #getMaterial()}; null empties the field. */
  void setMaterial(@Nullable X3DMaterialNode value);

  /** Sets {@link #getMaterial()} to an instance of a prototype. */
  void setMaterial(X3DProtoInstance value);

  /** The texture, or null. */
  @Nullable X3DNode getTexture();

  /** Sets {@link #getTexture()}; null empties the field. */
  void setTexture(@Nullable X3DTextureNode value);

  /** Sets {@link #getTexture()} to an instance of a prototype. */
  void setTexture(X3DProtoInstance value);

  /** The change of texture coordinates, or null. */
  @Nullable X3DNode getTextureTransform();

  /** Sets {@link #getTextureTransform()}; null empties the field. */
  void setTextureTransform(@Nullable X3DTextureTransformNode value);

  /** Sets {@link #getTextureTransform()} to an instance of a prototype. */
  void setTextureTransform(X3DProtoInstance value);

  /** The manner of drawing lines, or null. */
  @Nullable X3DNode getLineProperties();

  /** Sets {@link #getLineProperties()}; null empties the field. */
  void setLineProperties(@Nullable X3DNode value);

  /** The manner of filling faces, or null. */
  @Nullable X3DNode getFillProperties();

  /** Sets {@link #getFillProperties()}; null empties the field. */
  void setFillProperties(@Nullable X3DNode value);
}
