package org.web3d.x3d.sai;

/** A source of light (X3D 4.0, clause 17). */
public interface X3DLightNode extends X3DChildNode {
  /** The part of the light that reaches all sides, 0 to 1. */
  float getAmbientIntensity();

  /** Sets {@link #getAmbientIntensity()}. */
  void setAmbientIntensity(float value);

  /**
   * The colour, red green blue from 0 to 1; goes into the first three elements of {@code value}.
   */
  void getColor(float[] value);

  /** Sets {@link #getColor}, three elements. */
  void setColor(float[] value);

  /** The brightness of the direct light. */
  float getIntensity();

  /** Sets {@link #getIntensity()}. */
  void setIntensity(float value);

  /** Whether the light is on. */
  boolean getOn();

  /** Sets {@link #getOn()}. */
  void setOn(boolean value);

  /**
   * Whether it lights the whole scene instead of the siblings of the node and what is below them.
   */
  boolean getGlobal();

  /** Sets {@link #getGlobal()}. */
  void setGlobal(boolean value);
}
