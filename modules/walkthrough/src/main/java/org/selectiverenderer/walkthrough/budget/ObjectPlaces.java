package org.selectiverenderer.walkthrough.budget;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.Function;
import org.joml.Matrix4d;
import org.joml.Vector3d;
import org.joml.Vector3dc;
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
  private final List<ChoosableObject> objects;
  private final List<VersionChoices> choices = new ArrayList<>();
  private final Instance[][] instances;
  private final long[][] costs;
  private boolean nested;

  /** For each object: the first of its places; one more at the end. */
  private final int[] first;

  private final List<Instance> places = new ArrayList<>();
  private final List<Vector3d> localMiddles = new ArrayList<>();
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
    this.objects = objects;
    Set<Node> switches = new HashSet<>();
    objects.forEach(object -> switches.add(nodes.apply(object.node())));
    first = new int[objects.size() + 1];
    unexpected = new double[objects.size()];
    instances = new Instance[objects.size()][];
    costs = new long[objects.size()][];
    List<BoundingBox> bounds = new ArrayList<>();
    for (int i = 0; i < objects.size(); i++) {
      List<Instance> found = tree.instances(nodes.apply(objects.get(i).node()));
      instances[i] = found.toArray(Instance[]::new);
      costs[i] = measure(objects.get(i), found, switches, bounds);
      choices.add(choices(costs[i], found.size()));
      first[i + 1] = places.size();
    }
    int count = places.size();
    x = new double[count];
    y = new double[count];
    z = new double[count];
    radius = new double[count];
    disc = new double[count];
    for (int place = 0; place < count; place++) {
      size(place, bounds.get(place));
    }
    Arrays.fill(unexpected, 1);
    moved(tree);
  }

  /** Adds an object's places and their bounds; returns the triangles of its versions. */
  private long[] measure(
      ChoosableObject object, List<Instance> found, Set<Node> switches, List<BoundingBox> bounds) {
    int versions = object.versions();
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
        bounds.add(all);
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
   * Sets the size of an object by its box: the mean shadow of a convex body is a quarter of its
   * surface (Cauchy).
   */
  private void size(int place, BoundingBox box) {
    double w = box.width();
    double h = box.height();
    double d = box.depth();
    radius[place] = Math.sqrt(w * w + h * h + d * d) / 2;
    disc[place] = Math.sqrt((w * h + h * d + d * w) / 2 / Math.PI);
    Vector3d middle = box.min().add(box.max()).mul(0.5);
    Matrix4d inverse = places.get(place).world().invert(new Matrix4d());
    // Under a scale of 0 the object has no extent either, and stays where it is.
    localMiddles.add(inverse.isFinite() ? inverse.transformPosition(middle) : middle);
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
