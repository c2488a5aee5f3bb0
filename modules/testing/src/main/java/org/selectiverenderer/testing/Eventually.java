package org.selectiverenderer.testing;

import java.util.concurrent.TimeUnit;
import java.util.function.Supplier;

/**
 * Waits for conditions that other threads, processes or the display bring about and do not signal.
 *
 * <p>A test that can be signalled uses a latch or a queue instead. This class is the only one of
 * the tests that pauses a thread, apart from {@link
 * org.selectiverenderer.testing.robot.DisplaySettling}.
 */
public final class Eventually {
  /** The longest wait in nanoseconds; a condition that holds later is taken to hold never. */
  private static final long PATIENCE = TimeUnit.SECONDS.toNanos(60);

  /** The shortest and the longest pause between two evaluations, in nanoseconds. */
  private static final long SHORTEST = TimeUnit.MILLISECONDS.toNanos(1);

  private static final long LONGEST = TimeUnit.MILLISECONDS.toNanos(50);

  /** A pause is at most this share of the time waited so far. */
  private static final int SHARE = 8;

  private Eventually() {}

  /** A condition that is evaluated until it holds. */
  @FunctionalInterface
  public interface Condition {
    /**
     * Returns whether the condition holds.
     *
     * @throws Exception if the condition cannot be evaluated, which ends the wait
     */
    boolean holds() throws Exception;
  }

  /**
   * Waits until a condition holds.
   *
   * @param what a noun phrase for the failure, for example "the first record"
   * @throws AssertionError if the condition does not hold within a minute
   */
  public static void await(String what, Condition condition) {
    await(() -> what, condition);
  }

  /**
   * Waits until a condition holds.
   *
   * @param what makes a noun phrase for the failure, at the time of the failure
   * @throws AssertionError if the condition does not hold within a minute
   */
  public static void await(Supplier<String> what, Condition condition) {
    if (!within(PATIENCE, TimeUnit.NANOSECONDS, condition)) {
      throw new AssertionError("waited in vain for " + what.get());
    }
  }

  /**
   * Waits until a condition holds or the time is over.
   *
   * @return whether the condition holds
   */
  public static boolean within(long time, TimeUnit unit, Condition condition) {
    long begin = System.nanoTime();
    try {
      while (!condition.holds()) {
        long waited = System.nanoTime() - begin;
        if (waited > unit.toNanos(time)) {
          return condition.holds();
        }
        TimeUnit.NANOSECONDS.sleep(Math.min(LONGEST, Math.max(SHORTEST, waited / SHARE)));
      }
      return true;
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new AssertionError("interrupted", e);
    } catch (RuntimeException e) {
      throw e;
    } catch (Exception e) {
      throw new AssertionError(e);
    }
  }
}
