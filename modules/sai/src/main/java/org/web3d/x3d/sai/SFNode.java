package org.web3d.x3d.sai;

import org.jspecify.annotations.Nullable;

/** A field that holds a node or nothing (X3D 4.0, clause 5). */
public interface SFNode extends X3DField {
  /** The node, or null. */
  @Nullable X3DNode getValue();

  /** Sends the node to the field; null empties it. */
  void setValue(@Nullable X3DNode value) throws InvalidNodeException;
}
