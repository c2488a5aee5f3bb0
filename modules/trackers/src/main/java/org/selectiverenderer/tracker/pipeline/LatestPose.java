package org.selectiverenderer.tracker.pipeline;

import java.lang.invoke.MethodHandles;
import java.lang.invoke.VarHandle;
import org.selectiverenderer.tracker.PoseSample;

/**
 * The latest pose, written by one thread and read by any, without locks and allocations.
 *
 * <p>A sequence lock: the stamp is odd while the writer is at work, and a reader whose stamp
 * changed meanwhile reads again. The writer never waits for readers. Boehm, "Can seqlocks get along
 * with programming language memory models?", MSPC 2012.
 */
final class LatestPose {
  private static final VarHandle STAMP = stamp();

  private long stamp;
  private long number;
  private long arrival;
  private double yaw;
  private double pitch;
  private double roll;
  private boolean placed;
  private double x;
  private double y;
  private double z;

  private static VarHandle stamp() {
    try {
      return MethodHandles.lookup().findVarHandle(LatestPose.class, "stamp", long.class);
    } catch (ReflectiveOperationException e) {
      throw new ExceptionInInitializerError(e);
    }
  }

  /** Publishes a pose; called by one thread. */
  public void publish(PoseSample sample) {
    long writing = stamp + 1;
    STAMP.setOpaque(this, writing);
    VarHandle.storeStoreFence();
    number = sample.number();
    arrival = sample.arrival();
    yaw = sample.yaw();
    pitch = sample.pitch();
    roll = sample.roll();
    placed = sample.placed();
    x = sample.x();
    y = sample.y();
    z = sample.z();
    STAMP.setRelease(this, writing + 1);
  }

  /** Copies the latest pose; returns false, with {@code into} unchanged, if there is none yet. */
  public boolean read(PoseSample into) {
    while (true) {
      long before = (long) STAMP.getAcquire(this);
      if (before == 0) {
        return false;
      }
      if ((before & 1) == 0) {
        long readNumber = number;
        long readArrival = arrival;
        double readYaw = yaw;
        double readPitch = pitch;
        double readRoll = roll;
        boolean readPlaced = placed;
        double readX = x;
        double readY = y;
        double readZ = z;
        VarHandle.loadLoadFence();
        if ((long) STAMP.getOpaque(this) == before) {
          into.set(readNumber, readArrival, readYaw, readPitch, readRoll);
          into.unplace();
          if (readPlaced) {
            into.place(readX, readY, readZ);
          }
          return true;
        }
      }
      Thread.onSpinWait();
    }
  }
}
