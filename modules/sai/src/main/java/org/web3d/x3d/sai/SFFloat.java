package org.web3d.x3d.sai;

/** A field that holds a number of single precision (X3D 4.0, clause 5). */
public interface SFFloat extends X3DField {
  /** The value. */
  float getValue();

  /** Sends the value to the field. */
  void setValue(float value);
}
