package org.web3d.x3d.sai.eventutilities;

import org.web3d.x3d.sai.X3DTriggerNode;

/** Sends an integer for true (X3D 4.0, clause 30). */
public interface IntegerTrigger extends X3DTriggerNode {
  /** Sets off the trigger, on true. */
  void setBoolean(boolean value);

  /** The integer to send. */
  int getIntegerKey();

  /** Sets {@link #getIntegerKey()}. */
  void setIntegerKey(int value);

  /** What was sent last. */
  int getTriggerValue();
}
