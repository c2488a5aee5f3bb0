package org.selectiverenderer.tracker.pipeline;

import java.util.Optional;
import java.util.function.Supplier;
import org.selectiverenderer.tracker.PoseSample;
import org.selectiverenderer.tracker.TrackerHealth;
import org.selectiverenderer.tracker.TrackerHealth.State;
import org.selectiverenderer.tracker.TrackerListener;
import org.selectiverenderer.tracker.TrackerSpec;

/**
 * The tracker of a headset, which has no thread: the frame loop pushes the pose of each frame, just
 * before the frame is stepped.
 */
public final class HeadsetPoseTracker extends PublishingTracker {
  private final TrackerHealthMonitor meter = new TrackerHealthMonitor();
  private final TrackerListener listener;
  private final Supplier<String> words;
  private final PoseSample sample = new PoseSample();
  private boolean wasLost;
  private long number;
  private volatile State state = State.CONNECTING;

  /**
   * @param listener receives each pose on the thread that pushes it
   * @param words returns the status of the headset, for people
   */
  public HeadsetPoseTracker(TrackerListener listener, Supplier<String> words) {
    super(new TrackerSpec.Headset());
    this.listener = listener;
    this.words = words;
  }

  /**
   * Pushes the pose of the next frame; called by one thread at a time.
   *
   * @param pose the pose; its number and arrival are ignored
   * @param arrival {@link System#nanoTime} when the pose was requested
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

  /** Pauses until the next pose, as the headset is not worn, or was lost. */
  public void pause(boolean gone) {
    if (state == State.STREAMING) {
      meter.pause();
    }
    wasLost |= gone;
    state = gone ? State.LOST : State.SILENT;
  }

  /** Makes the heading of the next pose straight ahead. */
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
