package org.web3d.x3d.sai;

/** A field that holds a boolean (X3D 4.0, clause 5). */
public interface SFBool extends X3DField {
  /** The value. */
  boolean getValue();

  /** Sends the value to the field. */
  void setValue(boolean value);
}
