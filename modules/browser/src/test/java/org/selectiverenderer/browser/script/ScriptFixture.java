package org.selectiverenderer.browser.script;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.atomic.AtomicLong;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.browser.loading.LoadedScene;
import org.selectiverenderer.browser.loading.RunningSceneLoader;
import org.selectiverenderer.browser.loading.SceneLoader;
import org.selectiverenderer.browser.nodes.NodeFactory;
import org.selectiverenderer.browser.nodes.script.ScriptNode;
import org.selectiverenderer.browser.scene.EventCascade;
import org.selectiverenderer.browser.scene.Node;
import org.selectiverenderer.browser.scene.Scene;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.source.ReadLimits;

/** A scene of Scripts that have no world around them. */
final class ScriptFixture implements ScriptHost, AutoCloseable {
  private final ProblemCollector problems = new ProblemCollector();
  private final EventCascade cascade = new EventCascade(problems);
  private final SceneLoader loader =
      new SceneLoader(NodeCatalogue.load(), new NodeFactory(), ReadLimits.standard(), problems);
  private final LoadedScene loaded;
  private final RunningSceneLoader files;
  private final List<ScriptNode> nodes;
  private final ScriptScheduler scripts;

  /** Creates a scene under the limits of the program, which {@link #countedLimits} measures. */
  ScriptFixture(String body) throws IOException {
    this(body, countedLimits(1, 5, ScriptLimits.standard().bytes()));
  }

  ScriptFixture(String body, ScriptLimits limits) throws IOException {
    this(body, limits, new ScriptTimeBudget());
  }

  ScriptFixture(String body, ScriptLimits limits, ScriptTimeBudget budget) throws IOException {
    scripts = new ScriptScheduler(this, budget, limits);
    String text = "<X3D version='4.0' profile='Full'><Scene>\n" + body + "</Scene></X3D>";
    loaded =
        loader.load(
            "test.x3d",
            new ByteArrayInputStream(text.getBytes(StandardCharsets.UTF_8)),
            Path.of("no-such-folder"));
    files = new RunningSceneLoader(loaded, problems, Runnable::run, built -> {});
    nodes =
        loaded.scene().root().nodes("children").stream()
            .filter(ScriptNode.class::isInstance)
            .map(ScriptNode.class::cast)
            .toList();
    cascade.at(1000);
    scripts.watch(nodes);
    scripts.start();
  }

  /**
   * Returns limits that measure work instead of time, so that a busy machine changes nothing: their
   * clock advances by 0.1 ms whenever it is read, which is at least once for 10,000 instructions of
   * a script.
   */
  static ScriptLimits countedLimits(double callSeconds, double startSeconds, long bytes) {
    AtomicLong readings = new AtomicLong();
    return new ScriptLimits(
        callSeconds, startSeconds, bytes, () -> readings.incrementAndGet() * 100_000);
  }

  ScriptScheduler scripts() {
    return scripts;
  }

  void go(int value) {
    go(0, value);
  }

  void go(int script, int value) {
    Node node = nodes.get(script);
    cascade.send(node, node.type().indexOf("go"), value);
  }

  Object out() {
    return out(0);
  }

  Object out(int script) {
    Node node = nodes.get(script);
    return node.value(node.type().indexOf("out"));
  }

  /** Returns the value of a field of the node of that DEF name. */
  Object value(String name, String field) {
    Node node = loaded.scene().find(name).orElseThrow();
    return node.value(node.type().indexOf(field));
  }

  List<String> told() {
    return problems.list().stream().map(Problem::toString).toList();
  }

  @Override
  public EventCascade cascade() {
    return cascade;
  }

  @Override
  public ProblemCollector problems() {
    return problems;
  }

  @Override
  public Scene scene() {
    return loaded.scene();
  }

  @Override
  public RunningSceneLoader files() {
    return files;
  }

  @Override
  public void show(LoadedScene scene) {
    throw new AssertionError("no script asks for another scene");
  }

  @Override
  public void follow(ScriptNode script, String[] urls) {
    throw new AssertionError("no script follows a link");
  }

  @Override
  public void close() {
    loader.close();
  }
}
