package org.selectiverenderer.study.gaze;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.joml.Quaterniond;
import org.joml.Vector3d;
import org.selectiverenderer.study.headlog.HeadLog;
import org.selectiverenderer.study.headlog.HeadLogMetadata;
import org.selectiverenderer.study.headlog.HeadSample;
import org.selectiverenderer.study.headlog.SceneMap;
import org.selectiverenderer.study.headlog.SceneMap.Box;

/**
 * Tells which objects are in view in a sample of a log, and how large they appear, by the boxes of
 * the log's description. An object is in view while its centre is in the field of view of a head in
 * the same room, and whenever it is looked at or near the middle of the view. What hides it is not
 * known.
 */
final class ViewingGeometry {
  private final HeadLogMetadata shown;
  private final Map<String, Box> boxes = new LinkedHashMap<>();
  private final Map<String, String> rooms = new LinkedHashMap<>();
  private final Quaterniond turn = new Quaterniond();
  private final Vector3d local = new Vector3d();

  ViewingGeometry(HeadLog log) {
    shown = log.description();
    SceneMap map = shown.map();
    for (Box box : map.objects()) {
      boxes.putIfAbsent(box.name(), box);
      rooms.putIfAbsent(box.name(), map.roomOf(box));
    }
  }

  /** Returns whether the places of objects are known. */
  boolean known() {
    return !boxes.isEmpty();
  }

  /** Returns whether a name is that of an object rather than of a wall, a floor or a room. */
  boolean isObject(String name) {
    return !name.isEmpty() && (!known() || boxes.containsKey(name));
  }

  /**
   * Returns the solid angle of each object in view, in steradians; 1 where places are not known.
   */
  Map<String, Double> inView(HeadSample sample, String looked) {
    Map<String, Double> seen = new LinkedHashMap<>();
    if (!known()) {
      sample.cone().forEach(name -> seen.put(name, 1.0));
      if (!looked.isEmpty()) {
        seen.put(looked, 1.0);
      }
      return seen;
    }
    turn.rotationYXZ(
            Math.toRadians(sample.yaw()),
            Math.toRadians(sample.pitch()),
            Math.toRadians(sample.roll()))
        .conjugate();
    String room = room(sample);
    boxes.forEach(
        (name, box) -> {
          if (name.equals(looked)
              || sample.cone().contains(name)
              || together(room, rooms.getOrDefault(name, "")) && inFieldOfView(box, sample)) {
            seen.put(name, solidAngle(box.bounds(), sample.x(), sample.y(), sample.z()));
          }
        });
    return seen;
  }

  private String room(HeadSample sample) {
    List<Box> all = shown.map().rooms();
    return all.stream()
        .filter(room -> room.contains(sample.x(), sample.y(), sample.z()))
        .map(Box::name)
        .findFirst()
        .orElse("");
  }

  private static boolean together(String head, String object) {
    return head.isEmpty() || object.isEmpty() || head.equals(object);
  }

  private boolean inFieldOfView(Box box, HeadSample sample) {
    double[] b = box.bounds();
    local.set((b[0] + b[3]) / 2, (b[1] + b[4]) / 2, (b[2] + b[5]) / 2);
    turn.transform(local.sub(sample.x(), sample.y(), sample.z()));
    return local.z < 0
        && Math.abs(local.x) <= -local.z * shown.tanX()
        && Math.abs(local.y) <= -local.z * shown.tanY();
  }

  /**
   * Returns the solid angle of a box from a point in steradians: that of a disc about its centre of
   * the area that it projects in this direction, 2 pi (1 - d / sqrt(d^2 + area / pi)). From within
   * the box it is that of half of all directions.
   *
   * @param b min x, y, z, max x, y, z
   */
  static double solidAngle(double[] b, double x, double y, double z) {
    double dx = Math.abs((b[0] + b[3]) / 2 - x);
    double dy = Math.abs((b[1] + b[4]) / 2 - y);
    double dz = Math.abs((b[2] + b[5]) / 2 - z);
    double distance = Math.sqrt(dx * dx + dy * dy + dz * dz);
    if (distance == 0) {
      return 2 * Math.PI;
    }
    double width = b[3] - b[0];
    double height = b[4] - b[1];
    double depth = b[5] - b[2];
    double area = (dx * height * depth + dy * width * depth + dz * width * height) / distance;
    double cosine = distance / Math.sqrt(distance * distance + area / Math.PI);
    return 2 * Math.PI * (1 - cosine);
  }
}
