package org.web3d.x3d.sai.core;

import org.web3d.x3d.sai.X3DMetadataObject;
import org.web3d.x3d.sai.X3DNode;

/** Metadata whose value is any number of numbers of double precision (X3D 4.0, clause 7). */
public interface MetadataDouble extends X3DNode, X3DMetadataObject {
  /** The number of elements that {@link #getValue} writes. */
  int getNumValue();

  /**
   * The elements of the value; go into the first {@link #getNumValue()} elements of {@code value}.
   */
  void getValue(double[] value);

  /** Sets {@link #getValue} to all elements of {@code value}. */
  void setValue(double[] value);
}
