package org.selectiverenderer.runtime.loading;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.function.Consumer;

/**
 * Lets what was read in the background into a running scene: so much with each frame that no frame
 * waits long for it, in the order in which it came. Belongs to the thread that steps the world, but
 * for {@link #add}.
 */
final class Arrivals {
  /**
   * Work that a frame takes on, in triangles; the piece that reaches it is taken whole. What the
   * tree and the picture do for so many was measured as 10 to 20 ms.
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
  Arrivals(Consumer<Runnable> post) {
    this.post = post;
  }

  /**
   * Something was read. Thread-safe.
   *
   * @param work that it makes, in triangles
   * @param arrives puts it into the scene, on the stepping thread
   */
  void add(long work, Runnable arrives) {
    post.accept(
        () -> {
          late.add(new Arrived(work, arrives));
          if (!goesOn) { // Else what is before it goes first, in this frame.
            take();
          }
        });
  }

  /** Ends a frame: what is late goes on with the next. */
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
