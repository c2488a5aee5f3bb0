package org.selectiverenderer.polygon;

import java.util.IdentityHashMap;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import org.joml.Matrix4dc;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.geometry.BoundingBox;
import org.selectiverenderer.schema.SchemaActivation;
import org.selectiverenderer.schema.SensorSchemas;
import org.selectiverenderer.schema.SwitchSchemas;
import org.selectiverenderer.x3d.read.ParsedNode;

/**
 * The enrichment of a scene with its polygon counts: versioned objects with the polygons of each
 * version, areas with their boxes, and the states that a part of the scene can reach. Not
 * thread-safe.
 */
public final class EnrichmentPolygonModel {
  /**
   * A version of an object.
   *
   * @param polygons polygons of all that the version shows, with nested objects in their most
   *     detailed version
   * @param bounds bounding box in the coordinates of the Switch
   * @param exact whether the bounds are tight; bounds of rotated parts may be wider
   */
  public record Version(long polygons, BoundingBox bounds, boolean exact) {}

  /**
   * A Switch with metadata of schemas.
   *
   * @param versions the versions, one for each child
   */
  public record VersionedSwitch(ParsedNode node, SwitchSchemas schemas, List<Version> versions) {
    /** Makes defensive copies, so that the record is immutable. */
    public VersionedSwitch {
      versions = List.copyOf(versions);
    }

    /** Returns the child that the file shows. */
    public int whichChoice() {
      return node.integer("whichChoice");
    }
  }

  /**
   * A ProximitySensor with metadata of schemas that the viewer can be in.
   *
   * @param boxes boxes of the sensor in world coordinates, at least one
   */
  public record SensedArea(
      ParsedNode sensor, String name, SensorSchemas schemas, List<SensorBox> boxes) {
    /** Makes defensive copies, so that the record is immutable. */
    public SensedArea {
      boxes = List.copyOf(boxes);
    }

    /** Returns whether this area contains another one. */
    public boolean surrounds(SensedArea other) {
      return other.boxes.stream()
          .allMatch(inner -> boxes.stream().anyMatch(box -> box.contains(inner)));
    }

    /** Returns whether this area overlaps another one. */
    public boolean shares(SensedArea other) {
      return boxes.stream()
          .anyMatch(
              box -> other.boxes.stream().anyMatch(with -> SensorBox.share(List.of(box, with))));
    }
  }

  /**
   * A state that the viewer can reach.
   *
   * @param schemas schemas of the areas that the viewer is in; empty for none
   * @param cost what the state costs beside polygons
   */
  public record State(List<String> schemas, long polygons, RenderingCost cost) {
    /** Makes defensive copies, so that the record is immutable. */
    public State {
      schemas = List.copyOf(schemas);
    }
  }

  private final CountGraphBuilder items;
  private final CountedRegion all;
  private final List<Area> areas;
  private final List<VersionedSwitch> objects;
  private final InstanceTransforms places;

  private EnrichmentPolygonModel(FilePolygonMeasurement main) {
    items = new CountGraphBuilder(main, new ProblemCollector());
    all = CountedRegion.of(SceneStatistics.WHOLE_SCENE, items.root());
    areas = new AreaFinder(items.root(), List.of()).all();
    Map<CountGraphNode, Integer> choices = new IdentityHashMap<>();
    all.objects().forEach(o -> choices.put(o, o.versions.orElseThrow().mostDetailed()));
    PolygonCounter high = new PolygonCounter(choices);
    objects = all.objects().stream().map(object -> versioned(object, high)).toList();
    Set<CountGraphNode> placed = new LinkedHashSet<>();
    items
        .all()
        .forEach(
            (node, item) -> {
              if (DrawableNodeClassifier.isSensor(node) || node.type().is("X3DViewpointNode")) {
                placed.add(item);
              }
            });
    places = new InstanceTransforms(items.root(), placed);
  }

  /** Returns the model of a scene with all that it inlines. */
  public static EnrichmentPolygonModel of(FilePolygonMeasurement main) {
    return new EnrichmentPolygonModel(main);
  }

  /** Returns the versioned objects, in document order. */
  public List<VersionedSwitch> objects() {
    return objects;
  }

  /** Returns the areas that can be entered, in document order. */
  public List<SensedArea> areas() {
    return areas.stream()
        .map(
            area ->
                new SensedArea(
                    Objects.requireNonNull(area.sensor.node),
                    area.sensor.name,
                    area.schemas,
                    area.boxes))
        .toList();
  }

  /** Returns the bounding box of all that the scene can show, in world coordinates. */
  public BoundingBox bounds() {
    return items.root().bounds;
  }

  /**
   * Returns the transforms from the parent coordinates of a sensor or viewpoint to the world, one
   * for each instance.
   */
  public List<Matrix4dc> places(ParsedNode node) {
    return items.of(node).map(places::of).orElse(List.of());
  }

  /** Returns the activation of the scene as loaded, before the viewer has entered any area. */
  public SchemaActivation<ParsedNode, ParsedNode> activation() {
    SchemaActivation<ParsedNode, ParsedNode> activation = new SchemaActivation<>();
    areas().forEach(area -> activation.putArea(area.sensor(), area.schemas()));
    objects.forEach(
        object -> activation.putSwitch(object.node(), object.schemas(), object.whichChoice()));
    return activation;
  }

  /**
   * Returns the DEF names of the groups that can be counted, of the scene's own file and of inlined
   * ones.
   */
  public Set<String> groups() {
    Map<String, ParsedNode> groups = new LinkedHashMap<>(items.named());
    groups
        .values()
        .removeIf(node -> !DrawableNodeClassifier.isGroup(node.type()) || items.of(node).isEmpty());
    return groups.keySet();
  }

  /**
   * Returns the states that a part of the scene can be in, in whichever order the viewer enters and
   * leaves the areas; at most {@value ReachableStateSearch#LIMIT}.
   *
   * @param group one of {@link #groups}; empty for the whole scene
   */
  public List<State> states(String group) {
    CountGraphNode item =
        group.isEmpty() ? items.root() : items.of(items.named().get(group)).orElse(items.root());
    return new ReachableStateSearch(all.objects(), items.varying(), areas).states(item);
  }

  private static VersionedSwitch versioned(CountGraphNode object, PolygonCounter high) {
    return new VersionedSwitch(
        Optional.ofNullable(object.node).orElseThrow(),
        object.versions.orElseThrow(),
        object.children.stream()
            .map(child -> new Version(high.of(child), child.bounds, child.exact))
            .toList());
  }
}
