package org.selectiverenderer.polygon;

import java.util.ArrayList;
import java.util.Collection;
import java.util.Comparator;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.stream.Stream;
import org.joml.Matrix4dc;
import org.selectiverenderer.geometry.BoundingBox;
import org.selectiverenderer.x3d.read.ParsedNode;

/**
 * Finds the areas of a scene and the scope that each lies in:
 *
 * <ol>
 *   <li>the scope that contains its sensor;
 *   <li>else the scope whose bounding box contains the centre of the sensor's box, the smallest of
 *       several;
 *   <li>else every scope with an object of which one of the area's schemas shows a version.
 * </ol>
 *
 * Sensors that are disabled or have no volume are not areas, since nobody can enter them.
 */
final class AreaFinder {
  private final List<Area> areas = new ArrayList<>();
  private final InstanceTransforms places;

  AreaFinder(CountGraphNode root, Collection<CountedRegion> scopes) {
    CountedRegion all = CountedRegion.of(SceneStatistics.WHOLE_SCENE, root);
    Set<CountGraphNode> sensors = new LinkedHashSet<>(all.sensors());
    Set<CountGraphNode> wanted = new LinkedHashSet<>(sensors);
    scopes.forEach(scope -> wanted.add(scope.item()));
    places = new InstanceTransforms(root, wanted);
    for (CountGraphNode sensor : sensors) {
      List<SensorBox> boxes = boxes(sensor);
      if (!boxes.isEmpty()) {
        areas.add(new Area(sensor, sensor.area.orElseThrow(), boxes));
      }
    }
  }

  /** Returns all areas in document order. */
  List<Area> all() {
    return List.copyOf(areas);
  }

  /** Returns whether all instances of sensors and scopes have been considered. */
  boolean complete() {
    return places.complete();
  }

  /** Returns the areas that lie in a scope. */
  List<Area> in(CountedRegion scope, Collection<CountedRegion> scopes) {
    return areas.stream().filter(area -> lies(area, scope, scopes)).toList();
  }

  private boolean lies(Area area, CountedRegion scope, Collection<CountedRegion> scopes) {
    if (scopes.stream().anyMatch(other -> other.sensors().contains(area.sensor))) {
      return scope.sensors().contains(area.sensor);
    }
    List<CountedRegion> around = scopes.stream().filter(other -> surrounds(other, area)).toList();
    if (!around.isEmpty()) {
      return around.stream().min(Comparator.comparingDouble(this::volume)).orElseThrow() == scope;
    }
    return scope.objects().stream()
        .flatMap(object -> object.versions.stream())
        .map(schemas -> schemas.choiceBySchema())
        .anyMatch(choices -> area.schemas.enter().stream().anyMatch(choices::containsKey));
  }

  private boolean surrounds(CountedRegion scope, Area area) {
    return bounds(scope)
        .anyMatch(bounds -> area.boxes.stream().anyMatch(box -> bounds.contains(box.centre())));
  }

  private double volume(CountedRegion scope) {
    return bounds(scope).mapToDouble(BoundingBox::volume).max().orElse(0);
  }

  private Stream<BoundingBox> bounds(CountedRegion scope) {
    return places.of(scope.item()).stream().map(scope.item().bounds::transformed);
  }

  private List<SensorBox> boxes(CountGraphNode sensor) {
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
