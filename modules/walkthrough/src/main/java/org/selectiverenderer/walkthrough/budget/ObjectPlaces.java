package org.selectiverenderer.walkthrough.budget;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Function;
import org.joml.Matrix4d;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.browser.instance.GroupInstance;
import org.selectiverenderer.browser.instance.Instance;
import org.selectiverenderer.browser.instance.InstanceTree;
import org.selectiverenderer.browser.instance.SubtreeMeasurement;
import org.selectiverenderer.browser.scene.Node;
import org.selectiverenderer.browser.viewer.Viewer;
import org.selectiverenderer.control.ChoosableObject;
import org.selectiverenderer.control.budget.VersionChoices;
import org.selectiverenderer.control.budget.VersionLoss;
import org.selectiverenderer.geometry.BoundingBox;
import org.web3d.x3d.sai.X3DNode;

/**
 * Where the objects of a scene stand, what their versions cost, and how they look from the viewer.
 * An object that is USEd in several places costs, and is seen, in all of them.
 *
 * <p>The numbers stand in arrays, since all of them are needed in every frame.
 */
public final class ObjectPlaces {
  /**
   * The size of an object in one place.
   *
   * @param radius of a sphere around it
   * @param disc radius of a disc as large as its mean shadow
   * @param localMiddle in the coordinates of the place
   */
  private record Size(double radius, double disc, Vector3d localMiddle) {}

  private final List<ChoosableObject> objects;
  private final Function<X3DNode, Node> nodes;
  private final long structure;
  private final Set<Node> switches;
  private final Node[] switchNodes;
  private final List<VersionChoices> choices = new ArrayList<>();
  private final Instance[][] instances;
  private final long[][] costs;
  private boolean nested;
  private int measured;

  /** For each object: the first of its places; one more at the end. */
  private final int[] first;

  private final List<Instance> places = new ArrayList<>();
  private final List<Vector3d> localMiddles;
  private final double[] x;
  private final double[] y;
  private final double[] z;

  /** For each place: the radius of a sphere around the object. */
  private final double[] radius;

  /** For each place: the radius of a disc as large as the object's mean shadow. */
  private final double[] disc;

  /** For each object: how much its losses count for its consistency. */
  private final double[] unexpected;

  private long placement;

  /**
   * Measures all versions of objects.
   *
   * @param objects whose places and versions are measured
   * @param tree the instances of the scene that has them
   * @param nodes returns the node behind an object of the SAI
   */
  public ObjectPlaces(
      List<ChoosableObject> objects, InstanceTree tree, Function<X3DNode, Node> nodes) {
    this(objects, tree, nodes, null);
  }

  private ObjectPlaces(
      List<ChoosableObject> objects,
      InstanceTree tree,
      Function<X3DNode, Node> nodes,
      @Nullable ObjectPlaces before) {
    this.objects = objects;
    this.nodes = nodes;
    structure = tree.structureVersion();
    switches = Collections.newSetFromMap(new IdentityHashMap<>());
    objects.forEach(object -> switches.add(nodes.apply(object.node())));
    int count = objects.size();
    first = new int[count + 1];
    unexpected = new double[count];
    switchNodes = new Node[count];
    instances = new Instance[count][];
    costs = new long[count][];
    List<Size> sizes = new ArrayList<>();
    Map<Node, Integer> unchanged = before == null ? Map.of() : before.unchanged(switches, tree);
    for (int i = 0; i < count; i++) {
      Node node = nodes.apply(objects.get(i).node());
      List<Instance> found = tree.instances(node);
      switchNodes[i] = node;
      instances[i] = found.toArray(Instance[]::new);
      Integer known = unchanged.get(node);
      costs[i] =
          before != null && known != null && before.costs[known].length == versions(i)
              ? takeOver(before, known, sizes)
              : measure(found, versions(i), sizes);
      choices.add(choices(costs[i], found.size()));
      first[i + 1] = places.size();
    }
    localMiddles = sizes.stream().map(Size::localMiddle).toList();
    radius = sizes.stream().mapToDouble(Size::radius).toArray();
    disc = sizes.stream().mapToDouble(Size::disc).toArray();
    x = new double[sizes.size()];
    y = new double[sizes.size()];
    z = new double[sizes.size()];
    Arrays.fill(unexpected, 1);
    moved(tree);
  }

  private int versions(int object) {
    return objects.get(object).versions();
  }

  /**
   * Measures objects after a change of the scene's structure. What was measured here and has not
   * changed is taken over.
   */
  ObjectPlaces after(List<ChoosableObject> now, InstanceTree tree) {
    return new ObjectPlaces(now, tree, nodes, this);
  }

  /** Returns the numbers of the objects whose instances are still those that were measured. */
  private Map<Node, Integer> unchanged(Set<Node> switchesNow, InstanceTree tree) {
    Map<Node, Integer> unchanged = new IdentityHashMap<>();
    if (nested || !switches.equals(switchesNow)) {
      return unchanged; // A version may have another object inside, or one less.
    }
    for (int i = 0; i < switchNodes.length; i++) {
      List<Instance> now = tree.instances(switchNodes[i]);
      boolean same = now.size() == instances[i].length;
      for (int place = 0; same && place < now.size(); place++) {
        same =
            now.get(place) == instances[i][place]
                && ((GroupInstance) now.get(place)).restructured() <= structure;
      }
      if (same) {
        unchanged.put(switchNodes[i], i);
      }
    }
    return unchanged;
  }

  private long[] takeOver(ObjectPlaces before, int object, List<Size> sizes) {
    for (int place = before.first[object]; place < before.first[object + 1]; place++) {
      places.add(before.places.get(place));
      sizes.add(
          new Size(before.radius[place], before.disc[place], before.localMiddles.get(place)));
    }
    return before.costs[object];
  }

  /** Adds an object's places and their sizes; returns the triangles of its versions. */
  private long[] measure(List<Instance> found, int versions, List<Size> sizes) {
    measured++;
    long[] triangles = new long[versions];
    for (Instance instance : found) {
      List<Instance> children = ((GroupInstance) instance).children();
      BoundingBox all = BoundingBox.EMPTY;
      for (int version = 0; version < Math.min(versions, children.size()); version++) {
        // An object inside an object is chosen for itself.
        SubtreeMeasurement measured =
            SubtreeMeasurement.of(
                children.get(version),
                node -> {
                  boolean inner = switches.contains(node);
                  nested |= inner;
                  return inner;
                });
        triangles[version] += measured.triangles();
        all = all.union(measured.bounds());
      }
      if (!all.isEmpty()) {
        places.add(instance);
        sizes.add(size(instance, all));
      }
    }
    return triangles;
  }

  private static VersionChoices choices(long[] costs, int places) {
    return new VersionChoices(
        Arrays.stream(costs).boxed().toList(),
        Arrays.stream(costs)
            .mapToObj(cost -> VersionLoss.ofTriangles(cost / Math.max(1, places)))
            .toList());
  }

  /**
   * Returns the size of an object by its box: the mean shadow of a convex body is a quarter of its
   * surface (Cauchy).
   */
  private static Size size(Instance place, BoundingBox box) {
    double w = box.width();
    double h = box.height();
    double d = box.depth();
    Vector3d middle = box.min().add(box.max()).mul(0.5);
    Matrix4d inverse = place.world().invert(new Matrix4d());
    return new Size(
        Math.sqrt(w * w + h * h + d * d) / 2,
        Math.sqrt((w * h + h * d + d * w) / 2 / Math.PI),
        // Under a scale of 0 the object has no extent either, and stays where it is.
        inverse.isFinite() ? inverse.transformPosition(middle) : middle);
  }

  /** Moves the objects to where their instances are now. */
  void moved(InstanceTree tree) {
    placement = tree.placementVersion();
    Vector3d middle = new Vector3d();
    for (int place = 0; place < x.length; place++) {
      places.get(place).world().transformPosition(localMiddles.get(place), middle);
      x[place] = middle.x;
      y[place] = middle.y;
      z[place] = middle.z;
    }
  }

  /**
   * Reads how consistent the objects are now with the active schemas; before the first call all
   * count as inconsistent.
   */
  public void readConsistency() {
    for (int object = 0; object < unexpected.length; object++) {
      unexpected[object] = VersionLoss.weightOfConsistency(objects.get(object).consistency());
    }
  }

  /** Returns whether objects may have moved since they were last placed. */
  boolean stale(InstanceTree tree) {
    return placement != tree.placementVersion();
  }

  /** Returns the versions of the objects, in their order. */
  public List<VersionChoices> choices() {
    return choices;
  }

  /** Returns the triangles of a version; 0 for none. */
  public long cost(int object, int version) {
    return version >= 0 && version < costs[object].length ? costs[object][version] : 0;
  }

  /** Returns the triangles of the version that has most. */
  public long mostCost(int object) {
    long most = 0;
    for (long cost : costs[object]) {
      most = Math.max(most, cost);
    }
    return most;
  }

  /** Returns the distance of a point from the middle of the nearest place of an object. */
  public double distance(int object, Vector3dc point) {
    double nearest = Double.POSITIVE_INFINITY;
    for (int place = first[object]; place < first[object + 1]; place++) {
      nearest = Math.min(nearest, point.distance(x[place], y[place], z[place]));
    }
    return nearest;
  }

  /** Returns the radius of a disc as large as the mean shadow of the object; 0 for none. */
  public double radius(int object) {
    return first[object] < first[object + 1] ? disc[first[object]] : 0;
  }

  /** Returns how many objects were measured, rather than taken over. */
  int measured() {
    return measured;
  }

  /** Returns the Switch of an object. */
  Node node(int object) {
    return switchNodes[object];
  }

  /** Returns the number of places of an object. */
  int count(int object) {
    return instances[object].length;
  }

  /** Returns whether a version contains another object, so that a choice shows or hides it. */
  boolean nested() {
    return nested;
  }

  /** Returns whether an object is shown anywhere, in whatever version. */
  boolean shown(int object) {
    for (Instance instance : instances[object]) {
      if (instance.shown()) {
        return true;
      }
    }
    return false;
  }

  /** Receives the weights of objects. */
  public interface Weights {
    /** Receives the weight of the object of a number. */
    void weigh(int object, double weight);
  }

  /**
   * Weighs all objects as the viewer sees them: by the size in the view, by whether they are in it,
   * by the gaze, and by their consistency with the active schemas.
   *
   * @param gaze where the eyes look, as a unit vector in the viewer's frame; empty if unknown
   */
  public void weigh(Viewer viewer, Optional<? extends Vector3dc> gaze, Weights to) {
    double eyeX = viewer.position().x();
    double eyeY = viewer.position().y();
    double eyeZ = viewer.position().z();
    Vector3d ahead = viewer.orientation().transform(new Vector3d(0, 0, -1));
    Vector3d looked =
        gaze.map(direction -> viewer.orientation().transform(direction, new Vector3d()))
            .orElse(null);
    // A cone with the field of view as its half angle holds the picture at usual aspect ratios,
    // and what is about to come into it.
    double edge = Math.cos(Math.min(viewer.fieldOfView(), Math.PI / 2));
    for (int object = 0; object < unexpected.length; object++) {
      double seen = 0;
      for (int place = first[object]; place < first[object + 1]; place++) {
        double dx = x[place] - eyeX;
        double dy = y[place] - eyeY;
        double dz = z[place] - eyeZ;
        double distance = Math.sqrt(dx * dx + dy * dy + dz * dz);
        double along = dx * ahead.x + dy * ahead.y + dz * ahead.z;
        boolean inView = along >= edge * distance - radius[place];
        double weight =
            VersionLoss.sizeInView(disc[place], distance) * VersionLoss.weightOfView(inView);
        if (looked != null) {
          double toGaze = (dx * looked.x + dy * looked.y + dz * looked.z) / distance;
          weight *= VersionLoss.weightOfGaze(eccentricity(toGaze, radius[place] / distance));
        }
        seen += weight;
      }
      to.weigh(object, seen * unexpected[object]);
    }
  }

  /**
   * Returns the degrees between the gaze and the nearest of a sphere.
   *
   * @param cosine of the angle to its middle; not a number where the eye is there
   * @param sine of the angle that its radius takes
   */
  private static double eccentricity(double cosine, double sine) {
    if (!(sine < 1)) {
      return 0; // The eye is inside.
    }
    double angle = Math.acos(Math.max(-1, Math.min(1, cosine))) - Math.asin(sine);
    return Math.max(0, Math.toDegrees(angle));
  }
}
