package org.selectiverenderer.browser;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.PriorityQueue;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.browser.nodes.sensor.FrameContext;
import org.selectiverenderer.browser.nodes.sensor.FrameDrivenNode;
import org.selectiverenderer.browser.nodes.sensor.ProximitySensorNode;
import org.selectiverenderer.browser.nodes.sensor.SleepableNode;
import org.selectiverenderer.browser.scene.EventCascade;
import org.selectiverenderer.browser.scene.Node;
import org.selectiverenderer.browser.scene.NodeObserver;
import org.selectiverenderer.geometry.bvh.Bvh;
import org.selectiverenderer.geometry.bvh.BvhBuilder;

/**
 * Updates the sensors and clocks of a layer in every frame, in their order, and skips those that
 * cannot have an event to send. A ProximitySensor is updated only if the viewer is in its bounding
 * box, or was in the frame before, or if an event of an earlier sensor has changed that box in this
 * very frame; a {@link SleepableNode} only while it is awake. The events are the same as if all
 * nodes were updated in every frame, but the cost of a frame depends only on the sensors near the
 * viewer.
 */
final class SensorScheduler {
  /** Number of moved boxes per sensor after which the BVH is rebuilt instead of refitted. */
  private static final int WORN = 4;

  private static final int BEFORE_ALL = -1;
  private static final int AFTER_ALL = Integer.MAX_VALUE;

  private record Turn(int order, FrameDrivenNode node) {}

  private final List<FrameDrivenNode> nodes;
  private final List<Turn> always = new ArrayList<>();
  private final List<Watched> sensors = new ArrayList<>();
  private final Map<Node, Watched> byNode = new IdentityHashMap<>();
  private final List<Sleeping> sleepers = new ArrayList<>();
  private final ArrayDeque<Watched> changed = new ArrayDeque<>();
  private final PriorityQueue<Due> due =
      new PriorityQueue<>(Comparator.comparingInt((Due next) -> next.order));
  private List<Due> active = new ArrayList<>();
  private final ArrayDeque<Sleeping> late = new ArrayDeque<>();
  private final double[] eye = new double[6];
  private @Nullable Bvh tree;
  private long moves;
  private int turn = AFTER_ALL;

  /**
   * @param nodes the nodes in update order
   */
  SensorScheduler(List<FrameDrivenNode> nodes) {
    this.nodes = nodes;
    for (int order = 0; order < nodes.size(); order++) {
      if (nodes.get(order) instanceof ProximitySensorNode sensor) {
        Watched watched = new Watched(sensor, order);
        sensors.add(watched);
        byNode.put(sensor, watched);
        sensor.addObserver(watched);
        if (sensor.active()) {
          active.add(watched);
        }
      } else if (nodes.get(order) instanceof SleepableNode sleeper) {
        Sleeping sleeping = new Sleeping(sleeper, order);
        sleepers.add(sleeping);
        sleeper.wakeBy(sleeping);
        if (sleeper.awake()) {
          active.add(sleeping);
        }
      } else {
        always.add(new Turn(order, nodes.get(order)));
      }
    }
  }

  /** Returns whether this is the schedule of these nodes in this order. */
  boolean isOf(List<FrameDrivenNode> others) {
    if (others.size() != nodes.size()) {
      return false;
    }
    for (int i = 0; i < others.size(); i++) {
      if (others.get(i) != nodes.get(i)) {
        return false;
      }
    }
    return true;
  }

  /**
   * Notes that a node (of any type) has another world position than in the frame before; not to be
   * called during {@link #frame}.
   */
  void moved(Node node) {
    Watched watched = byNode.get(node);
    if (watched != null) {
      watched.change();
    }
  }

  /** Removes the observers from the nodes. */
  void close() {
    sensors.forEach(watched -> watched.sensor.removeObserver(watched));
    sleepers.forEach(sleeping -> sleeping.sleeper.wakeBy(null));
  }

  /**
   * Updates the nodes for one frame.
   *
   * @return the number of nodes that were updated
   */
  int frame(FrameContext frame, EventCascade cascade) {
    Bvh boxes = follow(frame);
    active.forEach(Due::queue);
    for (int axis = 0; axis < 3; axis++) {
      eye[axis] = frame.eye().get(axis);
      eye[axis + 3] = eye[axis];
    }
    boxes.overlap(eye, item -> sensors.get(item).queue());
    List<Due> again = new ArrayList<>();
    int looked = 0;
    int next = 0;
    turn = BEFORE_ALL;
    while (next < always.size() || !due.isEmpty()) {
      Due nearest = due.peek();
      if (nearest == null || next < always.size() && always.get(next).order < nearest.order) {
        turn = always.get(next).order;
        always.get(next++).node.frame(frame, cascade);
      } else {
        due.remove();
        nearest.queued = false;
        turn = nearest.order;
        if (nearest.look(frame, cascade)) {
          again.add(nearest);
        }
      }
      looked++;
    }
    turn = AFTER_ALL;
    for (Sleeping woken = late.poll(); woken != null; woken = late.poll()) {
      again.add(woken);
    }
    active = again;
    return looked;
  }

  /** Returns the BVH of the sensors' boxes, refitted to their present positions. */
  private Bvh follow(FrameContext frame) {
    if (tree == null) {
      sensors.forEach(watched -> watched.sensor.reach(frame, watched.box));
    }
    for (Watched watched = changed.poll(); watched != null; watched = changed.poll()) {
      watched.stale = false;
      if (tree != null) {
        watched.sensor.reach(frame, watched.box);
        tree.moved(watched.item);
        moves++;
      }
    }
    if (tree == null || moves > (long) WORN * sensors.size()) {
      tree = BvhBuilder.build(sensors.size(), (item, out) -> sensors.get(item).box(out));
      moves = 0;
    }
    return tree;
  }

  /** A node that is updated in some frames only. */
  private abstract class Due {
    final int order;
    private boolean queued;

    Due(int order) {
      this.order = order;
    }

    /** Updates the node; returns whether it must be updated in the next frame too. */
    abstract boolean look(FrameContext frame, EventCascade cascade);

    final void queue() {
      if (!queued) {
        queued = true;
        due.add(this);
      }
    }
  }

  /** A node that may sleep. */
  private final class Sleeping extends Due implements Runnable {
    private final SleepableNode sleeper;

    Sleeping(SleepableNode sleeper, int order) {
      super(order);
      this.sleeper = sleeper;
    }

    @Override
    public void run() {
      if (order <= turn && turn != AFTER_ALL) {
        late.add(this); // Its turn in this frame is over.
      } else {
        queue();
      }
    }

    @Override
    boolean look(FrameContext frame, EventCascade cascade) {
      sleeper.frame(frame, cascade);
      return sleeper.awake();
    }
  }

  /** A ProximitySensor and its world-space bounding box; a viewer outside the box is not sensed. */
  private final class Watched extends Due implements NodeObserver {
    private final ProximitySensorNode sensor;
    private final int item = sensors.size();
    private final double[] box = new double[6];
    private boolean stale;

    Watched(ProximitySensorNode sensor, int order) {
      super(order);
      this.sensor = sensor;
    }

    @Override
    boolean look(FrameContext frame, EventCascade cascade) {
      sensor.frame(frame, cascade);
      return sensor.active();
    }

    /** Rounds outwards to float, so that the float box encloses the double box. */
    void box(float[] out) {
      for (int axis = 0; axis < 3; axis++) {
        out[axis] = Math.nextDown((float) box[axis]);
        out[axis + 3] = Math.nextUp((float) box[axis + 3]);
      }
    }

    @Override
    public void changed(Node node, int field) {
      if (sensor.hasBoxOf(field)) {
        change();
        if (order > turn) { // A sensor or clock before it has sent that in this frame.
          queue();
        }
      }
    }

    void change() {
      if (!stale) {
        stale = true;
        changed.add(this);
      }
    }
  }
}
