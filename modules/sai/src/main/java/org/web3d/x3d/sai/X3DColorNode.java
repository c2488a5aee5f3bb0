package org.web3d.x3d.sai;

/**
 * Colours for vertices or faces (X3D 4.0, clause 11): three components each in a Color node, four
 * in a ColorRGBA node.
 */
public interface X3DColorNode extends X3DGeometricPropertyNode {
  /** The number of colours that {@link #getColor} writes. */
  int getNumColor();

  /** Puts the colours one after the other into {@code value}. */
  void getColor(float[] value);

  /** Sets the colours, one after the other. */
  void setColor(float[] value);
}
