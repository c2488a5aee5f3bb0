package org.selectiverenderer.browser.loading;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.function.Consumer;

/**
 * Puts content that was read in the background into a running scene, in the order of arrival. Each
 * frame takes in a limited amount of work, so that no frame is delayed for long. Belongs to the
 * thread that steps the world, except for {@link #add}.
 */
final class FrameBudgetQueue {
  /**
   * Budget of work per frame, in triangles; the item that exceeds it is still taken whole. Instance
   * tree and renderer were measured to take 10 to 20 ms for this many.
   */
  static final long MOST = 20_000;

  private record Arrived(long work, Runnable arrives) {}

  private final Consumer<Runnable> post;
  private final Deque<Arrived> late = new ArrayDeque<>();
  private boolean goesOn;
  private long taken;

  /**
   * @param post runs a task on the stepping thread
   */
  FrameBudgetQueue(Consumer<Runnable> post) {
    this.post = post;
  }

  /**
   * Queues content that has been read. Thread-safe.
   *
   * @param work the cost of showing the content, in triangles
   * @param arrives the task that puts the content into the scene, run on the stepping thread
   */
  void add(long work, Runnable arrives) {
    post.accept(
        () -> {
          late.add(new Arrived(work, arrives));
          if (!goesOn) { // Else earlier items go first, in this frame.
            take();
          }
        });
  }

  /** Ends a frame; remaining items are taken up in the next one. */
  void frame() {
    taken = 0;
    if (!late.isEmpty() && !goesOn) {
      goesOn = true;
      post.accept(
          () -> {
            goesOn = false;
            take();
          });
    }
  }

  private void take() {
    while (taken < MOST && !late.isEmpty()) {
      Arrived next = late.remove();
      taken += next.work();
      next.arrives().run();
    }
  }
}
