package org.selectiverenderer.tracker.pipeline;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.testing.Eventually;
import org.selectiverenderer.tracker.PoseSample;
import org.selectiverenderer.tracker.RecordingTrackerListener;
import org.selectiverenderer.tracker.TrackerOptions;
import org.selectiverenderer.tracker.TrackerSpec;

class LiveTrackerTest {
  private final RecordingTrackerListener watching = new RecordingTrackerListener();

  @Test
  void anErrorOfTheDriverIsToldAndTheConnectionOpenedAgain() throws IOException {
    AtomicInteger opened = new AtomicInteger();
    PoseSource source =
        new PoseSource() {
          @Override
          public void open() {
            if (opened.incrementAndGet() == 2) {
              throw new IllegalStateException("the device is half plugged in");
            }
          }

          @Override
          public void read(PoseSink intake) {
            if (opened.get() == 1) {
              throw new IllegalStateException("of ours");
            }
            Eventually.await(
                "the end of the connection",
                () -> {
                  intake.angles(System.nanoTime(), 30, 20, 10);
                  return intake.closed();
                });
          }

          @Override
          public void close() {
            // Nothing is open.
          }
        };
    TrackerSpec spec = new TrackerSpec.Tcp("here", 1);
    try (LiveTracker tracker = LiveTracker.open(spec, source, TrackerOptions.NONE, watching)) {
      watching.problem("the tracker's driver failed, please report it");
      watching.until("a record", () -> watching.samples() > 0);
      PoseSample pose = new PoseSample();
      assertThat(tracker.read(pose)).isTrue();
      assertThat(pose.yaw()).isEqualTo(30);
    }
  }

  /** The driver of a serial port on Windows may do so when its adapter is gone. */
  @Test
  void aDriverThatNeverReturnsDoesNotKeepTheProgram() throws IOException, InterruptedException {
    CountDownLatch reading = new CountDownLatch(1);
    CountDownLatch never = new CountDownLatch(1);
    PoseSource source =
        new PoseSource() {
          @Override
          public void open() {
            // Nothing is opened.
          }

          @Override
          public void read(PoseSink intake) {
            reading.countDown();
            while (never.getCount() > 0) {
              try {
                never.await();
              } catch (InterruptedException e) {
                // A driver takes no notice of an interrupt.
              }
            }
          }

          @Override
          public void close() {
            // Nothing is open.
          }
        };
    TrackerSpec spec = new TrackerSpec.Tcp("here", 1);
    LiveTracker tracker = LiveTracker.open(spec, source, TrackerOptions.NONE, watching);
    reading.await();
    Thread closing = new Thread(tracker::close, "closing");
    closing.start();
    Eventually.await("the end of close", () -> !closing.isAlive());
    never.countDown();
  }
}
