package org.selectiverenderer.apartment.building;

import org.selectiverenderer.apartment.plan.Room;
import org.selectiverenderer.apartment.plan.WallSide;
import org.selectiverenderer.geometry.mesh.TriangleMesh;
import org.selectiverenderer.modelling.BoxBuilder;
import org.selectiverenderer.modelling.ExtrudedSolid;
import org.selectiverenderer.modelling.Lathe;
import org.selectiverenderer.modelling.MeshPatterns;
import org.selectiverenderer.modelling.ProfileCurve;
import org.selectiverenderer.modelling.RoundSolidBuilder;
import org.selectiverenderer.modelling.SimplePolygon;

/** Fixtures of a room: light switches, radiators, lamps. */
final class RoomFixtures {

  private RoomFixtures() {}

  /** Returns a light switch with its rocker tilted, 1.1 m above the floor. */
  static TriangleMesh lightSwitch(Room room, WallSide side, double along) {
    TriangleMesh plate = BoxBuilder.plain(0.085, 0.085, 0.01).move(0, -0.0425, 0.005);
    TriangleMesh rocker = BoxBuilder.plain(0.05, 0.055, 0.01).turnX(5).move(0, -0.0275, 0.01);
    return side.place(room, plate.append(rocker).move(side.across(along), 1.1, 0));
  }

  /** Returns a column radiator under a window. */
  static TriangleMesh radiator(Room room, WallSide side, double along, int columns) {
    double step = 0.06;
    TriangleMesh column = BoxBuilder.plain(0.05, 0.55, 0.09);
    TriangleMesh pipe = RoundSolidBuilder.cylinder(0.018, step * (columns - 1), 4).turnZ(90);
    double half = step * (columns - 1) / 2;
    TriangleMesh whole =
        TriangleMesh.of(
            MeshPatterns.row(column, columns, step, 0, 0).move(-half, 0, 0),
            pipe.move(half, 0.06, 0),
            pipe.move(half, 0.49, 0));
    return side.place(room, whole.move(side.across(along), 0.12, 0.08));
  }

  /** Returns the cord and the canopy of a pendant lamp, from the ceiling down. */
  static TriangleMesh cord(double x, double z, double length) {
    TriangleMesh canopy =
        RoundSolidBuilder.cone(0.012, 0.055, 0.05, 16).move(0, Room.HEIGHT - 0.05, 0);
    TriangleMesh cord =
        RoundSolidBuilder.cylinder(0.005, length, 6).move(0, Room.HEIGHT - length, 0);
    return canopy.append(cord).move(x, 0, z);
  }

  /** Returns a wide lamp shade, open below; its upper end touches the cord's end. */
  static TriangleMesh shade(double x, double z, double length, int segments) {
    ProfileCurve outside =
        ProfileCurve.from(0.2, -0.17)
            .bezier(0.19, -0.08, 0.1, -0.045, 0.028, -0.035, 5)
            .line(0.025, 0);
    ProfileCurve inside =
        ProfileCurve.from(0.022, -0.04).bezier(0.095, -0.05, 0.184, -0.085, 0.196, -0.17, 4);
    SimplePolygon section = outside.then(inside).closed();
    return Lathe.ring(section, segments).move(x, Room.HEIGHT - length, z);
  }

  static TriangleMesh bulb(double x, double z, double length) {
    ProfileCurve pear =
        ProfileCurve.from(0, -0.15).spline(2, 0.028, -0.135, 0.034, -0.11, 0.016, -0.06, 0, -0.05);
    return Lathe.solid(pear, 10).move(x, Room.HEIGHT - length, z);
  }

  /** Returns the rim of a flat ceiling lamp. */
  static TriangleMesh panelRim(double x, double z) {
    SimplePolygon outer = SimplePolygon.rectangle(1.24, 0.34);
    SimplePolygon inner = SimplePolygon.rectangle(1.18, 0.28);
    return ExtrudedSolid.plain(0.06, outer, inner).turnX(90).move(x, Room.HEIGHT, z);
  }

  /** Returns the luminous plate of a flat ceiling lamp. */
  static TriangleMesh panelLight(double x, double z) {
    return BoxBuilder.plain(1.19, 0.04, 0.29).move(x, Room.HEIGHT - 0.045, z);
  }
}
