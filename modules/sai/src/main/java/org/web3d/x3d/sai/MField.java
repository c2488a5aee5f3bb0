package org.web3d.x3d.sai;

/** A field that holds any number of values (X3D 4.0, clause 5). */
public interface MField extends X3DField {
  /** The number of values; of tuples where a value is a tuple. */
  int getSize();
}
