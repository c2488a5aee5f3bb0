package org.selectiverenderer.runtime;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.PriorityQueue;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.geometry.tree.BoxTree;
import org.selectiverenderer.geometry.tree.BoxTreeBuilder;
import org.selectiverenderer.runtime.nodes.sensor.Frame;
import org.selectiverenderer.runtime.nodes.sensor.FrameNode;
import org.selectiverenderer.runtime.nodes.sensor.ProximitySensorNode;
import org.selectiverenderer.runtime.nodes.sensor.Sleeper;
import org.selectiverenderer.runtime.scene.Cascade;
import org.selectiverenderer.runtime.scene.Node;
import org.selectiverenderer.runtime.scene.NodeObserver;

/**
 * Has the sensors and clocks of a scene look at each frame, in their order. Of ProximitySensors
 * only those look that can have something to say: the viewer is at their box, or was in it, or what
 * a sensor before them sent has changed their box in this very frame; of {@link Sleeper}s those
 * that are awake. The events are those of a round through all of them; what a frame costs depends
 * on the sensors near the viewer.
 */
final class FrameRound {
  /** Changed boxes per sensor after which the tree's shape is worth making anew. */
  private static final int WORN = 4;

  private static final int BEFORE_ALL = -1;
  private static final int AFTER_ALL = Integer.MAX_VALUE;

  private record Turn(int order, FrameNode node) {}

  private final List<FrameNode> nodes;
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
  private @Nullable BoxTree tree;
  private long moves;
  private int turn = AFTER_ALL;

  /**
   * @param nodes in the order in which they look
   */
  FrameRound(List<FrameNode> nodes) {
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
      } else if (nodes.get(order) instanceof Sleeper sleeper) {
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

  /** Whether it is a round of these nodes in this order. */
  boolean isOf(List<FrameNode> others) {
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

  /** A node stands elsewhere than in the frame before; any node, not during {@link #frame}. */
  void moved(Node node) {
    Watched watched = byNode.get(node);
    if (watched != null) {
      watched.change();
    }
  }

  /** Leaves the nodes without an observer. */
  void close() {
    sensors.forEach(watched -> watched.sensor.removeObserver(watched));
    sleepers.forEach(sleeping -> sleeping.sleeper.wakeBy(null));
  }

  /**
   * One frame.
   *
   * @return how many nodes have looked at it
   */
  int frame(Frame frame, Cascade cascade) {
    BoxTree boxes = follow(frame);
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

  /** The tree with every sensor's box where it is now. */
  private BoxTree follow(Frame frame) {
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
      tree = BoxTreeBuilder.build(sensors.size(), (item, out) -> sensors.get(item).box(out));
      moves = 0;
    }
    return tree;
  }

  /** A node that looks at some frames only. */
  private abstract class Due {
    final int order;
    private boolean queued;

    Due(int order) {
      this.order = order;
    }

    /** Looks at a frame; returns whether it is to look at the next one too. */
    abstract boolean look(Frame frame, Cascade cascade);

    final void queue() {
      if (!queued) {
        queued = true;
        due.add(this);
      }
    }
  }

  /** A node that may rest. */
  private final class Sleeping extends Due implements Runnable {
    private final Sleeper sleeper;

    Sleeping(Sleeper sleeper, int order) {
      super(order);
      this.sleeper = sleeper;
    }

    @Override
    public void run() {
      if (order <= turn && turn != AFTER_ALL) {
        late.add(this); // It has had its turn in this frame.
      } else {
        queue();
      }
    }

    @Override
    boolean look(Frame frame, Cascade cascade) {
      sleeper.frame(frame, cascade);
      return sleeper.awake();
    }
  }

  /** A ProximitySensor and the box in the world out of which it senses nothing. */
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
    boolean look(Frame frame, Cascade cascade) {
      sensor.frame(frame, cascade);
      return sensor.active();
    }

    /** Rounds outwards, so that no float box is smaller than what it stands for. */
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
