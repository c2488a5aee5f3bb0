package org.selectiverenderer.app.operator;

import java.util.List;
import org.joml.Vector3d;
import org.selectiverenderer.apparatus.FieldOfView;
import org.selectiverenderer.browser.camera.Primitive2D;
import org.selectiverenderer.browser.viewer.Viewer;
import org.selectiverenderer.study.headlog.SceneMap;

/**
 * A map of the rooms and areas from above, north (-Z) up, with the viewer and the field of view.
 *
 * @param left left edge of the map in pixels
 * @param top top edge of the map in pixels
 */
record AreaMap(SceneMap map, double left, double top, double width, double height) {
  private static final int ROOM = 0xff5a626b;
  private static final int ROOM_NAME = 0xffb8c0c8;
  private static final int AREA = 0xff6ea8fe;
  private static final int ENTERED = 0xffffc857;
  private static final int SIGHT = 0x40ffffff;
  private static final double VIEWER = 7;

  /** The length of the drawn field of view in units of the world. */
  private static final double REACH = 2.5;

  /** The transformation from x and z of the world to pixels. */
  private record Scale(double x, double z, double pixels, double left, double top) {
    double right(double worldX) {
      return left + (worldX - x) * pixels;
    }

    double down(double worldZ) {
      return top + (worldZ - z) * pixels;
    }
  }

  /**
   * Draws the map.
   *
   * @param seen the field of view of both eyes together
   */
  void draw(Viewer viewer, FieldOfView seen, List<String> entered, List<Primitive2D> marks) {
    marks.add(Primitive2D.rectangle(left, top, width, height, 0xff1c1f23));
    MapLabelPlacement labels = new MapLabelPlacement(left + width, top + height);
    Scale scale = scale(viewer);
    for (SceneMap.Box room : map.rooms()) {
      double[] b = room.bounds();
      outline(
          scale,
          List.of(
              new double[] {b[0], b[2]},
              new double[] {b[3], b[2]},
              new double[] {b[3], b[5]},
              new double[] {b[0], b[5]}),
          ROOM,
          2,
          marks);
      labels.add(room.name(), scale.right(b[0]) + 3, scale.down(b[5]) - 18, ROOM_NAME);
    }
    for (SceneMap.Area area : map.areas()) {
      boolean inside = entered.contains(area.name());
      int color = inside ? ENTERED : AREA;
      double[] corners = new double[2 * area.outline().size()];
      for (int i = 0; i < area.outline().size(); i++) {
        corners[2 * i] = scale.right(area.outline().get(i)[0]);
        corners[2 * i + 1] = scale.down(area.outline().get(i)[1]);
      }
      marks.add(
          new Primitive2D.Area(corners, color & 0xffffff | (inside ? 0x50000000 : 0x20000000)));
      outline(scale, area.outline(), color, 1.5, marks);
      double[] at = area.outline().get(0);
      labels.add(area.name(), scale.right(at[0]) + 3, scale.down(at[1]) + 3, color);
    }
    labels.draw(marks);
    viewer(scale, viewer, seen, marks);
  }

  private Scale scale(Viewer viewer) {
    double minX = viewer.position().x() - 1;
    double maxX = viewer.position().x() + 1;
    double minZ = viewer.position().z() - 1;
    double maxZ = viewer.position().z() + 1;
    for (SceneMap.Box room : map.rooms()) {
      minX = Math.min(minX, room.bounds()[0]);
      maxX = Math.max(maxX, room.bounds()[3]);
      minZ = Math.min(minZ, room.bounds()[2]);
      maxZ = Math.max(maxZ, room.bounds()[5]);
    }
    double pixels = Math.min((width - 20) / (maxX - minX), (height - 20) / (maxZ - minZ));
    return new Scale(
        (minX + maxX) / 2, (minZ + maxZ) / 2, pixels, left + width / 2, top + height / 2);
  }

  private static void outline(
      Scale scale, List<double[]> corners, int color, double width, List<Primitive2D> marks) {
    for (int i = 0; i < corners.size(); i++) {
      double[] a = corners.get(i);
      double[] b = corners.get((i + 1) % corners.size());
      marks.add(
          new Primitive2D.Line(
              scale.right(a[0]),
              scale.down(a[1]),
              scale.right(b[0]),
              scale.down(b[1]),
              width,
              color));
    }
  }

  private static void viewer(
      Scale scale, Viewer viewer, FieldOfView seen, List<Primitive2D> marks) {
    Vector3d ahead = viewer.orientation().transform(new Vector3d(0, 0, -1));
    double heading = Math.atan2(ahead.x, -ahead.z);
    double half = Math.atan(seen.x());
    double x = scale.right(viewer.position().x());
    double y = scale.down(viewer.position().z());
    double reach = REACH * scale.pixels();
    marks.add(
        new Primitive2D.Area(
            new double[] {
              x,
              y,
              x + reach * Math.sin(heading - half),
              y - reach * Math.cos(heading - half),
              x + reach * Math.sin(heading + half),
              y - reach * Math.cos(heading + half)
            },
            SIGHT));
    double sin = Math.sin(heading) * VIEWER;
    double cos = Math.cos(heading) * VIEWER;
    marks.add(
        new Primitive2D.Area(
            new double[] {
              x + 1.6 * sin,
              y - 1.6 * cos,
              x + cos - sin,
              y + sin + cos,
              x - cos - sin,
              y - sin + cos
            },
            OperatorConsole.ALARM));
  }
}
