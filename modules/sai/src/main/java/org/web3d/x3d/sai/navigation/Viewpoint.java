package org.web3d.x3d.sai.navigation;

import org.web3d.x3d.sai.X3DViewpointNode;

/** A viewpoint with perspective (X3D 4.0, clause 23). */
public interface Viewpoint extends X3DViewpointNode {
  /** The angle in radians that the smaller side of the window spans. */
  float getFieldOfView();

  /** Sets {@link #getFieldOfView()}. */
  void setFieldOfView(float value);

  /**
   * The position in the coordinates of the node, in metres; goes into the first three elements of
   * {@code value}.
   */
  void getPosition(float[] value);

  /** Sets {@link #getPosition}, three elements. */
  void setPosition(float[] value);
}
