package org.selectiverenderer.polygon.count;

import java.util.IdentityHashMap;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import org.joml.Matrix4dc;
import org.selectiverenderer.base.problem.Problems;
import org.selectiverenderer.geometry.Bounds;
import org.selectiverenderer.schema.Activation;
import org.selectiverenderer.schema.SensorSchemas;
import org.selectiverenderer.schema.SwitchSchemas;
import org.selectiverenderer.x3d.read.ParsedNode;

/**
 * The enriched part of a scene as the polygon counts see it: objects in versions with what each
 * version costs, areas with their boxes, and the worst state of a part. Serves one thread.
 */
public final class SceneModel {
  /**
   * A version of an object.
   *
   * @param polygons of all that it shows, nested objects at their most detailed
   * @param bounds in the coordinates of the Switch
   * @param exact whether these are the least bounds, not wider ones of turned parts
   */
  public record Version(long polygons, Bounds bounds, boolean exact) {}

  /**
   * A Switch with metadata of schemas.
   *
   * @param versions one for each child
   */
  public record VersionedSwitch(ParsedNode node, SwitchSchemas schemas, List<Version> versions) {
    /** Keeps copies, so that it stays as it is. */
    public VersionedSwitch {
      versions = List.copyOf(versions);
    }

    /** The child that the file shows. */
    public int whichChoice() {
      return node.integer("whichChoice");
    }
  }

  /**
   * A ProximitySensor with metadata of schemas that the viewer can be in.
   *
   * @param boxes at least one
   */
  public record SensedArea(
      ParsedNode sensor, String name, SensorSchemas schemas, List<SensorBox> boxes) {
    /** Keeps copies, so that it stays as it is. */
    public SensedArea {
      boxes = List.copyOf(boxes);
    }

    /** Whether who is in the other area is in this one too. */
    public boolean surrounds(SensedArea other) {
      return other.boxes.stream()
          .allMatch(inner -> boxes.stream().anyMatch(box -> box.contains(inner)));
    }

    /** Whether the viewer can be in both at once. */
    public boolean shares(SensedArea other) {
      return boxes.stream()
          .anyMatch(
              box -> other.boxes.stream().anyMatch(with -> SensorBox.share(List.of(box, with))));
    }
  }

  /**
   * A state that the viewer can bring about.
   *
   * @param schemas of the areas that the viewer is in; empty for none
   */
  public record State(List<String> schemas, long polygons) {
    /** Keeps copies, so that it stays as it is. */
    public State {
      schemas = List.copyOf(schemas);
    }
  }

  private final ItemBuilder items;
  private final CountScope all;
  private final List<Area> areas;
  private final List<VersionedSwitch> objects;
  private final ItemInstances places;

  private SceneModel(CountedFile main) {
    items = new ItemBuilder(main, new Problems());
    all = CountScope.of(SceneStatistics.WHOLE_SCENE, items.root());
    areas = new AreaFinder(items.root(), List.of()).all();
    Map<CountedItem, Integer> choices = new IdentityHashMap<>();
    all.objects().forEach(o -> choices.put(o, o.versions.orElseThrow().mostDetailed()));
    PolygonCounter high = new PolygonCounter(choices);
    objects = all.objects().stream().map(object -> versioned(object, high)).toList();
    Set<CountedItem> placed = new LinkedHashSet<>();
    items
        .all()
        .forEach(
            (node, item) -> {
              if (Structure.isSensor(node) || node.type().is("X3DViewpointNode")) {
                placed.add(item);
              }
            });
    places = new ItemInstances(items.root(), placed);
  }

  /** The model of a scene with all that it inlines. */
  public static SceneModel of(CountedFile main) {
    return new SceneModel(main);
  }

  /** The objects in versions, in document order. */
  public List<VersionedSwitch> objects() {
    return objects;
  }

  /** The areas that can be entered, in document order. */
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

  /** Of all that the scene can show, in the world. */
  public Bounds bounds() {
    return items.root().bounds;
  }

  /** From the coordinates that hold a sensor or viewpoint to the world, one for each place. */
  public List<Matrix4dc> places(ParsedNode node) {
    return items.of(node).map(places::of).orElse(List.of());
  }

  /** The scene as loaded, before the viewer has entered any area. */
  public Activation<ParsedNode, ParsedNode> activation() {
    Activation<ParsedNode, ParsedNode> activation = new Activation<>();
    areas().forEach(area -> activation.putArea(area.sensor(), area.schemas()));
    objects.forEach(
        object -> activation.putSwitch(object.node(), object.schemas(), object.whichChoice()));
    return activation;
  }

  /** The groups that can be counted, by DEF name: of the scene's own file and of inlined ones. */
  public Set<String> groups() {
    Map<String, ParsedNode> groups = new LinkedHashMap<>(items.named());
    groups.values().removeIf(node -> !Structure.isGroup(node.type()) || items.of(node).isEmpty());
    return groups.keySet();
  }

  /**
   * The states that a part of the scene can be in, whichever way the viewer walks through the
   * areas; at most {@value ReachableStates#LIMIT}.
   *
   * @param group one of {@link #groups}; empty for the whole scene
   */
  public List<State> states(String group) {
    CountedItem item =
        group.isEmpty() ? items.root() : items.of(items.named().get(group)).orElse(items.root());
    return new ReachableStates(all.objects(), areas).states(item);
  }

  private static VersionedSwitch versioned(CountedItem object, PolygonCounter high) {
    return new VersionedSwitch(
        Optional.ofNullable(object.node).orElseThrow(),
        object.versions.orElseThrow(),
        object.children.stream()
            .map(child -> new Version(high.of(child), child.bounds, child.exact))
            .toList());
  }
}
