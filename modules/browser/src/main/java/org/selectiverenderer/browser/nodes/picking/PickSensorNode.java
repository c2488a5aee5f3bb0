package org.selectiverenderer.browser.nodes.picking;

import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.function.Function;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.browser.scene.EventCascade;
import org.selectiverenderer.browser.scene.Node;
import org.selectiverenderer.browser.scene.NodeConstructor;
import org.selectiverenderer.x3d.catalogue.FieldDefinition;
import org.selectiverenderer.x3d.catalogue.NodeType;

/**
 * A pick sensor: reports the shapes that its own geometry intersects (X3D 4.0, X3DPickSensorNode,
 * 38.3.2). {@code browser.picking} finds the intersections; the node sorts them and sends changes:
 * {@code isActive}, {@code pickedGeometry}, then the intersection points. A sensor disabled while
 * active becomes inactive at once.
 */
public final class PickSensorNode extends Node {
  public static final Map<String, NodeConstructor> MAKERS =
      Map.of(
          "LinePickSensor", PickSensorNode::new,
          "PointPickSensor", PickSensorNode::new,
          "PrimitivePickSensor", PickSensorNode::new,
          "VolumePickSensor", PickSensorNode::new);

  /** The kind of geometry with which a sensor picks. */
  public enum With {
    LINES,
    POINTS,
    PRIMITIVE,
    HULL
  }

  private final With with;
  private final int enabled;
  private final int isActive;
  private final int pickedGeometry;
  private final int pickedPoint;
  private final int pickedNormal;
  private final int pickedTextureCoordinate;

  public PickSensorNode(NodeType type, @Nullable String name, SourceLocation location) {
    super(type, name, location);
    with =
        switch (type.name()) {
          case "LinePickSensor" -> With.LINES;
          case "PointPickSensor" -> With.POINTS;
          case "PrimitivePickSensor" -> With.PRIMITIVE;
          default -> With.HULL;
        };
    enabled = type.indexOf("enabled");
    isActive = type.indexOf("isActive");
    pickedGeometry = type.indexOf("pickedGeometry");
    pickedPoint = output("pickedPoint");
    pickedNormal = output("pickedNormal");
    pickedTextureCoordinate = output("pickedTextureCoordinate");
  }

  private int output(String name) {
    return type().field(name).map(FieldDefinition::index).orElse(-1);
  }

  public With with() {
    return with;
  }

  public boolean enabled() {
    return (Boolean) value(enabled);
  }

  /** Returns whether a field determines the picking geometry or the pick targets. */
  public boolean asks(int field) {
    return field != isActive
        && field != pickedGeometry
        && field != pickedPoint
        && field != pickedNormal
        && field != pickedTextureCoordinate;
  }

  /** Returns the matcher for the {@code objectType}s of groups. */
  public ObjectTypeMatcher labels() {
    return new ObjectTypeMatcher(
        List.of(strings("objectType")), ObjectTypeMatcher.Criterion.of(string("matchCriterion")));
  }

  /** Returns whether bounding boxes of shapes are tested instead of the shapes themselves. */
  public boolean bounds() {
    return !string("intersectionType").equals("GEOMETRY");
  }

  /** Returns the nodes that may be picked, with all nodes below them. */
  public List<Node> targets() {
    return nodes("pickTarget");
  }

  /** Returns the picking geometry, in the sensor's local coordinates. */
  public @Nullable Node geometry() {
    return node("pickingGeometry");
  }

  /** Takes the intersections of this frame, in any order, and sends events. */
  public void report(List<PickResult> met, EventCascade cascade) {
    List<PickResult> picked = chosen(met);
    boolean active = !picked.isEmpty();
    if (active != (Boolean) value(isActive)) {
      emit(isActive, active, cascade);
    }
    List<Node> nodes = picked.stream().map(PickResult::node).distinct().toList();
    if (!nodes.equals(nodes("pickedGeometry"))) {
      emit(pickedGeometry, nodes, cascade);
    }
    sendPlaces(pickedTextureCoordinate, picked, PickResult.Place::texCoord, cascade);
    sendPlaces(pickedNormal, picked, PickResult.Place::normal, cascade);
    sendPlaces(pickedPoint, picked, PickResult.Place::point, cascade);
  }

  /**
   * Selects and sorts the results. For points CLOSEST means ANY and ALL_SORTED means ALL (38.4.3).
   */
  private List<PickResult> chosen(List<PickResult> met) {
    String order = string("sortOrder");
    boolean all = order.startsWith("ALL");
    boolean sorted = with != With.POINTS && (order.equals("ALL_SORTED") || order.equals("CLOSEST"));
    List<PickResult> list =
        sorted
            ? met.stream().sorted(Comparator.comparingDouble(PickResult::distance)).toList()
            : met;
    return all || list.isEmpty() ? list : list.subList(0, 1);
  }

  private void sendPlaces(
      int field,
      List<PickResult> picked,
      Function<PickResult.Place, @Nullable Vector3dc> part,
      EventCascade cascade) {
    if (field < 0) {
      return;
    }
    List<@Nullable Vector3dc> known =
        picked.stream().flatMap(one -> one.places().stream()).map(part).toList();
    boolean any = known.stream().anyMatch(Objects::nonNull);
    float[] values = new float[any ? 3 * known.size() : 0];
    for (int i = 0; 3 * i < values.length; i++) {
      Vector3dc at = known.get(i) == null ? new Vector3d() : known.get(i);
      values[3 * i] = (float) at.x();
      values[3 * i + 1] = (float) at.y();
      values[3 * i + 2] = (float) at.z();
    }
    if (!Arrays.equals(values, (float[]) value(field))) {
      emit(field, values, cascade);
    }
  }

  @Override
  protected void receive(FieldDefinition field, @Nullable Object value, EventCascade cascade) {
    super.receive(field, value, cascade);
    if (field.index() == enabled && !enabled() && (Boolean) value(isActive)) {
      emit(isActive, false, cascade);
    }
  }
}
