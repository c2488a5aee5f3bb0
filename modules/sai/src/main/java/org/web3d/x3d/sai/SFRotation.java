package org.web3d.x3d.sai;

/** A field that holds a rotation: the axis x y z and the angle in radians (X3D 4.0, clause 5). */
public interface SFRotation extends X3DField {
  /** Puts the value into the first four elements of the array. */
  void getValue(float[] value);

  /** Sends the first four elements of the array to the field. */
  void setValue(float[] value);
}
