package org.selectiverenderer.runtime.nodes.sensor;

import org.jspecify.annotations.Nullable;

/**
 * A {@link FrameNode} that looks at frames only while something goes on in it. At rest it costs
 * nothing per frame.
 */
public interface Sleeper extends FrameNode {
  /** Whether it is to look at the coming frame. */
  boolean awake();

  /**
   * Says who is to be told when something begins in it.
   *
   * @param call called as soon as it is {@link #awake}; null for nobody
   */
  void wakeBy(@Nullable Runnable call);
}
