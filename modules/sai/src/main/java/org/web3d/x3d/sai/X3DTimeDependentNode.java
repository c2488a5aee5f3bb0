package org.web3d.x3d.sai;

/**
 * A node that is active from a start time to a stop time (X3D 4.0, clause 8). Times are absolute,
 * in seconds.
 */
public interface X3DTimeDependentNode extends X3DChildNode {
  /** Whether it starts again at the end of a cycle. */
  boolean getLoop();

  /** Sets {@link #getLoop()}. */
  void setLoop(boolean value);

  /** The time at which it becomes active. */
  double getStartTime();

  /** Sets {@link #getStartTime()}. */
  void setStartTime(double value);

  /** The time at which it ceases to be active; without effect unless after the start time. */
  double getStopTime();

  /** Sets {@link #getStopTime()}. */
  void setStopTime(double value);

  /** The time at which it is paused. */
  double getPauseTime();

  /** Sets {@link #getPauseTime()}. */
  void setPauseTime(double value);

  /** The time at which it goes on after a pause. */
  double getResumeTime();

  /** Sets {@link #getResumeTime()}. */
  void setResumeTime(double value);

  /** The seconds for which it has been active and not paused. */
  double getElapsedTime();

  /** Whether it is active. */
  boolean getIsActive();

  /** Whether it is paused. */
  boolean getIsPaused();
}
