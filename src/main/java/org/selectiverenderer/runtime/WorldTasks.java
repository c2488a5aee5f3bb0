package org.selectiverenderer.runtime;

import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.ReentrantLock;
import org.selectiverenderer.base.problem.Location;
import org.selectiverenderer.base.problem.Problems;
import org.selectiverenderer.runtime.scene.ApplicationCode;

/**
 * What other threads want of a world. One lock is held by whoever steps the world or changes it;
 * what cannot be done at once waits for the next step. Thread-safe.
 */
final class WorldTasks {
  private final Problems problems;
  private final ConcurrentLinkedQueue<Runnable> posted = new ConcurrentLinkedQueue<>();
  private final ConcurrentLinkedQueue<Runnable> deferred = new ConcurrentLinkedQueue<>();

  /** Fair, since the stepping thread would else take it again before one that waits gets it. */
  private final ReentrantLock lock = new ReentrantLock(true);

  /**
   * @param problems hears of deferred tasks that fail
   */
  WorldTasks(Problems problems) {
    this.problems = problems;
  }

  /** Leaves a task to the beginning of the next step. */
  void post(Runnable task) {
    posted.add(task);
  }

  /**
   * Runs a task while no other thread has the world.
   *
   * @see World#hold
   */
  void hold(Runnable task) {
    lock.lock();
    try {
      task.run();
    } finally {
      lock.unlock();
    }
  }

  /**
   * Runs a task, or leaves it to the next step when the world is not to be had.
   *
   * @param place of the scene, which messages name
   * @see World#execute
   */
  void execute(Runnable task, Location place) {
    if (lock.isHeldByCurrentThread()) {
      task.run();
    } else if (lockWithinASecond()) {
      try {
        runDeferred(place);
        task.run();
      } finally {
        lock.unlock();
      }
    } else {
      deferred.add(task);
    }
  }

  private boolean lockWithinASecond() {
    try {
      return lock.tryLock() || lock.tryLock(1, TimeUnit.SECONDS);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      return false;
    }
  }

  /** Tasks whose callers are gone: what they throw can only be reported. */
  void runDeferred(Location place) {
    for (Runnable task = deferred.poll(); task != null; task = deferred.poll()) {
      ApplicationCode.call(problems, place, "a change of the scene", task);
    }
  }

  /** Those of this moment; what they post in turn waits for the next step. */
  void runPosted() {
    for (int open = posted.size(); open > 0; open--) {
      Runnable task = posted.poll();
      if (task != null) {
        task.run();
      }
    }
  }
}
