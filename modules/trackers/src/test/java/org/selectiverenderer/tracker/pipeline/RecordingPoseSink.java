package org.selectiverenderer.tracker.pipeline;

import java.util.ArrayList;
import java.util.List;

/** Keeps what a source says, in a test. */
public final class RecordingPoseSink implements PoseSink {
  public final List<List<Double>> records = new ArrayList<>();
  public int bad;

  @Override
  public boolean closed() {
    return false;
  }

  @Override
  public void connected() {}

  @Override
  public void angles(long arrival, double yaw, double pitch, double roll) {
    records.add(List.of(yaw, pitch, roll));
  }

  @Override
  public void quaternion(long arrival, double x, double y, double z, double w) {
    records.add(List.of(x, y, z, w));
  }

  @Override
  public void bad() {
    bad++;
  }

  @Override
  public void tick() {}
}
