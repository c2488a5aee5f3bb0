package org.selectiverenderer.browser.picking;

import java.util.ArrayList;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import org.selectiverenderer.browser.collision.MeshBvhCache;
import org.selectiverenderer.browser.instance.AssetProvider;
import org.selectiverenderer.browser.instance.InstanceTree;
import org.selectiverenderer.browser.nodes.picking.PickSensorNode;
import org.selectiverenderer.browser.scene.EventCascade;

/**
 * Evaluates the pick sensors of a layer. After all other sensors have been updated in a frame (X3D
 * 4.0, 38.2), each enabled pick sensor receives the shapes that it picks, if anything has changed
 * since the last frame.
 */
public final class PickSensorEvaluator {
  private final InstanceTree tree;
  private final AssetProvider assets;
  private final MeshBvhCache meshes;
  private List<PickSensorSearch> searches = List.of();
  private long structure;
  private long placement;
  private long choice;

  public PickSensorEvaluator(InstanceTree tree, AssetProvider assets, MeshBvhCache meshes) {
    this.tree = tree;
    this.assets = assets;
    this.meshes = meshes;
  }

  /** Sets the sensors, in order. */
  public void follow(List<PickSensorNode> sensors) {
    if (sensors.isEmpty() && searches.isEmpty()) {
      return;
    }
    Map<PickSensorNode, PickSensorSearch> known = new IdentityHashMap<>();
    searches.forEach(search -> known.put(search.sensor(), search));
    List<PickSensorSearch> now = new ArrayList<>();
    for (PickSensorNode sensor : sensors) {
      PickSensorSearch before = known.remove(sensor);
      now.add(before == null ? new PickSensorSearch(sensor, tree, assets, meshes) : before);
    }
    known.values().forEach(PickSensorSearch::close);
    searches = now;
  }

  /** Updates the sensors for a frame. */
  public void frame(EventCascade cascade) {
    if (searches.isEmpty()) {
      return;
    }
    boolean moved =
        structure != tree.structureVersion()
            || placement != tree.placementVersion()
            || choice != tree.choiceVersion();
    structure = tree.structureVersion();
    placement = tree.placementVersion();
    choice = tree.choiceVersion();
    searches.forEach(search -> search.frame(moved, cascade));
  }
}
