package org.selectiverenderer.polygon.count;

import java.util.ArrayList;
import java.util.Collection;
import java.util.Comparator;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.stream.Stream;
import org.joml.Matrix4dc;
import org.selectiverenderer.geometry.Bounds;
import org.selectiverenderer.x3d.read.ParsedNode;

/**
 * Finds the areas of a scene and says which scope each lies in:
 *
 * <ol>
 *   <li>the scope that its sensor stands in;
 *   <li>else the scope whose bounds the centre of its box is in, the smallest one of several;
 *   <li>else every scope with an object that one of its schemas shows a version of.
 * </ol>
 *
 * Sensors that are not enabled or have no inside are none: nobody ever enters them.
 */
final class AreaFinder {
  private final List<Area> areas = new ArrayList<>();
  private final ItemInstances places;

  AreaFinder(CountedItem root, Collection<CountScope> scopes) {
    CountScope all = CountScope.of(SceneStatistics.WHOLE_SCENE, root);
    Set<CountedItem> sensors = new LinkedHashSet<>(all.sensors());
    Set<CountedItem> wanted = new LinkedHashSet<>(sensors);
    scopes.forEach(scope -> wanted.add(scope.item()));
    places = new ItemInstances(root, wanted);
    for (CountedItem sensor : sensors) {
      List<SensorBox> boxes = boxes(sensor);
      if (!boxes.isEmpty()) {
        areas.add(new Area(sensor, sensor.area.orElseThrow(), boxes));
      }
    }
  }

  /** All areas in document order. */
  List<Area> all() {
    return List.copyOf(areas);
  }

  /** Whether every place of sensors and scopes has been looked at. */
  boolean complete() {
    return places.complete();
  }

  /** The areas that lie in each scope. */
  List<Area> in(CountScope scope, Collection<CountScope> scopes) {
    return areas.stream().filter(area -> lies(area, scope, scopes)).toList();
  }

  private boolean lies(Area area, CountScope scope, Collection<CountScope> scopes) {
    if (scopes.stream().anyMatch(other -> other.sensors().contains(area.sensor))) {
      return scope.sensors().contains(area.sensor);
    }
    List<CountScope> around = scopes.stream().filter(other -> surrounds(other, area)).toList();
    if (!around.isEmpty()) {
      return around.stream().min(Comparator.comparingDouble(this::volume)).orElseThrow() == scope;
    }
    return scope.objects().stream()
        .flatMap(object -> object.versions.stream())
        .map(schemas -> schemas.choiceBySchema())
        .anyMatch(choices -> area.schemas.enter().stream().anyMatch(choices::containsKey));
  }

  private boolean surrounds(CountScope scope, Area area) {
    return bounds(scope)
        .anyMatch(bounds -> area.boxes.stream().anyMatch(box -> bounds.contains(box.centre())));
  }

  private double volume(CountScope scope) {
    return bounds(scope).mapToDouble(Bounds::volume).max().orElse(0);
  }

  private Stream<Bounds> bounds(CountScope scope) {
    return places.of(scope.item()).stream().map(scope.item().bounds::transformed);
  }

  private List<SensorBox> boxes(CountedItem sensor) {
    ParsedNode node = sensor.node;
    List<SensorBox> boxes = new ArrayList<>();
    if (node != null && node.bool("enabled")) {
      for (Matrix4dc world : places.of(sensor)) {
        SensorBox.of(node.floats("center"), node.floats("size"), world).ifPresent(boxes::add);
      }
    }
    return boxes;
  }
}
