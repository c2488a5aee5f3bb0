package org.selectiverenderer.browser.script;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.util.List;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;

/** Scripts without a world around them: when they are called, and what becomes of bad ones. */
class ScriptSchedulerTest {
  private static final String GO =
      "<Script><field name='go' type='SFInt32' accessType='inputOnly'/>"
          + "<field name='out' type='SFString' accessType='outputOnly'/>"
          + "<![CDATA[ecmascript: %s ]]></Script>\n";

  @Test
  void scriptsAtRestAreNotCalled() throws IOException {
    String resting =
        GO.formatted("function go(v) { out = 'v' + v; } function eventsProcessed() {}");
    try (ScriptFixture scene = new ScriptFixture(resting.repeat(1000))) {
      long before = scene.scripts().calls();
      for (int frame = 0; frame < 100; frame++) {
        scene.scripts().prepare(frame, new Vector3d());
        scene.scripts().finish();
      }
      assertThat(scene.scripts().calls()).isEqualTo(before);

      scene.go(3);
      assertThat(scene.scripts().finish()).isTrue();
      assertThat(scene.out()).isEqualTo("v3");
      assertThat(scene.scripts().calls()).isEqualTo(before + 2);
    }
  }

  @Test
  void scriptThatFailsAgainAndAgainIsSwitchedOff() throws IOException {
    try (ScriptFixture scene =
        new ScriptFixture(GO.formatted("function go(v) { out = 'v' + v; throw 'no'; }"))) {
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
    try (ScriptFixture scene = new ScriptFixture(GO.formatted(code))) {
      scene.go(60);
      assertThat(scene.told()).hasSize(51);
      assertThat(scene.told().get(0)).isEqualTo("test.x3d:2:1: Script prints: line 0");
      assertThat(scene.told().get(50)).contains("scripts have printed 50 lines");
      assertThat(scene.problems().any()).isFalse();
    }
  }

  @Test
  void shutdownIsCalledWhenAScriptLeavesTheScene() throws IOException {
    try (ScriptFixture scene =
        new ScriptFixture(GO.formatted("function shutdown() { out = 'bye'; }"))) {
      scene.scripts().watch(List.of());

      assertThat(scene.out()).isEqualTo("bye");
    }
  }

  @Test
  void scriptsThatWriteToEachOtherEndlesslyAreEnded() throws IOException {
    String code = "function go(v) { me.go = v + 1; out = 'v' + v; }";
    String self =
        "<Script DEF='S' directOutput='true'>"
            + "<field name='me' type='SFNode' accessType='initializeOnly'><Script USE='S'/></field>";
    try (ScriptFixture scene = new ScriptFixture(GO.replace("<Script>", self).formatted(code))) {
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
    try (ScriptFixture one = new ScriptFixture(GO.formatted(code));
        ScriptFixture other = new ScriptFixture(GO.formatted(code))) {
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
            attempt(function () { new MFFloat().length = 1e9; }),
            attempt(function () { [1, 2].map(function (x) { return x; }); }),
            typeof Float64Array, typeof BigInt].join(' ');
        }""";
    try (ScriptFixture scene = new ScriptFixture(GO.formatted(code))) {
      scene.go(1);

      assertThat(scene.told()).isEmpty();
      assertThat(scene.out())
          .isEqualTo("RangeError RangeError RangeError done undefined undefined");
    }
  }

  @Test
  void promisesAreKeptBeforeACallEnds() throws IOException {
    String code = "function go(v) { Promise.resolve(v).then(function (w) { out = 'v' + w; }); }";
    try (ScriptFixture scene = new ScriptFixture(GO.formatted(code))) {
      scene.go(3);

      assertThat(scene.out()).isEqualTo("v3");
    }
  }

  @Test
  void deepCallsAreErrorsOfTheScript() throws IOException {
    try (ScriptFixture scene = new ScriptFixture(GO.formatted("function go() { go(); }"))) {
      scene.go(1);

      assertThat(scene.told()).singleElement().asString().contains("maximum stack depth");
    }
  }
}
