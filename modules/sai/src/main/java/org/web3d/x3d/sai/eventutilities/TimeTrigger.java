package org.web3d.x3d.sai.eventutilities;

import org.web3d.x3d.sai.X3DTriggerNode;

/** Sends the time of a boolean event (X3D 4.0, clause 30). */
public interface TimeTrigger extends X3DTriggerNode {
  /** Sets off the trigger. */
  void setBoolean(boolean value);

  /** The time that was sent last, in seconds. */
  double getTriggerTime();
}
