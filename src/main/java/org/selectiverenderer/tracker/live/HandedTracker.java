package org.selectiverenderer.tracker.live;

import java.util.Optional;
import java.util.function.Supplier;
import org.selectiverenderer.tracker.PoseSample;
import org.selectiverenderer.tracker.TrackerHealth;
import org.selectiverenderer.tracker.TrackerHealth.State;
import org.selectiverenderer.tracker.TrackerListener;
import org.selectiverenderer.tracker.TrackerSpec;

/**
 * A tracker without a thread: whoever draws the frames of a headset hands it the pose of each, just
 * before the frame is stepped.
 */
public final class HandedTracker extends PublishingTracker {
  private final HealthMeter meter = new HealthMeter();
  private final TrackerListener listener;
  private final Supplier<String> words;
  private final PoseSample sample = new PoseSample();
  private boolean wasLost;
  private long number;
  private volatile State state = State.CONNECTING;

  /**
   * @param listener hears of each pose; its thread is the one that hands it
   * @param words how the headset does, for people
   */
  public HandedTracker(TrackerListener listener, Supplier<String> words) {
    super(new TrackerSpec.Headset());
    this.listener = listener;
    this.words = words;
  }

  /**
   * The pose of the next frame; one thread at a time.
   *
   * @param pose its number and arrival are not looked at
   * @param arrival {@link System#nanoTime} when it was asked for
   */
  public void hand(PoseSample pose, long arrival) {
    sample.set(pose);
    sample.set(++number, arrival, pose.yaw(), pose.pitch(), pose.roll());
    publish(sample);
    meter.good(arrival);
    if (wasLost) {
      meter.reconnected();
      wasLost = false;
    }
    state = State.STREAMING;
    listener.sample(sample);
  }

  /** Nobody wears it, or it has gone: there are no poses until the next one. */
  public void pause(boolean gone) {
    if (state == State.STREAMING) {
      meter.pause();
    }
    wasLost |= gone;
    state = gone ? State.LOST : State.SILENT;
  }

  /** Where the head looks in the next pose is straight ahead. */
  public void straighten() {
    straightenNext();
  }

  @Override
  public boolean placed() {
    return true;
  }

  @Override
  public TrackerHealth health() {
    return meter.health(state, System.nanoTime());
  }

  @Override
  public Optional<String> described() {
    return Optional.of(words.get());
  }

  @Override
  public void close() {
    state = State.CLOSED;
  }
}
