package org.selectiverenderer.lsl;

import java.nio.DoubleBuffer;
import java.nio.IntBuffer;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.lwjgl.PointerBuffer;
import org.lwjgl.system.MemoryStack;
import org.lwjgl.system.MemoryUtil;

/**
 * An inlet: receives a stream of another program. The library reconnects when a lost program
 * returns.
 */
public final class LslInlet implements AutoCloseable {
  /** Capacity of the inlet's buffer in seconds. */
  private static final int BUFFERED = 360;

  private final LslBindings calls;
  private final long info;
  private final long handle;
  private final int channels;
  private final boolean texts;

  /**
   * A sample of a stream.
   *
   * @param time time stamp by the sender's clock; see {@link Offset}
   * @param values the values of the channels; numbers as texts
   */
  public record Sample(double time, List<String> values) {
    public Sample {
      values = List.copyOf(values);
    }
  }

  /**
   * A time correction: the offset to be added to the sender's time stamps to get times of {@link
   * LslLibrary#clock}.
   *
   * @param remote the sender's clock at the time of the measurement
   * @param seconds the offset
   * @param uncertainty maximum error in seconds: the round-trip time of the measurement
   */
  public record Offset(double remote, double seconds, double uncertainty) {}

  LslInlet(LslBindings calls, long info) {
    this.calls = calls;
    this.info = info;
    channels = calls.channels.callInt(info);
    texts = calls.format.callInt(info) == LslOutlet.TEXTS;
    handle = calls.createInlet.call(info, BUFFERED, 0, 1);
  }

  /**
   * Returns the description of the stream.
   *
   * @param timeout seconds to wait for the labels of the channels, which are numbered otherwise
   */
  public StreamInfo description(double timeout) {
    List<StreamInfo.Channel> named = named(timeout);
    List<StreamInfo.Channel> all = new ArrayList<>();
    for (int i = 0; i < channels; i++) {
      StreamInfo.Channel channel =
          i < named.size() ? named.get(i) : new StreamInfo.Channel("", "", "");
      all.add(
          channel.label().isEmpty()
              ? new StreamInfo.Channel("channel" + (i + 1), channel.unit(), channel.type())
              : channel);
    }
    return new StreamInfo(
        LslBindings.text(calls.name.call(info)),
        LslBindings.text(calls.type.call(info)),
        all,
        calls.rate.callDouble(info),
        texts,
        LslBindings.text(calls.sourceId.call(info)),
        LslBindings.text(calls.host.call(info)),
        LslBindings.text(calls.uid.call(info)));
  }

  private List<StreamInfo.Channel> named(double timeout) {
    List<StreamInfo.Channel> found = new ArrayList<>();
    try (MemoryStack stack = MemoryStack.stackPush()) {
      IntBuffer failed = stack.callocInt(1);
      long full = calls.fullInfo.call(handle, timeout, MemoryUtil.memAddress(failed));
      if (full == MemoryUtil.NULL) {
        return found;
      }
      long channel =
          calls.child.call(
              calls.child.call(calls.description.call(full), LslBindings.text(stack, "channels")),
              LslBindings.text(stack, "channel"));
      while (found.size() < channels) {
        String label = value(channel, "label");
        String unit = value(channel, "unit");
        String type = value(channel, "type");
        if (label.isEmpty() && unit.isEmpty() && type.isEmpty()) {
          break; // liblsl returns an empty node after the last channel.
        }
        found.add(new StreamInfo.Channel(label, unit, type));
        channel = calls.nextSibling.call(channel, LslBindings.text(stack, "channel"));
      }
      calls.destroyInfo.call(full);
    }
    return found;
  }

  private String value(long node, String name) {
    try (MemoryStack stack = MemoryStack.stackPush()) {
      return LslBindings.text(calls.childValue.call(node, LslBindings.text(stack, name)));
    }
  }

  /**
   * Returns the next sample that has arrived, without waiting. The first call connects to the
   * sender.
   */
  public Optional<Sample> pull() {
    try (MemoryStack stack = MemoryStack.stackPush()) {
      IntBuffer failed = stack.callocInt(1);
      return texts ? texts(stack, failed) : numbers(stack, failed);
    }
  }

  private Optional<Sample> numbers(MemoryStack stack, IntBuffer failed) {
    DoubleBuffer sample = MemoryUtil.memAllocDouble(channels); // EEG has hundreds
    try {
      double time =
          calls.pullDoubles.callDouble(
              handle, MemoryUtil.memAddress(sample), channels, 0.0, MemoryUtil.memAddress(failed));
      if (time == 0) {
        return Optional.empty();
      }
      List<String> values = new ArrayList<>();
      for (int i = 0; i < channels; i++) {
        values.add(number(sample.get(i)));
      }
      return Optional.of(new Sample(time, values));
    } finally {
      MemoryUtil.memFree(sample);
    }
  }

  /** Formats a number at full precision; a whole number without a decimal point. */
  private static String number(double value) {
    return value == Math.rint(value) && Math.abs(value) < 1e15
        ? Long.toString((long) value)
        : Double.toString(value);
  }

  private Optional<Sample> texts(MemoryStack stack, IntBuffer failed) {
    PointerBuffer sample = stack.callocPointer(channels);
    double time =
        calls.pullTexts.callDouble(
            handle, MemoryUtil.memAddress(sample), channels, 0.0, MemoryUtil.memAddress(failed));
    if (time == 0) {
      return Optional.empty();
    }
    List<String> values = new ArrayList<>();
    for (int i = 0; i < channels; i++) {
      values.add(LslBindings.text(sample.get(i)));
      calls.destroyText.call(sample.get(i));
    }
    return Optional.of(new Sample(time, values));
  }

  /**
   * Returns the latest time correction; empty until there is one. The first call starts the
   * measurement, which takes a second or two and continues in the background.
   *
   * @param timeout seconds to wait for a measurement
   */
  public Optional<Offset> offset(double timeout) {
    try (MemoryStack stack = MemoryStack.stackPush()) {
      IntBuffer failed = stack.callocInt(1);
      DoubleBuffer remote = stack.callocDouble(1);
      DoubleBuffer uncertainty = stack.callocDouble(1);
      double seconds =
          calls.correction.callDouble(
              handle,
              MemoryUtil.memAddress(remote),
              MemoryUtil.memAddress(uncertainty),
              timeout,
              MemoryUtil.memAddress(failed));
      return failed.get(0) == 0
          ? Optional.of(new Offset(remote.get(0), seconds, uncertainty.get(0)))
          : Optional.empty();
    }
  }

  @Override
  public void close() {
    calls.destroyInlet.call(handle);
    calls.destroyInfo.call(info);
  }
}
