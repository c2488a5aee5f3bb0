package org.web3d.x3d.sai;

/** A field that holds a string (X3D 4.0, clause 5). */
public interface SFString extends X3DField {
  /** The value. */
  String getValue();

  /** Sends the value to the field. */
  void setValue(String value);
}
