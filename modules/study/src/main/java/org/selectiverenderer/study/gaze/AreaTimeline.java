package org.selectiverenderer.study.gaze;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.selectiverenderer.study.headlog.HeadLog;
import org.selectiverenderer.study.headlog.HeadSample;
import org.selectiverenderer.study.headlog.SceneMap;

/**
 * Finds the areas in which a viewer was at each sample of a log: those of the active schemas; where
 * none was active the areas of ProximitySensors around the head, else its room, else the scene.
 */
final class AreaTimeline {
  private final SceneMap map;
  private final Map<List<String>, List<GazeArea>> schemas = new LinkedHashMap<>();

  AreaTimeline(HeadLog log) {
    map = log.description().map();
  }

  /** Returns the areas of a sample; at least one. */
  List<GazeArea> of(HeadSample sample) {
    if (!sample.schemas().isEmpty()) {
      return schemas.computeIfAbsent(
          sample.schemas(),
          names -> names.stream().distinct().map(name -> new GazeArea(name, true)).toList());
    }
    List<GazeArea> around = new ArrayList<>();
    for (SceneMap.Area area : map.areas()) {
      if (contains(area.outline(), sample.x(), sample.z())) {
        around.add(new GazeArea(area.name(), false));
      }
    }
    if (around.isEmpty()) {
      map.rooms().stream()
          .filter(room -> room.contains(sample.x(), sample.y(), sample.z()))
          .findFirst()
          .ifPresent(room -> around.add(new GazeArea(room.name(), false)));
    }
    return around.isEmpty() ? List.of(GazeArea.SCENE) : around.stream().distinct().toList();
  }

  /** Returns whether a point lies in a polygon: a ray from it crosses an odd number of edges. */
  private static boolean contains(List<double[]> outline, double x, double z) {
    boolean inside = false;
    for (int i = 0; i < outline.size(); i++) {
      double[] a = outline.get(i);
      double[] b = outline.get((i + 1) % outline.size());
      if (a[1] > z != b[1] > z && x < a[0] + (z - a[1]) / (b[1] - a[1]) * (b[0] - a[0])) {
        inside = !inside;
      }
    }
    return inside;
  }
}
