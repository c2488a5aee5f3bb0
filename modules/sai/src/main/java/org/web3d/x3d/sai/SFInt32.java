package org.web3d.x3d.sai;

/** A field that holds an integer of 32 bits (X3D 4.0, clause 5). */
public interface SFInt32 extends X3DField {
  /** The value. */
  int getValue();

  /** Sends the value to the field. */
  void setValue(int value);
}
