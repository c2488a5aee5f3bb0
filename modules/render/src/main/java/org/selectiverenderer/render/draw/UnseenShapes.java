package org.selectiverenderer.render.draw;

import java.util.Arrays;
import java.util.BitSet;
import java.util.Collections;
import java.util.Comparator;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Set;
import java.util.function.ToLongFunction;
import java.util.stream.IntStream;
import org.joml.Vector3dc;
import org.selectiverenderer.browser.instance.InstanceTree;
import org.selectiverenderer.browser.instance.ShapeInstance;
import org.selectiverenderer.render.occlusion.MeshOccluders;

/**
 * The shapes of a large scene that have no draw items, because no eye has seen them yet or has been
 * near them for long. Shapes are in groups of neighbours, which are made ready, and given up,
 * together.
 *
 * <p>Shapes are numbered by their place in {@link InstanceTree#shapes()}.
 */
final class UnseenShapes {
  /**
   * How much of a scene is made ready at a time.
   *
   * @param large the triangles (shown or hidden) above which shapes wait until they are seen; a
   *     smaller scene is made ready as a whole
   * @param group the triangles of a group
   * @param ahead the triangles that are made ready before they are seen, nearest first
   * @param most the triangles above which groups that are not in view are given up, farthest first
   */
  record Limits(long large, long group, long ahead, long most) {
    static final Limits USUAL = new Limits(2_000_000, 32_768, 1_000_000, 4_000_000);
  }

  /** Bounds the rounding of a shape's vertices in a batch by that in its own coordinates. */
  private static final double BATCHED = 2;

  private final Limits limits;
  private final BitSet unseen = new BitSet();
  private List<ShapeInstance> shapes = List.of();
  private List<int[]> groups = List.of();
  private int[] groupOf = {};
  private double[][] boxes = {};

  /** The number of unseen shapes that each group still has. */
  private int[] left = {};

  /** The group that is made ready ahead; -1 for none. */
  private int chosen = -1;

  private double terms;
  private double pixels;

  UnseenShapes(Limits limits) {
    this.limits = limits;
  }

  Limits limits() {
    return limits;
  }

  boolean isEmpty() {
    return unseen.isEmpty();
  }

  /** Returns the places of all of them, as they are now. */
  IntStream all() {
    return unseen.stream().boxed().toList().stream().mapToInt(Integer::intValue);
  }

  boolean contains(int place) {
    return unseen.get(place);
  }

  /** Returns whether the shapes of the scene are in groups. */
  boolean grouped() {
    return !groups.isEmpty();
  }

  /** Bounds the rounding error of drawing any of them, as {@link Culler.Items#terms}. */
  double terms() {
    return terms;
  }

  /** Bounds the pixels by which any of them reaches beyond its box. */
  double pixels() {
    return pixels;
  }

  void clear() {
    unseen.clear();
    shapes = List.of();
    groups = List.of();
    groupOf = new int[0];
    boxes = new double[0][];
    left = new int[0];
    chosen = -1;
    terms = 0;
    pixels = 0;
  }

  /**
   * Groups the shapes of a tree that is new, if they are many.
   *
   * @param cost the cost of making a shape ready, in triangles
   * @return whether they are: then all but those that may be drawn out of their boxes are unseen
   */
  boolean begin(InstanceTree tree, ToLongFunction<ShapeInstance> cost) {
    clear();
    if (!large(tree, cost)) {
      return false;
    }
    group(tree, cost);
    for (int place = 0; place < shapes.size(); place++) {
      if (canWait(shapes.get(place))) {
        add(place);
      }
    }
    return true;
  }

  private boolean large(InstanceTree tree, ToLongFunction<ShapeInstance> cost) {
    return tree.shapes().stream().mapToLong(cost).sum() > limits.large();
  }

  /**
   * Groups the shapes anew after the tree's structure has changed; those unseen stay so. A scene
   * that has grown large is grouped from then on: what is far is given up.
   */
  void regroup(InstanceTree tree, ToLongFunction<ShapeInstance> cost) {
    if (!grouped() && !large(tree, cost)) {
      return;
    }
    Set<ShapeInstance> before = Collections.newSetFromMap(new IdentityHashMap<>());
    unseen.stream().forEach(place -> before.add(shapes.get(place)));
    clear();
    group(tree, cost);
    for (int place = 0; place < shapes.size(); place++) {
      if (before.contains(shapes.get(place)) && canWait(shapes.get(place))) {
        add(place);
      }
    }
  }

  private void group(InstanceTree tree, ToLongFunction<ShapeInstance> cost) {
    shapes = tree.shapes();
    groups = tree.boxes().groups(place -> cost.applyAsLong(shapes.get(place)), limits.group());
    groupOf = new int[shapes.size()];
    boxes = new double[groups.size()][];
    left = new int[groups.size()];
    for (int group = 0; group < groups.size(); group++) {
      int[] places = groups.get(group);
      Arrays.sort(places);
      double[] box = shapes.get(places[0]).bounds().clone();
      for (int place : places) {
        groupOf[place] = group;
        for (int axis = 0; axis < 3; axis++) {
          box[axis] = Math.min(box[axis], shapes.get(place).bounds()[axis]);
          box[axis + 3] = Math.max(box[axis + 3], shapes.get(place).bounds()[axis + 3]);
        }
      }
      boxes[group] = box;
    }
  }

  /** Returns whether a shape can wait until an eye sees its box. */
  private static boolean canWait(ShapeInstance shape) {
    return shape.programs().isEmpty() && shape.mesh().isPresent();
  }

  private void add(int place) {
    unseen.set(place);
    left[groupOf[place]]++;
    bound(place);
  }

  /**
   * Makes the shapes of a group unseen again, but for those that may be drawn out of their boxes.
   *
   * @return the places of those that are unseen now and were not
   */
  BitSet giveUp(int group) {
    BitSet gone = new BitSet();
    for (int place : groups.get(group)) {
      if (!unseen.get(place) && canWait(shapes.get(place))) {
        gone.set(place);
        add(place);
      }
    }
    return gone;
  }

  /**
   * Follows a change of an unseen shape; if it may be drawn out of its box now, it is no longer
   * one.
   */
  void changed(int place) {
    if (canWait(shapes.get(place))) {
      bound(place);
    } else {
      remove(place);
    }
  }

  private void bound(int place) {
    ShapeInstance shape = shapes.get(place);
    shape
        .mesh()
        .ifPresent(
            mesh -> {
              terms = Math.max(terms, BATCHED * MeshOccluders.of(mesh).terms(shape.world()));
              pixels = Math.max(pixels, Culler.pixels(shape.stroke(), mesh.primitive()));
            });
  }

  /** Removes a shape that is made ready now. */
  void remove(int place) {
    if (unseen.get(place)) {
      unseen.clear(place);
      left[groupOf[place]]--;
    }
  }

  /** Returns the group of a shape. */
  int group(int place) {
    return groupOf[place];
  }

  /** Returns the places of the unseen shapes of a group, in ascending order. */
  IntStream unseen(int group) {
    return Arrays.stream(groups.get(group)).filter(unseen::get);
  }

  /** Returns the groups of some shapes, nearest first. */
  int[] groups(BitSet places, Vector3dc eye) {
    return places.stream()
        .map(place -> groupOf[place])
        .distinct()
        .boxed()
        .sorted(Comparator.comparingDouble(group -> distance(group, eye)))
        .mapToInt(Integer::intValue)
        .toArray();
  }

  /**
   * Returns a near group with an unseen shape, or -1: the nearest one when it is chosen, then the
   * same until it has none.
   */
  int near(Vector3dc eye) {
    if (chosen < 0 || left[chosen] == 0) {
      chosen = nearest(eye);
    }
    return chosen;
  }

  private int nearest(Vector3dc eye) {
    int best = -1;
    double nearest = Double.POSITIVE_INFINITY;
    for (int group = 0; group < left.length; group++) {
      if (left[group] > 0 && (best < 0 || distance(group, eye) < nearest)) {
        nearest = distance(group, eye);
        best = group;
      }
    }
    return best;
  }

  /**
   * Returns the farthest group all of whose shapes are ready, or -1.
   *
   * @param kept groups that are left out
   */
  int farthest(Vector3dc eye, BitSet kept) {
    int best = -1;
    double farthest = 0;
    for (int group = 0; group < left.length; group++) {
      if (left[group] == 0 && !kept.get(group) && distance(group, eye) > farthest) {
        farthest = distance(group, eye);
        best = group;
      }
    }
    return best;
  }

  /** Returns the square of the distance to the box in which a group was made. */
  private double distance(int group, Vector3dc eye) {
    double[] box = boxes[group];
    double sum = 0;
    for (int axis = 0; axis < 3; axis++) {
      double before =
          Math.max(0, Math.max(box[axis] - eye.get(axis), eye.get(axis) - box[axis + 3]));
      sum += before * before;
    }
    return sum;
  }
}
