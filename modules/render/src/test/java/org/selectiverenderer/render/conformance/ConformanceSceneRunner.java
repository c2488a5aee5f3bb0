package org.selectiverenderer.render.conformance;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.joml.Vector3d;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.browser.PointingDeviceState;
import org.selectiverenderer.browser.World;
import org.selectiverenderer.browser.loading.SceneLoader;
import org.selectiverenderer.browser.nodes.NodeFactory;
import org.selectiverenderer.browser.nodes.keyboard.KeyboardEvent;
import org.selectiverenderer.browser.scene.Node;
import org.selectiverenderer.browser.viewer.Viewer;
import org.selectiverenderer.browser.viewer.ViewerMotion;
import org.selectiverenderer.x3d.catalogue.FieldDefinition;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.source.ReadLimits;

/**
 * Runs a conformance scene with the frames and actions that its head lists, and records events,
 * values and problems.
 */
final class ConformanceSceneRunner implements AutoCloseable {
  private final ProblemCollector problems = new ProblemCollector();
  private final SceneLoader loader =
      new SceneLoader(NodeCatalogue.load(), new NodeFactory(), ReadLimits.standard(), problems);
  private final World world;
  private final List<FieldEvent> events = new ArrayList<>();
  private boolean pressed;

  /** Loads the scene and steps all its frames. */
  ConformanceSceneRunner(ConformanceScene scene) throws IOException {
    try {
      world = new World(loader.load(scene.file()), problems);
      world.epoch(0); // So that scenes may name the times of their frames.
      scene.watched().forEach(this::watch);
      for (Map.Entry<Double, List<String>> frame : scene.frames().entrySet()) {
        ViewerMotion motion = (viewer, time, dt) -> {};
        for (String action : frame.getValue()) {
          motion = act(action, motion);
        }
        world.step(frame.getKey(), motion);
      }
    } catch (IOException | RuntimeException | Error e) {
      loader.close();
      throw e;
    }
  }

  World world() {
    return world;
  }

  List<FieldEvent> events() {
    return events;
  }

  /** Returns the problems reported for the scene, in order. */
  List<Problem> told() {
    return problems.list();
  }

  /** Returns the value of a field after the last frame. */
  FieldEvent value(String nodeAndField) {
    Node node = node(nodeAndField);
    FieldDefinition field = field(node, nodeAndField);
    return new FieldEvent(world.time(), nodeAndField, field.type(), node.value(field.index()));
  }

  private void watch(String nodeAndField) {
    Node node = node(nodeAndField);
    FieldDefinition field = field(node, nodeAndField);
    node.addListener(
        field.index(),
        (from, index, value, time) ->
            events.add(new FieldEvent(time, nodeAndField, field.type(), value)));
  }

  private Node node(String nodeAndField) {
    return find(nodeAndField.substring(0, nodeAndField.lastIndexOf('.')))
        .orElseThrow(() -> new IllegalArgumentException("no node is named in " + nodeAndField));
  }

  private Optional<Node> find(String name) {
    return world
        .scene()
        .find(name)
        .or(() -> Optional.ofNullable(world.scene().imported().get(name)));
  }

  private static FieldDefinition field(Node node, String nodeAndField) {
    String name = nodeAndField.substring(nodeAndField.lastIndexOf('.') + 1);
    return node.type()
        .field(name)
        .or(() -> node.type().output(name))
        .or(() -> node.type().input(name))
        .orElseThrow(() -> new IllegalArgumentException(node.type() + " has no field " + name));
  }

  /** Executes the actions before a frame; returns the motion of the viewer in it. */
  private ViewerMotion act(String action, ViewerMotion motion) {
    String words = ConformanceScene.rest(action, 1);
    switch (ConformanceScene.word(action, 0)) {
      case "viewer" -> {
        return move(words.split("\\s+"));
      }
      case "pointer" -> point(words.split("\\s+"));
      case "key" ->
          world
              .keys()
              .type(
                  new KeyboardEvent(
                      key(ConformanceScene.word(words, 0)),
                      ConformanceScene.word(words, 1).equals("down")));
      case "set" -> set(ConformanceScene.word(words, 0), ConformanceScene.rest(words, 1));
      default -> throw new IllegalArgumentException("there is no action " + action);
    }
    return motion;
  }

  private static ViewerMotion move(String[] words) {
    double[] numbers = new double[5];
    for (int i = 0; i < words.length; i++) {
      numbers[i] = Double.parseDouble(words[i]);
    }
    return (viewer, time, dt) -> {
      viewer.moveTo(new Vector3d(numbers[0], numbers[1], numbers[2]));
      if (words.length > 3) {
        viewer.turnTo(
            Viewer.orientation(Math.toRadians(numbers[3]), Math.toRadians(numbers[4]), 0));
      }
    };
  }

  private static KeyboardEvent.Key key(String name) {
    for (KeyboardEvent.Action action : KeyboardEvent.Action.values()) {
      if (action.name().equals(name)) {
        return action;
      }
    }
    for (KeyboardEvent.Modifier modifier : KeyboardEvent.Modifier.values()) {
      if (modifier.name().equals(name)) {
        return modifier;
      }
    }
    return new KeyboardEvent.Character(
        switch (name) {
          case "ENTER" -> KeyboardEvent.ENTER;
          case "BACKSPACE" -> KeyboardEvent.BACKSPACE;
          case "SPACE" -> " ";
          default -> name;
        });
  }

  private void point(String[] words) {
    pressed = words.length > 2 ? words[2].equals("down") : pressed;
    double half = Math.tan(world.viewer().fieldOfView() / 2);
    double right = (2 * Double.parseDouble(words[0]) - 1) * half;
    double up = (1 - 2 * Double.parseDouble(words[1])) * half;
    world.point(new PointingDeviceState(Optional.of(new Vector3d(right, up, -1)), pressed));
  }

  private void set(String nodeAndField, String text) {
    Node node = node(nodeAndField);
    FieldDefinition field = field(node, nodeAndField);
    @Nullable Object value =
        FieldValueFormat.of(field.type(), text, name -> find(name).orElseThrow());
    world.post(() -> world.cascade().send(node, field.index(), value));
  }

  @Override
  public void close() {
    loader.close();
  }
}
