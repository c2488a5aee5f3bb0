package org.selectiverenderer.runtime.scene;

import java.util.Optional;
import org.selectiverenderer.base.problem.Location;
import org.selectiverenderer.base.problem.Problems;

/**
 * Calls what applications wrote: listeners. Whatever it throws is reported and ends there, so that
 * one bad listener neither silences the others nor stops the world.
 *
 * <p>That goes for an {@code Error} too: one of an assertion or of linking is the listener's own,
 * and a stack that overflowed in it is unwound. What the virtual machine throws for itself ({@code
 * OutOfMemoryError}, {@code InternalError}) passes through, since after it nothing can be relied
 * upon, least of all a report.
 */
public final class ApplicationCode {
  private ApplicationCode() {}

  /**
   * Calls code.
   *
   * @param who for the report, such as "a listener of size"
   */
  public static void call(Problems problems, Location location, String who, Runnable code) {
    try {
      code.run();
    } catch (StackOverflowError e) {
      report(problems, location, who, e);
    } catch (VirtualMachineError e) {
      throw e;
    } catch (RuntimeException | Error e) {
      report(problems, location, who, e);
    }
  }

  private static void report(Problems problems, Location location, String who, Throwable thrown) {
    problems.error(
        location,
        "%s failed and was skipped: %s"
            .formatted(
                who,
                Optional.ofNullable(thrown.getMessage())
                    .orElse(thrown.getClass().getSimpleName())));
  }
}
