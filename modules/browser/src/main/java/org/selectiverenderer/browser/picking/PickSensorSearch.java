package org.selectiverenderer.browser.picking;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.joml.Matrix4dc;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.browser.collision.MeshBvhCache;
import org.selectiverenderer.browser.instance.AssetProvider;
import org.selectiverenderer.browser.instance.GroupInstance;
import org.selectiverenderer.browser.instance.Instance;
import org.selectiverenderer.browser.instance.InstanceTree;
import org.selectiverenderer.browser.instance.ShapeInstance;
import org.selectiverenderer.browser.nodes.group.InlineNode;
import org.selectiverenderer.browser.nodes.picking.ObjectTypeMatcher;
import org.selectiverenderer.browser.nodes.picking.PickResult;
import org.selectiverenderer.browser.nodes.picking.PickSensorNode;
import org.selectiverenderer.browser.scene.EventCascade;
import org.selectiverenderer.browser.scene.Node;
import org.selectiverenderer.browser.scene.NodeObserver;
import org.selectiverenderer.browser.scene.NodeSubgraphCollector;
import org.selectiverenderer.geometry.BoundingBox;
import org.selectiverenderer.geometry.mesh.Mesh;

/**
 * Searches for the shapes that one pick sensor intersects, if something on which they depend has
 * changed.
 */
final class PickSensorSearch implements NodeObserver {
  private final PickSensorNode sensor;
  private final InstanceTree tree;
  private final AssetProvider assets;
  private final MeshBvhCache meshes;
  private List<Node> observed = List.of();
  private @Nullable Node geometry;
  private Picker picker = Picker.NOTHING;
  private boolean reshaped = true;
  private boolean stale = true;

  PickSensorSearch(
      PickSensorNode sensor, InstanceTree tree, AssetProvider assets, MeshBvhCache meshes) {
    this.sensor = sensor;
    this.tree = tree;
    this.assets = assets;
    this.meshes = meshes;
    sensor.addObserver(this);
  }

  PickSensorNode sensor() {
    return sensor;
  }

  @Override
  public void changed(Node node, int field) {
    if (node != sensor) {
      reshaped = true;
      if (geometry != null) {
        assets.changed(geometry);
      }
    } else {
      stale |= sensor.asks(field);
      reshaped |= sensor.geometry() != geometry;
    }
  }

  void close() {
    sensor.removeObserver(this);
    observed.forEach(node -> node.removeObserver(this));
  }

  /**
   * @param moved whether anything in the scene has moved
   */
  void frame(boolean moved, EventCascade cascade) {
    stale |= moved || reshaped;
    if (!stale || !sensor.enabled()) {
      return;
    }
    stale = false;
    if (reshaped) {
      reshaped = false;
      reshape();
    }
    sensor.report(met(), cascade);
  }

  private void reshape() {
    observed.forEach(node -> node.removeObserver(this));
    geometry = sensor.geometry();
    observed = geometry == null ? List.of() : NodeSubgraphCollector.of(geometry);
    observed.forEach(node -> node.addObserver(this));
    picker = PickerFactory.of(sensor.with(), geometry, assets);
  }

  private List<PickResult> met() {
    List<PickResult> met = new ArrayList<>();
    ObjectTypeMatcher labels = sensor.labels();
    if (picker.box().isEmpty() || labels.none()) {
      return met;
    }
    for (Node target : sensor.targets()) {
      for (Instance place : tree.instances(target)) {
        if (pickable(place.parent(), labels)) {
          meet(place, labels, null, met);
        }
      }
    }
    return met;
  }

  /** Returns whether the groups above an instance let it be picked. */
  private static boolean pickable(@Nullable GroupInstance around, ObjectTypeMatcher labels) {
    for (GroupInstance group = around; group != null; group = group.parent()) {
      if (!lets(group, labels)) {
        return false;
      }
    }
    return true;
  }

  private static boolean lets(GroupInstance group, ObjectTypeMatcher labels) {
    return !group.node().type().is("X3DPickableObject")
        || group.node().bool("pickable") && labels.fit(List.of(group.node().strings("objectType")));
  }

  /**
   * @param inline the outermost Inline that contains the instance and is reported in its place, if
   *     any
   */
  private void meet(
      Instance at, ObjectTypeMatcher labels, @Nullable Node inline, List<PickResult> met) {
    if (at instanceof GroupInstance group && group.shown() && lets(group, labels)) {
      Node hiding = inline == null && group.node() instanceof InlineNode ? group.node() : inline;
      group.children().forEach(child -> meet(child, labels, hiding, met));
    } else if (at instanceof ShapeInstance shape && shape.shown()) {
      Node told = inline == null ? shape.node() : inline;
      for (Matrix4dc place : tree.places(sensor)) {
        meet(shape, place)
            .ifPresent(how -> met.add(new PickResult(told, how.distance(), how.places())));
      }
    }
  }

  private Optional<Picker.Met> meet(ShapeInstance shape, Matrix4dc place) {
    BoundingBox box = BoundingBox.of(shape.bounds());
    Mesh mesh = shape.mesh().orElse(null);
    if (mesh == null || box.isEmpty() || box.apart(picker.box().transformed(place))) {
      return Optional.empty();
    }
    PickTarget target = PickTarget.of(mesh, meshes.of(mesh), box, shape.world(), place);
    if (!target.hasExtent()) {
      return Optional.empty();
    }
    return sensor.bounds() ? picker.bounds(target) : picker.mesh(target);
  }
}
