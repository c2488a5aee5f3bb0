package org.web3d.x3d.sai.core;

import org.web3d.x3d.sai.X3DMetadataObject;
import org.web3d.x3d.sai.X3DNode;

/**
 * Metadata whose value is any number of metadata nodes (X3D 4.0, clause 7); {@link
 * org.web3d.x3d.sai.X3DNode} is only the type of the array.
 */
public interface MetadataSet extends X3DNode, X3DMetadataObject {
  /** The number of nodes that {@link #getValue} writes. */
  int getNumValue();

  /** The metadata nodes; go into the first {@link #getNumValue()} elements of {@code value}. */
  void getValue(X3DNode[] value);

  /** Sets {@link #getValue} to all elements of {@code value}. */
  void setValue(X3DNode[] value);
}
