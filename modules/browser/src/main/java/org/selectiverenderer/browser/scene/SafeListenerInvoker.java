package org.selectiverenderer.browser.scene;

import java.util.Optional;
import java.util.function.Supplier;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.base.problem.SourceLocation;

/**
 * Calls code of applications, such as listeners. Exceptions are caught and reported, so that a
 * faulty listener neither prevents the others from being called nor stops the world.
 *
 * <p>This includes errors: an assertion or linkage error is the listener's own fault, and after a
 * stack overflow in the listener the stack is unwound. Other errors of the virtual machine ({@code
 * OutOfMemoryError}, {@code InternalError}) pass through, since after them nothing works reliably,
 * least of all reporting.
 */
public final class SafeListenerInvoker {
  private SafeListenerInvoker() {}

  /**
   * Calls code.
   *
   * @param who the name of the code in the report, such as "a listener of size"
   */
  public static void call(
      ProblemCollector problems, SourceLocation location, String who, Runnable code) {
    call(problems, location, () -> who, code);
  }

  /**
   * Calls code.
   *
   * @param who returns the name of the code in the report, of which there are many and few reports
   */
  public static void call(
      ProblemCollector problems, SourceLocation location, Supplier<String> who, Runnable code) {
    try {
      code.run();
    } catch (StackOverflowError e) {
      report(problems, location, who.get(), e);
    } catch (VirtualMachineError e) {
      throw e;
    } catch (RuntimeException | Error e) {
      report(problems, location, who.get(), e);
    }
  }

  private static void report(
      ProblemCollector problems, SourceLocation location, String who, Throwable thrown) {
    problems.error(
        location,
        "%s failed and was skipped: %s"
            .formatted(
                who,
                Optional.ofNullable(thrown.getMessage())
                    .orElse(thrown.getClass().getSimpleName())));
  }
}
