package org.selectiverenderer.runtime.pick;

import java.util.ArrayList;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import org.selectiverenderer.runtime.collide.MeshTrees;
import org.selectiverenderer.runtime.instance.Assets;
import org.selectiverenderer.runtime.instance.InstanceTree;
import org.selectiverenderer.runtime.nodes.pick.PickSensorNode;
import org.selectiverenderer.runtime.scene.Cascade;

/**
 * Evaluates the pick sensors of a layer. After all other sensors have been updated in a frame (X3D
 * 4.0, 38.2), each enabled pick sensor receives the shapes that it picks, if anything has changed
 * since the last frame.
 */
public final class Picking {
  private final InstanceTree tree;
  private final Assets assets;
  private final MeshTrees meshes;
  private List<SensorSearch> searches = List.of();
  private long structure;
  private long placement;
  private long choice;

  public Picking(InstanceTree tree, Assets assets, MeshTrees meshes) {
    this.tree = tree;
    this.assets = assets;
    this.meshes = meshes;
  }

  /** Sets the sensors, in order. */
  public void follow(List<PickSensorNode> sensors) {
    if (sensors.isEmpty() && searches.isEmpty()) {
      return;
    }
    Map<PickSensorNode, SensorSearch> known = new IdentityHashMap<>();
    searches.forEach(search -> known.put(search.sensor(), search));
    List<SensorSearch> now = new ArrayList<>();
    for (PickSensorNode sensor : sensors) {
      SensorSearch before = known.remove(sensor);
      now.add(before == null ? new SensorSearch(sensor, tree, assets, meshes) : before);
    }
    known.values().forEach(SensorSearch::close);
    searches = now;
  }

  /** Updates the sensors for a frame. */
  public void frame(Cascade cascade) {
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
