package org.selectiverenderer.browser;

import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.ReentrantLock;
import java.util.function.Supplier;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.browser.scene.SafeListenerInvoker;

/**
 * The tasks that other threads post to a world. One lock is held by the thread that steps or
 * changes the world; a task that cannot run at once waits for the next step. Thread-safe.
 */
final class WorldTaskQueue {
  private final ProblemCollector problems;
  private final ConcurrentLinkedQueue<Runnable> posted = new ConcurrentLinkedQueue<>();
  private final ConcurrentLinkedQueue<Runnable> deferred = new ConcurrentLinkedQueue<>();

  /**
   * A fair lock, because otherwise the stepping thread would take the lock again before a waiting
   * thread gets it.
   */
  private final ReentrantLock lock = new ReentrantLock(true);

  /**
   * @param problems receives the failures of deferred tasks
   */
  WorldTaskQueue(ProblemCollector problems) {
    this.problems = problems;
  }

  /** Queues a task for the beginning of the next step. */
  void post(Runnable task) {
    posted.add(task);
  }

  /**
   * Runs a task while no other thread changes the world.
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
   * Runs a task, or defers it to the next step if the lock cannot be had within a second.
   *
   * @param place returns the location of the scene, for messages
   * @see World#execute
   */
  void execute(Runnable task, Supplier<SourceLocation> place) {
    if (lock.isHeldByCurrentThread()) {
      task.run();
    } else if (lockWithinASecond()) {
      try {
        runDeferred(place.get());
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

  /**
   * Runs the deferred tasks; since their callers no longer wait, exceptions are reported as
   * problems.
   */
  void runDeferred(SourceLocation place) {
    for (Runnable task = deferred.poll(); task != null; task = deferred.poll()) {
      SafeListenerInvoker.call(problems, place, "a change of the scene", task);
    }
  }

  /** Runs the tasks posted so far; tasks that these post in turn wait for the next step. */
  void runPosted() {
    for (int open = posted.size(); open > 0; open--) {
      Runnable task = posted.poll();
      if (task != null) {
        task.run();
      }
    }
  }
}
