package org.web3d.x3d.sai.lighting;

import org.web3d.x3d.sai.X3DLightNode;

/** Light of parallel rays (X3D 4.0, clause 17). */
public interface DirectionalLight extends X3DLightNode {
  /**
   * The direction in which the light shines; goes into the first three elements of {@code value}.
   */
  void getDirection(float[] value);

  /** Sets {@link #getDirection}, three elements. */
  void setDirection(float[] value);
}
