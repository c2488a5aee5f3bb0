package org.web3d.x3d.sai.grouping;

import org.web3d.x3d.sai.X3DGroupingNode;

/** Children of which at most one is shown (X3D 4.0, clause 10). */
public interface Switch extends X3DGroupingNode {
  /** The index of the child that is shown; none is when there is no such child, as with -1. */
  int getWhichChoice();

  /** Sets {@link #getWhichChoice()}. */
  void setWhichChoice(int value);
}
