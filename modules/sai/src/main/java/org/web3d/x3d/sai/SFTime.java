package org.web3d.x3d.sai;

/** A field that holds a time in seconds; -1 before the first (X3D 4.0, clause 5). */
public interface SFTime extends X3DField {
  /** The value. */
  double getValue();

  /** Sends the value to the field. */
  void setValue(double value);
}
