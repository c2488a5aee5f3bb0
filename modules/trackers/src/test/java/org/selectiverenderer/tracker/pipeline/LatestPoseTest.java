package org.selectiverenderer.tracker.pipeline;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.selectiverenderer.tracker.PoseSample;

class LatestPoseTest {
  @Test
  void thereIsNoneAtFirstAndTheReadersCopyStays() {
    PoseSample copy = new PoseSample();
    copy.set(7, 8, 1, 2, 3);
    assertThat(new LatestPose().read(copy)).isFalse();
    assertThat(copy.number()).isEqualTo(7);
    assertThat(copy.yaw()).isEqualTo(1);
  }

  @Test
  void aReaderNeverSeesHalfAPose() throws InterruptedException {
    LatestPose newest = new LatestPose();
    int poses = 2_000_000;
    Thread writer =
        new Thread(
            () -> {
              PoseSample sample = new PoseSample();
              for (int i = 1; i <= poses; i++) {
                double angle = i % 180;
                sample.set(i, i, angle, angle, angle);
                newest.publish(sample);
              }
            },
            "writer");
    writer.start();
    PoseSample read = new PoseSample();
    long last = 0;
    while (last < poses) {
      if (newest.read(read)) {
        boolean whole =
            read.number() == read.arrival()
                && read.yaw() == read.number() % 180
                && read.pitch() == read.yaw()
                && read.roll() == read.yaw();
        assertThat(whole).as("a whole pose").isTrue();
        assertThat(read.number() >= last).as("poses in their order").isTrue();
        last = read.number();
      }
    }
    writer.join();
  }
}
