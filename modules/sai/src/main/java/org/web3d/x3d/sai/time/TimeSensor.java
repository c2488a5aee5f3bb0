package org.web3d.x3d.sai.time;

import org.web3d.x3d.sai.X3DSensorNode;
import org.web3d.x3d.sai.X3DTimeDependentNode;

/** A clock (X3D 4.0, clause 8). */
public interface TimeSensor extends X3DTimeDependentNode, X3DSensorNode {
  /** The length of a cycle in seconds. */
  double getCycleInterval();

  /** Sets {@link #getCycleInterval()}. */
  void setCycleInterval(double value);

  /** The part of the cycle that has passed, 0 to 1. */
  float getFraction();

  /** The time of the last tick, in seconds. */
  double getTime();

  /** The time at which the present cycle began, in seconds. */
  double getCycleTime();
}
