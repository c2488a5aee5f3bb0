package org.web3d.x3d.sai.lighting;

import org.web3d.x3d.sai.X3DLightNode;

/** Light from a point in a cone (X3D 4.0, clause 17). */
public interface SpotLight extends X3DLightNode {
  /**
   * The coefficients of distance to the powers 0, 1 and 2 by whose sum the light is divided; goes
   * into the first three elements of {@code value}.
   */
  void getAttenuation(float[] value);

  /** Sets {@link #getAttenuation}, three elements. */
  void setAttenuation(float[] value);

  /** The angle from the axis within which the light is at its full, in radians. */
  float getBeamWidth();

  /** Sets {@link #getBeamWidth()}. */
  void setBeamWidth(float value);

  /** The angle from the axis beyond which there is no light, in radians. */
  float getCutOffAngle();

  /** Sets {@link #getCutOffAngle()}. */
  void setCutOffAngle(float value);

  /**
   * The direction in which the light shines; goes into the first three elements of {@code value}.
   */
  void getDirection(float[] value);

  /** Sets {@link #getDirection}, three elements. */
  void setDirection(float[] value);

  /** The place in metres; goes into the first three elements of {@code value}. */
  void getLocation(float[] value);

  /** Sets {@link #getLocation}, three elements. */
  void setLocation(float[] value);

  /** The distance that the light reaches, in metres. */
  float getRadius();

  /** Sets {@link #getRadius()}. */
  void setRadius(float value);
}
