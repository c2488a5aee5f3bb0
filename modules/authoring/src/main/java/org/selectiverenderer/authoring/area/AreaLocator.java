package org.selectiverenderer.authoring.area;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.joml.Vector3d;
import org.selectiverenderer.authoring.enrichment.DocumentEnrichment;
import org.selectiverenderer.authoring.enrichment.EnrichedSensor;
import org.selectiverenderer.geometry.BoundingBox;
import org.selectiverenderer.polygon.SensorBox;
import org.selectiverenderer.x3d.field.FieldType;
import org.selectiverenderer.x3d.source.DocumentElement;
import org.selectiverenderer.x3d.source.ElementTree;

/** Finds the areas of a document, their parts and their overlaps. */
public final class AreaLocator {
  /** The number of samples along each side of a box for the overlap with a rotated box. */
  private static final int SAMPLES = 48;

  private AreaLocator() {}

  /** Returns all areas whose position the text determines, in document order. */
  public static List<AreaInstance> of(DocumentEnrichment enrichment) {
    List<AreaInstance> areas = new ArrayList<>();
    enrichment.sensors().forEach(sensor -> of(enrichment, sensor).ifPresent(areas::add));
    return areas;
  }

  /** Returns the area of a sensor; empty if the text does not determine its position. */
  public static Optional<AreaInstance> of(DocumentEnrichment enrichment, EnrichedSensor sensor) {
    DocumentElement element = sensor.element();
    ElementTree tree = enrichment.document().tree().orElseThrow();
    return LocalCoordinateSystem.of(element)
        .map(
            frame -> {
              float[] centre = centre(element);
              float[] size = size(element);
              return new AreaInstance(
                  element,
                  sensor.name(),
                  sensor.schemas(),
                  frame,
                  frame.toScene(centre, size),
                  SensorBox.of(centre, size, frame.world()),
                  elsewhere(element, tree));
            });
  }

  static float[] centre(DocumentElement sensor) {
    return LocalCoordinateSystem.numbers(sensor, "center", FieldType.SFVec3f, 0, 0, 0);
  }

  static float[] size(DocumentElement sensor) {
    return LocalCoordinateSystem.numbers(sensor, "size", FieldType.SFVec3f, 0, 0, 0);
  }

  private static List<String> elsewhere(DocumentElement element, ElementTree tree) {
    List<String> names = new ArrayList<>();
    for (Optional<DocumentElement> at = Optional.of(element);
        at.isPresent();
        at = at.get().parent()) {
      at.get().def().filter(tree::used).ifPresent(names::add);
    }
    return names;
  }

  /** Returns the other sensors that activate the same schemas: parts of one area. */
  public static List<AreaInstance> parts(AreaInstance area, List<AreaInstance> all) {
    return all.stream()
        .filter(other -> other.element() != area.element())
        .filter(other -> area.enriched() && other.schemas().equals(area.schemas()))
        .toList();
  }

  /**
   * The overlap of two areas.
   *
   * @param volume volume in cubic units of the scene; approximate for rotated areas
   * @param within whether the area lies completely in the other one
   * @param around whether the other one lies completely in the area
   */
  public record Overlap(AreaInstance other, double volume, boolean within, boolean around) {}

  /** Returns the overlaps of an area with other areas, except for parts of the same area. */
  public static List<Overlap> overlaps(AreaInstance area, List<AreaInstance> all) {
    List<AreaInstance> parts = parts(area, all);
    List<Overlap> found = new ArrayList<>();
    for (AreaInstance other : all) {
      if (other.element() != area.element() && !parts.contains(other)) {
        overlap(area, other).ifPresent(found::add);
      }
    }
    return found;
  }

  private static Optional<Overlap> overlap(AreaInstance area, AreaInstance other) {
    if (area.solid().isEmpty() || other.solid().isEmpty()) {
      return Optional.empty();
    }
    SensorBox one = area.solid().get();
    SensorBox two = other.solid().get();
    if (!SensorBox.share(List.of(one, two))) {
      return Optional.empty();
    }
    return Optional.of(
        new Overlap(other, volume(area, other), two.contains(one), one.contains(two)));
  }

  private static double volume(AreaInstance area, AreaInstance other) {
    BoundingBox a = area.solid().orElseThrow().bounds();
    BoundingBox b = other.solid().orElseThrow().bounds();
    BoundingBox both =
        new BoundingBox(
            Math.max(a.minX(), b.minX()),
            Math.max(a.minY(), b.minY()),
            Math.max(a.minZ(), b.minZ()),
            Math.min(a.maxX(), b.maxX()),
            Math.min(a.maxY(), b.maxY()),
            Math.min(a.maxZ(), b.maxZ()));
    if (!area.frame().turned() && !other.frame().turned()) {
      return both.volume();
    }
    int inside = 0;
    for (int i = 0; i < SAMPLES * SAMPLES * SAMPLES; i++) {
      Vector3d at =
          new Vector3d(i % SAMPLES, i / SAMPLES % SAMPLES, i / (SAMPLES * SAMPLES))
              .add(0.5, 0.5, 0.5)
              .div(SAMPLES)
              .mul(both.width(), both.height(), both.depth())
              .add(both.min());
      if (area.solid().get().contains(at) && other.solid().get().contains(at)) {
        inside++;
      }
    }
    return both.volume() * inside / (SAMPLES * SAMPLES * SAMPLES);
  }
}
