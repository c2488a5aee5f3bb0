package org.selectiverenderer.browser.script;

import java.lang.management.ManagementFactory;
import java.util.Locale;
import java.util.function.LongSupplier;
import org.jspecify.annotations.Nullable;
import org.mozilla.javascript.EvaluatorException;
import org.mozilla.javascript.ScriptRuntime;
import org.mozilla.javascript.ScriptStackElement;

/**
 * Limits the time and memory of the script call that is running. It is checked every few thousand
 * instructions or rounds of loops, so that a short call costs nothing.
 */
final class CallLimit {
  /** The largest text or array in bytes, at two bytes for a character and eight for an element. */
  static final int MAX_BYTES_AT_ONCE = 1 << 26;

  private final long maxBytes;
  private final LongSupplier clock;
  private double seconds;
  private long began;
  private long bytesBefore;
  private boolean measured;
  private @Nullable ScriptStoppedError exceeded;

  /**
   * @param maxBytes the bytes that a call may allocate
   * @param clock the clock that measures calls, in nanoseconds
   */
  CallLimit(long maxBytes, LongSupplier clock) {
    this.maxBytes = maxBytes;
    this.clock = clock;
  }

  /** Begins a call. */
  void begin(double maxSeconds) {
    seconds = maxSeconds;
    began = clock.getAsLong();
    measured = false;
    exceeded = null;
  }

  /**
   * Ends a call.
   *
   * @throws ScriptStoppedError if it has exceeded a limit, even when something has caught that
   */
  void end() {
    if (exceeded != null) {
      throw exceeded;
    }
  }

  /**
   * Checks the running call. Once it has exceeded a limit, each further check throws.
   *
   * @param bytes the memory that is about to be allocated
   * @throws ScriptStoppedError if it exceeds a limit
   */
  void check(long bytes) {
    if (exceeded != null) {
      throw exceeded;
    }
    if ((clock.getAsLong() - began) * 1e-9 > seconds) {
      stop(
          "it ran for more than %s s"
              .formatted(
                  seconds == Math.rint(seconds)
                      ? String.format(Locale.ROOT, "%.0f", seconds)
                      : Double.toString(seconds)));
    }
    long allocated = Allocation.bytes();
    if (!measured) {
      measured = true;
      bytesBefore = allocated;
    }
    if (bytes > MAX_BYTES_AT_ONCE) {
      throw ScriptRuntime.rangeError(
          "a text or an array in a Script has at most %s MB".formatted(MAX_BYTES_AT_ONCE >> 20));
    }
    if (allocated - bytesBefore + bytes > maxBytes) {
      stop("it allocated more than %s MB of memory in one call".formatted(maxBytes >> 20));
    }
  }

  private void stop(String reason) {
    exceeded = new ScriptStoppedError(reason, lineNow());
    throw exceeded;
  }

  private static int lineNow() {
    ScriptStackElement[] stack = new EvaluatorException("stopped").getScriptStack();
    return stack.length == 0 ? 0 : stack[0].lineNumber;
  }

  /** The bytes that the thread has allocated, where the virtual machine counts them. */
  private static final class Allocation {
    private static final com.sun.management.@Nullable ThreadMXBean COUNTER = counter();

    private static com.sun.management.@Nullable ThreadMXBean counter() {
      return ManagementFactory.getThreadMXBean() instanceof com.sun.management.ThreadMXBean bean
              && bean.isThreadAllocatedMemorySupported()
              && bean.isThreadAllocatedMemoryEnabled()
          ? bean
          : null;
    }

    static long bytes() {
      return COUNTER == null ? 0 : COUNTER.getThreadAllocatedBytes(Thread.currentThread().getId());
    }
  }
}
