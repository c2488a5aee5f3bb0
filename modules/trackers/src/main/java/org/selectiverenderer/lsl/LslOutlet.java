package org.selectiverenderer.lsl;

import java.io.IOException;
import java.nio.DoubleBuffer;
import org.lwjgl.PointerBuffer;
import org.lwjgl.system.MemoryStack;
import org.lwjgl.system.MemoryUtil;

/** An outlet: sends a stream of this program. Pushing a sample does not block. */
public final class LslOutlet implements AutoCloseable {
  /** Capacity of the outlet's buffer for slow receivers in seconds. */
  private static final int BUFFERED = 360;

  /** Values of {@code lsl_channel_format_t}: cft_double64 and cft_string. */
  static final int NUMBERS = 2;

  static final int TEXTS = 3;

  private final LslBindings calls;
  private final long handle;
  private final int channels;

  private LslOutlet(LslBindings calls, long handle, int channels) {
    this.calls = calls;
    this.handle = handle;
    this.channels = channels;
  }

  static LslOutlet open(LslBindings calls, StreamInfo stream) throws IOException {
    long info = info(calls, stream);
    try {
      long handle = calls.createOutlet.call(info, 0, BUFFERED);
      if (handle == MemoryUtil.NULL) {
        throw new IOException("liblsl could not create an outlet for the stream " + stream.name());
      }
      return new LslOutlet(calls, handle, stream.channels().size());
    } finally {
      calls.destroyInfo.call(info);
    }
  }

  private static long info(LslBindings calls, StreamInfo stream) throws IOException {
    try (MemoryStack stack = MemoryStack.stackPush()) {
      long info =
          calls.createInfo.call(
              LslBindings.text(stack, stream.name()),
              LslBindings.text(stack, stream.type()),
              stream.channels().size(),
              stream.rate(),
              stream.texts() ? TEXTS : NUMBERS,
              LslBindings.text(stack, stream.sourceId()));
      if (info == MemoryUtil.NULL) {
        throw new IOException("liblsl rejects the description of the stream " + stream.name());
      }
      long channels =
          calls.appendChild.call(calls.description.call(info), LslBindings.text(stack, "channels"));
      for (StreamInfo.Channel channel : stream.channels()) {
        long node = calls.appendChild.call(channels, LslBindings.text(stack, "channel"));
        value(calls, node, "label", channel.label());
        value(calls, node, "unit", channel.unit());
        value(calls, node, "type", channel.type());
      }
      return info;
    }
  }

  private static void value(LslBindings calls, long node, String name, String value) {
    if (!value.isEmpty()) {
      try (MemoryStack stack = MemoryStack.stackPush()) {
        calls.appendValue.call(node, LslBindings.text(stack, name), LslBindings.text(stack, value));
      }
    }
  }

  /**
   * Sends a sample.
   *
   * @param time time stamp by {@link LslLibrary#clock}
   * @param values one value for each channel
   */
  public void push(double time, double... values) {
    require(values.length);
    try (MemoryStack stack = MemoryStack.stackPush()) {
      DoubleBuffer sample = stack.doubles(values);
      calls.pushDoubles.call(handle, MemoryUtil.memAddress(sample), time);
    }
  }

  /** Sends a sample of texts. */
  public void push(double time, String... values) {
    require(values.length);
    long[] texts = new long[values.length];
    try (MemoryStack stack = MemoryStack.stackPush()) {
      PointerBuffer sample = stack.mallocPointer(values.length);
      for (int i = 0; i < values.length; i++) {
        texts[i] = MemoryUtil.memAddress(MemoryUtil.memUTF8(values[i])); // may be long
        sample.put(i, texts[i]);
      }
      calls.pushTexts.call(handle, MemoryUtil.memAddress(sample), time);
    } finally {
      for (long text : texts) {
        MemoryUtil.nmemFree(text);
      }
    }
  }

  private void require(int values) {
    if (values != channels) {
      throw new IllegalArgumentException(channels + " channels, but " + values + " values");
    }
  }

  /** Ends the stream. */
  @Override
  public void close() {
    calls.destroyOutlet.call(handle);
  }
}
