package org.web3d.x3d.sai;

/**
 * A field that holds a colour with opacity, red green blue alpha from 0 to 1 (X3D 4.0, clause 5).
 */
public interface SFColorRGBA extends X3DField {
  /** Puts the value into the first four elements of the array. */
  void getValue(float[] value);

  /** Sends the first four elements of the array to the field. */
  void setValue(float[] value);
}
