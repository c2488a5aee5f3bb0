package org.web3d.x3d.sai;

/** A field that holds a number of double precision (X3D 4.0, clause 5). */
public interface SFDouble extends X3DField {
  /** The value. */
  double getValue();

  /** Sends the value to the field. */
  void setValue(double value);
}
