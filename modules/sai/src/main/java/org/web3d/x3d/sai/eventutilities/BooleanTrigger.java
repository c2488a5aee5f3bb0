package org.web3d.x3d.sai.eventutilities;

import org.web3d.x3d.sai.X3DTriggerNode;

/** Sends true for a time (X3D 4.0, clause 30). */
public interface BooleanTrigger extends X3DTriggerNode {
  /** Sets off the trigger with this time in seconds. */
  void setTriggerTime(double value);

  /** What was sent last. */
  boolean getTriggerTrue();
}
