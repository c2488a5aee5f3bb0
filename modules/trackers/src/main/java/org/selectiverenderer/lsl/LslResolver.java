package org.selectiverenderer.lsl;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import org.lwjgl.PointerBuffer;
import org.lwjgl.system.MemoryStack;
import org.lwjgl.system.MemoryUtil;

/**
 * A continuous resolver: looks for streams in the background. Asking for the results does not
 * block.
 */
public final class LslResolver implements AutoCloseable {
  /** Seconds after which a stream that no longer answers is forgotten. */
  private static final double FORGET = 5;

  private static final int MOST = 64;

  private final LslBindings calls;
  private final long handle;

  private LslResolver(LslBindings calls, long handle) {
    this.calls = calls;
    this.handle = handle;
  }

  static LslResolver open(LslBindings calls, String predicate) throws IOException {
    try (MemoryStack stack = MemoryStack.stackPush()) {
      long handle = calls.createResolver.call(LslBindings.text(stack, predicate), FORGET);
      if (handle == MemoryUtil.NULL) {
        throw new IOException(
            "liblsl rejects \"" + predicate + "\"; write a condition such as type='EEG'");
      }
      return new LslResolver(calls, handle);
    }
  }

  /**
   * Opens inlets for the streams that were found and are not known yet.
   *
   * @param known {@link StreamInfo#uid}s of the known streams
   * @return the inlets, which the caller closes
   */
  public List<LslInlet> found(Set<String> known) {
    List<LslInlet> inlets = new ArrayList<>();
    try (MemoryStack stack = MemoryStack.stackPush()) {
      PointerBuffer infos = stack.callocPointer(MOST);
      int count = calls.results.callInt(handle, MemoryUtil.memAddress(infos), MOST);
      for (int i = 0; i < Math.max(0, count); i++) {
        if (known.contains(LslBindings.text(calls.uid.call(infos.get(i))))) {
          calls.destroyInfo.call(infos.get(i));
        } else {
          inlets.add(new LslInlet(calls, infos.get(i)));
        }
      }
    }
    return inlets;
  }

  @Override
  public void close() {
    calls.destroyResolver.call(handle);
  }
}
