package org.web3d.x3d.sai.lighting;

import org.web3d.x3d.sai.X3DLightNode;

/** Light from a point in all directions (X3D 4.0, clause 17). */
public interface PointLight extends X3DLightNode {
  /**
   * The coefficients of distance to the powers 0, 1 and 2 by whose sum the light is divided; goes
   * into the first three elements of {@code value}.
   */
  void getAttenuation(float[] value);

  /** Sets {@link #getAttenuation}, three elements. */
  void setAttenuation(float[] value);

  /** The place in metres; goes into the first three elements of {@code value}. */
  void getLocation(float[] value);

  /** Sets {@link #getLocation}, three elements. */
  void setLocation(float[] value);

  /** The distance that the light reaches, in metres. */
  float getRadius();

  /** Sets {@link #getRadius()}. */
  void setRadius(float value);
}
