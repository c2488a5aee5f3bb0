package org.web3d.x3d.sai.shape;

import org.web3d.x3d.sai.X3DMaterialNode;

/**
 * Colours of a surface for the lighting model (X3D 4.0, clause 12), each red green blue from 0 to
 * 1.
 */
public interface Material extends X3DMaterialNode {
  /** The part of the diffuse colour that ambient light shows, 0 to 1. */
  float getAmbientIntensity();

  /** Sets {@link #getAmbientIntensity()}. */
  void setAmbientIntensity(float value);

  /** The colour under direct light; goes into the first three elements of {@code value}. */
  void getDiffuseColor(float[] value);

  /** Sets {@link #getDiffuseColor}, three elements. */
  void setDiffuseColor(float[] value);

  /** The colour of its own glow; goes into the first three elements of {@code value}. */
  void getEmissiveColor(float[] value);

  /** Sets {@link #getEmissiveColor}, three elements. */
  void setEmissiveColor(float[] value);

  /** The sharpness of highlights, 0 to 1. */
  float getShininess();

  /** Sets {@link #getShininess()}. */
  void setShininess(float value);

  /** The colour of highlights; goes into the first three elements of {@code value}. */
  void getSpecularColor(float[] value);

  /** Sets {@link #getSpecularColor}, three elements. */
  void setSpecularColor(float[] value);

  /** The transparency, 0 to 1. */
  float getTransparency();

  /** Sets {@link #getTransparency()}. */
  void setTransparency(float value);
}
