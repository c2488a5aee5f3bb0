package org.selectiverenderer.walkthrough.budget;

import java.util.ArrayList;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;
import java.util.function.Supplier;
import org.joml.Vector3dc;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.decimal.Pluralizer;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.browser.LayerView;
import org.selectiverenderer.browser.World;
import org.selectiverenderer.browser.instance.InstanceTree;
import org.selectiverenderer.browser.scene.Node;
import org.selectiverenderer.control.ChoosableObject;
import org.selectiverenderer.control.SelectiveController;
import org.selectiverenderer.control.budget.FrameTimeRegulator;
import org.selectiverenderer.control.budget.MultipleChoiceKnapsack;
import org.selectiverenderer.control.budget.RenderingBudget;
import org.web3d.x3d.sai.X3DNode;

/**
 * Chooses in every frame the versions of a scene's objects that lose least within a budget. What is
 * no enriched object, or is held, costs what it costs and is subtracted from the budget.
 *
 * <p>Belongs to the thread that steps the world.
 */
public final class VersionBudget {
  /**
   * A version takes the triangles of another if it is worth twice as much: so much more, as a
   * share.
   */
  private static final double HYSTERESIS = 1;

  private final World world;
  private final SelectiveController controller;
  private final Function<X3DNode, Node> nodes;
  private final RenderingBudget budget;
  private final FrameTimeRegulator regulator;
  private Supplier<? extends Optional<? extends Vector3dc>> gaze = Optional::empty;

  private List<ChoosableObject> objects = List.of();
  private @Nullable InstanceTree tree;
  private long structure;
  private long choices;
  private long consistency;
  private ObjectPlaces places;
  private MultipleChoiceKnapsack problem;
  private long chosenCost;
  private long mostCost;
  private long fixed;
  private long triangles;
  private double lastDrawn = Double.NaN;
  private boolean toldTooSmall;
  private boolean toldOfLayers;

  /**
   * Keeps a world within a budget from now on: it chooses in every step.
   *
   * @param controller through which it shows the versions
   * @param nodes returns the node behind an object of the SAI
   */
  public VersionBudget(
      World world,
      SelectiveController controller,
      Function<X3DNode, Node> nodes,
      RenderingBudget budget) {
    this.world = world;
    this.controller = controller;
    this.nodes = nodes;
    this.budget = budget;
    regulator = new FrameTimeRegulator(budget.amount());
    problem = new MultipleChoiceKnapsack(List.of(), HYSTERESIS);
    places = new ObjectPlaces(List.of(), world.instances(), nodes);
    world.onSettled(this::choose);
  }

  /**
   * Lets objects count less that are away from where the eyes look.
   *
   * @param direction returns the direction of the gaze as a unit vector in the viewer's frame;
   *     empty while it is not known
   */
  public void gaze(Supplier<? extends Optional<? extends Vector3dc>> direction) {
    gaze = direction;
  }

  /**
   * Hears that a frame has been drawn. For a budget of milliseconds, what counts is the time from
   * one frame to the next.
   *
   * @param seconds time of any clock
   */
  public void drawn(double seconds) {
    if (!Double.isNaN(lastDrawn)) {
      regulator.frame((seconds - lastDrawn) * 1000, world.shownPolygons());
    }
    lastDrawn = seconds;
  }

  /** Returns what the budget is. */
  public RenderingBudget budget() {
    return budget;
  }

  /** Returns the triangles that the scene may have now. */
  public long triangles() {
    return triangles;
  }

  /** Returns how many objects were measured as the structure last changed, for the test. */
  int measured() {
    return places.measured();
  }

  private void choose() {
    InstanceTree now = world.instances();
    List<ChoosableObject> choosable = controller.choosable();
    boolean other = choosable != objects || now != tree || structure != now.structureVersion();
    if (other) {
      restructure(choosable, now);
    } else if (places.stale(now)) {
      places.moved(now);
    }
    if (other || places.nested() || choices != now.choiceVersion()) {
      choices = now.choiceVersion(); // Others have changed Switches too.
      count();
    }
    fixed = world.shownPolygons() - chosenCost;
    if (other || consistency != controller.consistencyVersion()) {
      consistency = controller.consistencyVersion();
      places.readConsistency();
    }
    places.weigh(world.viewer(), gaze.get(), problem::weigh);
    triangles = allowed();
    problem.solve(triangles - fixed);
    double time = world.cascade().time();
    if (other) {
      for (int i = 0; i < objects.size(); i++) {
        if (places.count(i) > 0) {
          show(i, time);
        }
      }
      tellOfLayers();
    } else {
      problem.forEachChanged(i -> show(i, time));
    }
  }

  /** Tells, once, of objects that are seen only in layers of which the budget knows nothing. */
  private void tellOfLayers() {
    List<Node> apart = new ArrayList<>();
    for (LayerView layer : toldOfLayers ? List.<LayerView>of() : world.layers()) {
      for (int i = 0; i < objects.size(); i++) {
        if (places.count(i) == 0 && !layer.instances().instances(places.node(i)).isEmpty()) {
          apart.add(places.node(i));
        }
      }
    }
    if (apart.isEmpty()) {
      return;
    }
    toldOfLayers = true;
    Node first = apart.get(0);
    world
        .problems()
        .warning(
            first.location(),
            "%s is in a layer that is not the active one%s; a budget leaves its version as it is"
                .formatted(
                    first.name() == null ? "a Switch" : "\"" + first.name() + "\"",
                    apart.size() == 1
                        ? ""
                        : ", like " + Pluralizer.of(apart.size() - 1, "other object")));
  }

  /** Follows a change of the scene's structure; objects that stay keep what was chosen. */
  private void restructure(List<ChoosableObject> choosable, InstanceTree now) {
    Map<Node, Integer> before = new IdentityHashMap<>();
    for (int i = 0; i < objects.size(); i++) {
      before.put(places.node(i), problem.choice(i));
    }
    places = now == tree ? places.after(choosable, now) : new ObjectPlaces(choosable, now, nodes);
    objects = choosable;
    tree = now;
    structure = now.structureVersion();
    problem = new MultipleChoiceKnapsack(places.choices(), HYSTERESIS);
    for (int i = 0; i < objects.size(); i++) {
      Integer chosen = before.get(places.node(i));
      if (chosen != null) {
        problem.resume(i, chosen);
      }
    }
  }

  private void show(int object, double time) {
    ChoosableObject chosen = objects.get(object);
    int before = chosen.shown();
    controller.choose(chosen, problem.choice(object), time);
    if (chosen.shown() != before) {
      chosenCost += places.cost(object, chosen.shown()) - places.cost(object, before);
      choices += places.count(object); // In each of its places a group has another choice.
    }
  }

  /** Finds out which objects are shown, and what they cost. */
  private void count() {
    chosenCost = 0;
    mostCost = 0;
    for (int i = 0; i < objects.size(); i++) {
      boolean there = places.shown(i);
      problem.present(i, there);
      if (there) {
        chosenCost += places.cost(i, objects.get(i).shown());
        mostCost += places.mostCost(i);
      }
    }
  }

  private long allowed() {
    long least = fixed + problem.leastCost();
    if (budget.unit() == RenderingBudget.Unit.MS) {
      return regulator.triangles(least, fixed + mostCost);
    }
    long wanted = (long) budget.amount();
    if (wanted < least && !toldTooSmall) {
      toldTooSmall = true;
      world
          .problems()
          .info(
              SourceLocation.of(world.scene().url()),
              (objects.isEmpty()
                      ? "the budget of %d triangles is less than the %d of the scene, in which no"
                          + " object has versions with metadata to choose from"
                      : "the budget of %d triangles is less than the %d of the scene with the"
                          + " smallest versions of all objects, which are shown")
                  .formatted(wanted, least));
    }
    return wanted;
  }
}
