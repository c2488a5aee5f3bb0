package org.web3d.x3d.sai;

/** A field that holds a vector of double precision, x y (X3D 4.0, clause 5). */
public interface SFVec2d extends X3DField {
  /** Puts the value into the first two elements of the array. */
  void getValue(double[] value);

  /** Sends the first two elements of the array to the field. */
  void setValue(double[] value);
}
