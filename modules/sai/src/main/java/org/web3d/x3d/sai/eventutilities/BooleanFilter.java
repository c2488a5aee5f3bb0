package org.web3d.x3d.sai.eventutilities;

import org.web3d.x3d.sai.X3DChildNode;

/** Tells true from false and negates (X3D 4.0, clause 30). */
public interface BooleanFilter extends X3DChildNode {
  /** Sets off the filter with this value. */
  void setBoolean(boolean value);

  /** The last false that came in, as false. */
  boolean getInputFalse();

  /** The last true that came in, as true. */
  boolean getInputTrue();

  /** The opposite of what came in last. */
  boolean getInputNegate();
}
