package org.selectiverenderer.browser.script;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
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

/** Scripts without a world around them: when they are called, and what becomes of bad ones. */
class ScriptSchedulerTest {
  private static final String GO =
      "<Script><field name='go' type='SFInt32' accessType='inputOnly'/>"
          + "<field name='out' type='SFString' accessType='outputOnly'/>"
          + "<![CDATA[ecmascript: %s ]]></Script>\n";

  /** A scene of Scripts. */
  private static final class Fixture implements ScriptHost, AutoCloseable {
    private final ProblemCollector problems = new ProblemCollector();
    private final EventCascade cascade = new EventCascade(problems);
    private final SceneLoader loader =
        new SceneLoader(NodeCatalogue.load(), new NodeFactory(), ReadLimits.standard(), problems);
    private final LoadedScene loaded;
    private final RunningSceneLoader files;
    private final List<ScriptNode> nodes;
    private final ScriptScheduler scripts = new ScriptScheduler(this);

    Fixture(String body) throws IOException {
      String text = "<X3D version='4.0' profile='Full'><Scene>\n" + body + "</Scene></X3D>";
      loaded =
          loader.load(
              "test.x3d",
              new ByteArrayInputStream(text.getBytes(StandardCharsets.UTF_8)),
              Path.of("no-such-folder"));
      files = new RunningSceneLoader(loaded, problems, Runnable::run);
      nodes =
          loaded.scene().root().nodes("children").stream()
              .filter(ScriptNode.class::isInstance)
              .map(ScriptNode.class::cast)
              .toList();
      cascade.at(1000);
      scripts.watch(nodes);
      scripts.start();
    }

    void go(int value) {
      Node node = nodes.get(0);
      cascade.send(node, node.type().indexOf("go"), value);
    }

    Object out() {
      Node node = nodes.get(0);
      return node.value(node.type().indexOf("out"));
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

  @Test
  void scriptsAtRestAreNotCalled() throws IOException {
    String resting =
        GO.formatted("function go(v) { out = 'v' + v; } function eventsProcessed() {}");
    try (Fixture scene = new Fixture(resting.repeat(1000))) {
      long before = scene.scripts.calls();
      for (int frame = 0; frame < 100; frame++) {
        scene.scripts.prepare(frame, new Vector3d());
        scene.scripts.finish();
      }
      assertThat(scene.scripts.calls()).isEqualTo(before);

      scene.go(3);
      assertThat(scene.scripts.finish()).isTrue();
      assertThat(scene.out()).isEqualTo("v3");
      assertThat(scene.scripts.calls()).isEqualTo(before + 2);
    }
  }

  @Test
  void scriptThatFailsAgainAndAgainIsSwitchedOff() throws IOException {
    try (Fixture scene =
        new Fixture(GO.formatted("function go(v) { out = 'v' + v; throw 'no'; }"))) {
      for (int i = 1; i <= 30; i++) {
        scene.go(i);
      }
      assertThat(scene.out()).isEqualTo("v20");
      assertThat(scene.told())
          .containsExactly(
              "test.x3d:2:133: Script: no",
              "test.x3d:2:133: Script: it has failed 20 times; the Script is switched off");
    }
  }

  @Test
  void printsAreLimited() throws IOException {
    String code = "function go(v) { for (var i = 0; i < v; i++) print('line', i); }";
    try (Fixture scene = new Fixture(GO.formatted(code))) {
      scene.go(60);
      assertThat(scene.told()).hasSize(51);
      assertThat(scene.told().get(0)).isEqualTo("test.x3d:2:1: Script prints: line 0");
      assertThat(scene.told().get(50)).contains("scripts have printed 50 lines");
      assertThat(scene.problems.any()).isFalse();
    }
  }

  @Test
  void shutdownIsCalledWhenAScriptLeavesTheScene() throws IOException {
    try (Fixture scene = new Fixture(GO.formatted("function shutdown() { out = 'bye'; }"))) {
      scene.scripts.watch(List.of());

      assertThat(scene.out()).isEqualTo("bye");
    }
  }

  @Test
  void scriptsThatWriteToEachOtherEndlesslyAreEnded() throws IOException {
    String code = "function go(v) { me.go = v + 1; out = 'v' + v; }";
    String self =
        "<Script DEF='S' directOutput='true'>"
            + "<field name='me' type='SFNode' accessType='initializeOnly'><Script USE='S'/></field>";
    try (Fixture scene = new Fixture(GO.replace("<Script>", self).formatted(code))) {
      scene.go(1);

      assertThat(scene.told())
          .singleElement()
          .asString()
          .contains("triggered each other endlessly");
    }
  }

  @Test
  void timeAndChanceAreTheScenes() throws IOException {
    String code =
        "function go() { out = [Date.now(), new Date().getTime(), new Date(5).getTime(), "
            + "Math.random()].join(' '); }";
    try (Fixture one = new Fixture(GO.formatted(code));
        Fixture other = new Fixture(GO.formatted(code))) {
      one.go(1);
      other.go(1);

      assertThat((String) one.out()).startsWith("1000000 1000000 5 0.");
      assertThat(other.out()).isEqualTo(one.out());
    }
  }

  @Test
  void largeThingsAreRefusedBeforeTheyAreMade() throws IOException {
    String code =
        """
        function attempt(f) { try { f(); return 'done'; } catch (e) { return e.name; } }
        function go() {
          out = [
            attempt(function () { 'x'.repeat(1e9); }),
            attempt(function () { 'x'.padEnd(1e9); }),
            attempt(function () { Array.from({length: 4e9}); }),
            attempt(function () { var a = []; a.length = 4e9; a.indexOf(1); }),
            attempt(function () { new MFFloat().length = 1e9; }),
            attempt(function () { [1, 2].map(function (x) { return x; }); }),
            typeof Float64Array, typeof BigInt].join(' ');
        }""";
    try (Fixture scene = new Fixture(GO.formatted(code))) {
      scene.go(1);

      assertThat(scene.out())
          .isEqualTo(
              "RangeError RangeError RangeError RangeError RangeError done undefined undefined");
    }
  }

  @Test
  void deepCallsAreErrorsOfTheScript() throws IOException {
    try (Fixture scene = new Fixture(GO.formatted("function go() { go(); }"))) {
      scene.go(1);

      assertThat(scene.told()).singleElement().asString().contains("maximum stack depth");
    }
  }
}
