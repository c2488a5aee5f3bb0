package org.selectiverenderer.apartment.scene;

import java.util.ArrayList;
import java.util.List;
import org.selectiverenderer.apartment.plan.Room;
import org.selectiverenderer.base.decimal.DecimalFormatter;
import org.selectiverenderer.geometry.DegreeMath;

/**
 * The recorded walk: kitchen, lounge, sofa, lounge, through the kitchen to the office, desk, desk
 * and bookcase, bookcase, office. The viewer stops and looks round where there is something to see.
 */
public final class ApartmentTour {
  /** Walking speed, metres per second. */
  private static final double PACE = 1.1;

  /** Turning speed, degrees per second. */
  private static final double TURNING = 75;

  private final List<double[]> rows = new ArrayList<>();
  private double time;
  private double x;
  private double z;
  private double yaw;

  private ApartmentTour(double x, double z, double yaw) {
    this.x = x;
    this.z = z;
    this.yaw = yaw;
    mark();
  }

  /**
   * Returns the text of the path file: a header, then time, eye position and direction; seconds,
   * metres, degrees.
   */
  public static String text() {
    ApartmentTour tour =
        new ApartmentTour(Room.KITCHEN.middle(), 0.1, -60)
            .look(-100)
            .walk(-0.9, -2.3)
            .walk(-1.5, -2.72)
            .walk(-2.9, -2.72)
            .walk(-4.7, -2.55)
            .walk(-5.4, -0.9)
            .look(135)
            .look(225)
            .walk(-4.5, -2.55)
            .walk(-2.9, -2.72)
            .walk(-1.5, -2.72)
            .walk(0.3, -0.4)
            .walk(0.8, 2.3)
            .walk(1.3, 2.72)
            .walk(3.0, 2.78)
            .walk(6.0, 2.78)
            .look(-60)
            .walk(6.1, 1.2)
            .look(-90)
            .walk(4.6, 0.4)
            .look(90)
            .walk(4.4, -1.7)
            .look(90)
            .walk(6.3, -1.9)
            .look(-120);
    StringBuilder text = new StringBuilder("t,x,y,z,yaw,pitch,roll\n");
    for (double[] row : tour.rows) {
      for (int i = 0; i < row.length; i++) {
        text.append(i == 0 ? "" : ",").append(DecimalFormatter.rounded(row[i], 3));
      }
      text.append('\n');
    }
    return text.toString();
  }

  /** Turns on the spot towards the goal, then goes straight. */
  private ApartmentTour walk(double toX, double toZ) {
    double dx = toX - x;
    double dz = toZ - z;
    look(DegreeMath.atan2(-dx, -dz));
    x = toX;
    z = toZ;
    return after(Math.sqrt(dx * dx + dz * dz) / PACE);
  }

  /** Turns on the spot, the short way round. */
  private ApartmentTour look(double towards) {
    double turn = (towards - yaw) % 360;
    turn = turn > 180 ? turn - 360 : turn < -180 ? turn + 360 : turn;
    if (Math.abs(turn) < 1) {
      return this;
    }
    yaw += turn;
    return after(Math.abs(turn) / TURNING);
  }

  private ApartmentTour after(double seconds) {
    time += Math.ceil(seconds * 10) / 10;
    mark();
    return this;
  }

  private void mark() {
    rows.add(new double[] {time, x, Room.FLOOR + ApartmentSceneWriter.EYE, z, yaw, -8, 0});
  }
}
