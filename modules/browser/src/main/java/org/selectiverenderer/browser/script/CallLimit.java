package org.selectiverenderer.browser.script;

import java.lang.management.ManagementFactory;
import java.util.Locale;
import org.jspecify.annotations.Nullable;
import org.mozilla.javascript.EvaluatorException;
import org.mozilla.javascript.ScriptStackElement;

/**
 * Limits the time and memory of the script call that is running. It is checked every few thousand
 * instructions, so that a short call costs nothing.
 */
final class CallLimit {
  /**
   * A call may allocate one part in this number of the heap, so that a scene survives a script that
   * allocates too much.
   */
  private static final int SHARE = 4;

  private final long maxBytes;
  private double seconds;
  private long began;
  private long bytesBefore;
  private boolean measured;

  CallLimit() {
    this(Runtime.getRuntime().maxMemory() / SHARE);
  }

  /**
   * @param maxBytes the bytes that a call may allocate
   */
  CallLimit(long maxBytes) {
    this.maxBytes = maxBytes;
  }

  /** Begins a call. */
  void begin(double maxSeconds) {
    seconds = maxSeconds;
    began = System.nanoTime();
    measured = false;
  }

  /**
   * Checks the running call.
   *
   * @throws ScriptStoppedError if it exceeds a limit
   */
  void check() {
    if ((System.nanoTime() - began) * 1e-9 > seconds) {
      throw new ScriptStoppedError(
          String.format(Locale.ROOT, "it ran for more than %.0f s", seconds), lineNow());
    }
    long allocated = Allocation.bytes();
    if (!measured) {
      measured = true;
      bytesBefore = allocated;
    } else if (allocated - bytesBefore > maxBytes) {
      throw new ScriptStoppedError(
          "it allocated more than %s MB of memory in one call".formatted(maxBytes >> 20),
          lineNow());
    }
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
