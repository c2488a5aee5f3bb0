package org.web3d.x3d.sai.eventutilities;

import org.web3d.x3d.sai.X3DChildNode;

/** Keeps a value and turns it over on each true (X3D 4.0, clause 30). */
public interface BooleanToggle extends X3DChildNode {
  /** Sets off the toggle, on true. */
  void setBoolean(boolean value);

  /** The value. */
  boolean getToggle();

  /** Sets {@link #getToggle()}. */
  void setToggle(boolean value);
}
