package org.web3d.x3d.sai;

/**
 * A place and direction from which the scene is seen (X3D 4.0, clause 23). The standard binding
 * lets the orientation be set but not be read here; {@link X3DNode#getField} reads it.
 */
public interface X3DViewpointNode extends X3DBindableNode {
  /** Whether binding moves the viewer to the viewpoint. */
  boolean getJump();

  /** Sets {@link #getJump()}. */
  void setJump(boolean value);

  /**
   * Sets the turn of the viewer from looking along -Z with +Y up, as axis and angle in radians;
   * four elements.
   */
  void setOrientation(float[] value);

  /** The name in the list of viewpoints; an empty one is not listed. */
  String getDescription();

  /** Sets {@link #getDescription()}. */
  void setDescription(String value);

  /** Whether the way that the viewer walked from the viewpoint is kept on binding. */
  boolean getRetainUserOffsets();

  /** Sets {@link #getRetainUserOffsets()}. */
  void setRetainUserOffsets(boolean value);
}
