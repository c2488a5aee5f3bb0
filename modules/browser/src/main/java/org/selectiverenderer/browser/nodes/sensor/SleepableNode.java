package org.selectiverenderer.browser.nodes.sensor;

import org.jspecify.annotations.Nullable;

/**
 * A {@link FrameDrivenNode} that is updated only while it has something to do. Asleep it costs
 * nothing per frame.
 */
public interface SleepableNode extends FrameDrivenNode {
  /** Returns whether the node is to be updated in the coming frame. */
  boolean awake();

  /**
   * Sets the callback for when the node wakes up.
   *
   * @param call called as soon as the node is {@link #awake}; null for none
   */
  void wakeBy(@Nullable Runnable call);
}
