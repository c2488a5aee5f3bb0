package org.web3d.x3d.sai;

/** A field that holds a colour, red green blue from 0 to 1 (X3D 4.0, clause 5). */
public interface SFColor extends X3DField {
  /** Puts the value into the first three elements of the array. */
  void getValue(float[] value);

  /** Sends the first three elements of the array to the field. */
  void setValue(float[] value);
}
