package org.selectiverenderer.walkthrough.transition;

import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.function.Function;
import org.joml.Quaterniond;
import org.selectiverenderer.browser.LayerView;
import org.selectiverenderer.browser.World;
import org.selectiverenderer.browser.collision.MeshBvhCache;
import org.selectiverenderer.browser.nodes.group.SwitchNode;
import org.selectiverenderer.browser.scene.Node;
import org.selectiverenderer.control.SwitchTiming;
import org.selectiverenderer.control.SwitchVisibility;
import org.selectiverenderer.schema.SwitchTransition;
import org.web3d.x3d.sai.X3DNode;

/**
 * The timing of a world's Switches by a {@link SwitchTransition}. A frame is {@link #begin}, the
 * step of the world, in which the controller asks, and {@link #end}. Nothing is seen before the end
 * of the first frame. Belongs to the thread that steps the world.
 */
public final class TransitionTiming implements SwitchTiming, AutoCloseable {
  private static final SwitchVisibility UNSEEN = new SwitchVisibility(false, 0, 0);

  private record Question(Node node, int shown, int choice) {}

  private final World world;
  private final SwitchTransition transition;
  private final Function<X3DNode, Node> nodes;
  private final VisibilityEstimator estimator;
  private final Quaterniond before = new Quaterniond();
  private final Set<Question> asked = new HashSet<>();

  /** The questions of this frame that were answered with yes. */
  private final Set<Question> granted = new HashSet<>();

  private volatile boolean closed;
  private boolean observing;
  private boolean unfinished;
  private double time = Double.NaN;

  /**
   * Creates the timing of a world that has not been stepped.
   *
   * @param nodes returns the node of the world behind one of the SAI
   */
  public TransitionTiming(World world, SwitchTransition transition, Function<X3DNode, Node> nodes) {
    this.world = world;
    this.transition = transition;
    this.nodes = nodes;
    estimator = new VisibilityEstimator(world);
  }

  /** Estimates from now on what is seen of each change. */
  public void observe() {
    observing = true;
  }

  /**
   * Begins to build on another thread what the rays of frames need, so that the first change of
   * large objects does not hold up its frame. Call it before the first frame.
   */
  public void prepare() {
    if (observing || transition instanceof SwitchTransition.Unseen) {
      List<MeshBvhCache.Task> tasks = estimator.prepare();
      CompletableFuture.runAsync(
          () -> {
            for (int i = 0; i < tasks.size() && !closed; i++) {
              tasks.get(i).run();
            }
          });
    }
  }

  /** Ends what {@link #prepare} has begun. */
  @Override
  public void close() {
    closed = true;
  }

  /**
   * Begins a frame, before the world's step.
   *
   * @param now the time of the frame in seconds
   */
  public void begin(double now) {
    estimator.begin();
    fade(now);
    granted.clear();
    if (!unfinished) {
      asked.clear();
    }
    unfinished = false;
  }

  /** Ends a frame, after the world's step and the controller's last question. */
  public void end() {
    fade(world.time());
    before.set(world.viewer().orientation());
    time = world.time();
  }

  private void fade(double now) {
    if (transition instanceof SwitchTransition.Fade) {
      estimator.layers().forEach(layer -> layer.instances().fades().at(now));
    }
  }

  private boolean nothingSeen() {
    return Double.isNaN(time);
  }

  /** Returns the rate in degrees per second at which the view turns. */
  private double turning() {
    double seconds = world.time() - time;
    double dot = Math.abs(before.dot(new Quaterniond(world.viewer().orientation())));
    return seconds > 0 ? Math.toDegrees(2 * Math.acos(Math.min(1, dot))) / seconds : 0;
  }

  @Override
  public boolean mayShow(X3DNode switchNode, int choice) {
    if (!(transition instanceof SwitchTransition.Unseen unseen)
        || nothingSeen()
        || turning() > unseen.degreesPerSecond()) {
      return true;
    }
    Node node = nodes.apply(switchNode);
    Question question = new Question(node, shown(node), choice);
    if (!asked.add(question)) {
      // Otherwise its turn comes again when the others have had theirs.
      return granted.contains(question);
    }
    Optional<VisibilityEstimator.Estimate> seen =
        estimator.of(node, question.shown(), choice, false);
    if (seen.isEmpty()) {
      asked.remove(question);
      unfinished = true;
      return false;
    }
    return !seen.get().visible() && granted.add(question);
  }

  @Override
  public Optional<SwitchVisibility> shows(X3DNode switchNode, int choice) {
    if (!observing && !(transition instanceof SwitchTransition.Fade)) {
      return Optional.empty();
    }
    Node node = nodes.apply(switchNode);
    Optional<SwitchVisibility> seen = observing ? seen(node, choice) : Optional.empty();
    if (transition instanceof SwitchTransition.Fade fade
        && !nothingSeen()
        && shown(node) != choice) {
      double seconds = fade.milliseconds() / 1000;
      for (LayerView layer : estimator.layers()) {
        layer.instances().fades().begin(node, shown(node), choice, seconds);
      }
    }
    return seen;
  }

  private Optional<SwitchVisibility> seen(Node node, int choice) {
    if (nothingSeen()) {
      return Optional.of(UNSEEN);
    }
    if (granted.contains(new Question(node, shown(node), choice))) {
      return Optional.of(new SwitchVisibility(false, 0, turning()));
    }
    return estimator
        .of(node, shown(node), choice, true)
        .map(of -> new SwitchVisibility(of.visible(), of.pixels(), turning()));
  }

  private static int shown(Node node) {
    return node instanceof SwitchNode versions ? versions.whichChoice() : -1;
  }
}
