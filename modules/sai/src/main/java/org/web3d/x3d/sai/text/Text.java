package org.web3d.x3d.sai.text;

import org.jspecify.annotations.Nullable;
import org.web3d.x3d.sai.X3DFontStyleNode;
import org.web3d.x3d.sai.X3DGeometryNode;
import org.web3d.x3d.sai.X3DNode;
import org.web3d.x3d.sai.X3DProtoInstance;

/** Flat text in the XY plane (X3D 4.0, clause 15). */
public interface Text extends X3DGeometryNode {
  /** The number of elements that {@link #getString} writes. */
  int getNumString();

  /** The lines; go into the first {@link #getNumString()} elements of {@code value}. */
  void getString(String[] value);

  /** Sets {@link #getString} to all elements of {@code value}. */
  void setString(String[] value);

  /** The style, or null. */
  @Nullable X3DNode getFontStyle();

  /** Sets {@link #getFontStyle()}; null empties the field. */
  void setFontStyle(@Nullable X3DFontStyleNode value);

  /** Sets {@link #getFontStyle()} to an instance of a prototype. */
  void setFontStyle(X3DProtoInstance value);

  /** The number of elements that {@link #getLength} writes. */
  int getNumLength();

  /**
   * The widths of the lines in metres; 0 leaves a line as it is; go into the first {@link
   * #getNumLength()} elements of {@code value}.
   */
  void getLength(float[] value);

  /** Sets {@link #getLength} to all elements of {@code value}. */
  void setLength(float[] value);

  /** The width that no line exceeds, in metres; 0 for no limit. */
  float getMaxExtent();

  /** Sets {@link #getMaxExtent()}. */
  void setMaxExtent(float value);

  /** Whether only the front is seen. */
  boolean getSolid();

  /**
   * Sets {@link #getSolid()}. Only while the node is not {@linkplain X3DNode#realize() realized}.
   */
  void setSolid(boolean value);
}
