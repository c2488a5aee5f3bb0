package org.web3d.x3d.sai;

/** A node of which one at a time is in force: the one on top of its stack (X3D 4.0, 7.2.2). */
public interface X3DBindableNode extends X3DChildNode {
  /**
   * Sets whether the node is to be on top of its stack: true puts it there, false takes it off the
   * stack.
   */
  void setBind(boolean value);

  /** The time at which the node was last bound or unbound, in seconds. */
  double getBindTime();

  /** Whether the node is on top of its stack. */
  boolean getIsBound();
}
